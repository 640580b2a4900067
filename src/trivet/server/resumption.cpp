// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/resumption.h"

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

/// Closed if there is no folder that only this user can read.
FolderHandle private_folder() {
  const char* given = std::getenv("XDG_RUNTIME_DIR");
  if (!given || *given != '/') return {};
  const FolderHandle runtime{fs::path(given)};
  struct stat status{};
  const bool is_private = runtime.is_open() && fstat(runtime.descriptor(), &status) == 0 &&
      status.st_uid == geteuid() && (status.st_mode & (S_IRWXG | S_IRWXO)) == 0;
  return is_private ? runtime.made_folder("trivet") : FolderHandle();
}

std::string file_name(const std::string& project_file) {
  std::error_code error;
  const fs::path found = project_file.empty() ? fs::path() : fs::weakly_canonical(project_file, error);
  return "page-" + sha256(found.string()).substr(0, 32);
}

}  // namespace

Resumption last_resumption(const std::string& project_file) {
  Resumption found{0, new_token()};
  const FolderHandle folder = private_folder();
  if (!folder.is_open()) return found;
  const std::string text = folder.content(file_name(project_file), longest_file).value_or("");
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end == text.data() + text.size() || *end != ' ') return found;
  const std::string key(end + 1, text.data() + text.size());
  if (key.size() != key_length || key.find_first_not_of(hexadecimal) != std::string::npos) return found;
  return {port, key};
}

void keep(const Resumption& resumption, const std::string& project_file) {
  const FolderHandle folder = private_folder();
  if (!folder.is_open()) return;
  const std::string name = file_name(project_file), draft = fmt::format("{}.{}", name, getpid());
  try {
    unlinkat(folder.descriptor(), draft.c_str(), 0);  // of a start that was ended while it wrote
    foundation::write_new_file(folder, draft, fmt::format("{} {}", resumption.port, resumption.key), draft);
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
