// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/resumption.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "trivet/foundation/files.h"
#include "trivet/project/text/source_file.h"
#include "trivet/server/session_start.h"

namespace trivet::server {
namespace {

namespace fs = std::filesystem;
using foundation::FolderHandle;
using project::sha256;

constexpr std::size_t longest_file = 200;
constexpr std::size_t key_length = 64;
constexpr std::string_view hexadecimal = "0123456789abcdef";

using Log = std::function<void(const std::string&)>;

constexpr mode_t folder_mode = 0700, file_mode = 0600;

/// Whether this user alone has access; otherwise the log states what is wrong.
bool is_private(const struct stat& status, const fs::path& shown, mode_t needed, const Log& log) {
  const mode_t mode = status.st_mode & 07777U;
  if (status.st_uid == geteuid() && (mode & (S_IRWXG | S_IRWXO)) == 0) return true;
  if (log)
    log(fmt::format(
        "warning: {} has mode {:04o} and belongs to user {}; mode {:04o} of user {} is required for the key "
        "by which an open page goes on with this start; remove it or change it\n",
        shown.string(), mode, status.st_uid, needed, geteuid()));
  return false;
}

bool is_private(const FolderHandle& folder, const fs::path& shown, const Log& log) {
  struct stat status{};
  return folder.is_open() && fstat(folder.descriptor(), &status) == 0 && is_private(status, shown, folder_mode, log);
}

/// The folder of the keys: not open if there is none that this user alone can enter.
struct KeyFolder {
  fs::path path;
  FolderHandle handle;

  explicit KeyFolder(const Log& log = {}) {
    const char* given = std::getenv("XDG_RUNTIME_DIR");
    if (!given || *given != '/') return;
    const FolderHandle runtime{fs::path(given)};
    if (!is_private(runtime, given, log)) return;
    path = fs::path(given) / "trivet";
    FolderHandle made = runtime.made_folder("trivet", folder_mode);
    if (is_private(made, path, log)) handle = std::move(made);
  }
};

std::string file_name(const std::string& project_file) {
  std::error_code error;
  const fs::path found = project_file.empty() ? fs::path() : fs::weakly_canonical(project_file, error);
  return "page-" + sha256(found.string()).substr(0, 32);
}

}  // namespace

Resumption last_resumption(const std::string& project_file, const Log& log) {
  Resumption found{0, new_token()};
  const KeyFolder folder(log);
  const std::string name = file_name(project_file);
  struct stat status{};
  if (!folder.handle.is_open() ||
      fstatat(folder.handle.descriptor(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 ||
      !is_private(status, folder.path / name, file_mode, log))
    return found;
  const std::string text = folder.handle.content(name, longest_file).value_or("");
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end == text.data() + text.size() || *end != ' ') return found;
  const std::string key(end + 1, text.data() + text.size());
  if (key.size() != key_length || key.find_first_not_of(hexadecimal) != std::string::npos) return found;
  return {port, key};
}

void keep(const Resumption& resumption, const std::string& project_file) {
  const KeyFolder keys;
  const FolderHandle& folder = keys.handle;
  if (!folder.is_open()) return;
  const std::string name = file_name(project_file), draft = fmt::format("{}.{}", name, getpid());
  try {
    unlinkat(folder.descriptor(), draft.c_str(), 0);  // of a start that was ended while it wrote
    foundation::write_new_file(folder, draft, fmt::format("{} {}", resumption.port, resumption.key), draft, file_mode);
  } catch (const std::runtime_error&) {  // a full disk, for instance: pages cannot go on, everything else works
    return;
  }
  renameat(folder.descriptor(), draft.c_str(), folder.descriptor(), name.c_str());
}

SealedToken sealed_token(const std::string& token, const Resumption& resumption, const std::string& page_nonce,
                         const std::string& nonce) {
  const auto keyed = [&](const std::string& words) { return sha256(resumption.key + sha256(resumption.key + words)); };
  const std::string words = fmt::format("{} {} {}", resumption.port, page_nonce, nonce);
  const std::string mask = keyed("token " + words);
  std::string sealed = token;
  for (std::size_t i = 0; i < sealed.size(); ++i)
    sealed[i] = hexadecimal[hexadecimal.find(sealed[i]) ^ hexadecimal.find(mask[i])];
  return {nonce, sealed, keyed("proof " + words + " " + token)};
}

}  // namespace trivet::server
