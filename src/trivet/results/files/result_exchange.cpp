// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/result_exchange.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "trivet/foundation/files.h"
#include "trivet/results/files/users_files.h"

namespace trivet::results {
namespace {

using EntryKind = foundation::FolderHandle::Kind;

constexpr const char* manifest_of_both = "manifest-of-both.json";  // only in the folder of the new result

void require(bool success, const std::string& name) {
  if (!success) throw std::runtime_error(fmt::format("cannot replace {}: {}", name, std::strerror(errno)));
}

/// The folder of a path in a result ("00-base" of "00-base/modes.csv"), and the name in it.
struct Place {
  std::string folder, name;
  explicit Place(const std::string& path)
      : folder(path.substr(0, path.find('/') == std::string::npos ? 0 : path.find('/'))),
        name(folder.empty() ? path : path.substr(folder.size() + 1)) {}
};

void put_aside(const std::string& path, const foundation::FolderHandle& folder, const std::string& name, bool listed,
               std::vector<std::string>& notes) {
  const std::string free = kept_name(name, folder, folder);
  require(renameat(folder.descriptor(), name.c_str(), folder.descriptor(), free.c_str()) == 0, path);
  notes.push_back(kept_words(path, free, listed));
}

void put_in_place(const std::string& path, const ResultExchange& exchange, std::vector<std::string>& notes) {
  const Place place(path);
  foundation::FolderHandle from_inner, to_inner;
  if (!place.folder.empty()) {
    const EntryKind kind = exchange.current.kind(place.folder);
    if (kind != EntryKind::none && kind != EntryKind::folder)
      put_aside(place.folder, exchange.current, place.folder, false, notes);
    from_inner = exchange.next.folder(place.folder);
    to_inner = exchange.current.made_folder(place.folder);
    require(from_inner.is_open() && to_inner.is_open(), path);
  }
  const foundation::FolderHandle& from = place.folder.empty() ? exchange.next : from_inner;
  const foundation::FolderHandle& to = place.folder.empty() ? exchange.current : to_inner;
  const bool free = to.kind(place.name) == EntryKind::none ||
      (to.kind(place.name) == EntryKind::file && exchange.ours.is_ours(path, to, place.name));
  if (!free) put_aside(path, to, place.name, exchange.ours.names(path), notes);
  require(renameat(from.descriptor(), place.name.c_str(), to.descriptor(), place.name.c_str()) == 0, path);
}

void remove_from(const foundation::FolderHandle& current, const std::string& path, const ResultManifest& ours) {
  const Place place(path);
  const foundation::FolderHandle inner =
      place.folder.empty() ? foundation::FolderHandle() : current.folder(place.folder);
  const foundation::FolderHandle& folder = place.folder.empty() ? current : inner;
  if (folder.kind(place.name) == EntryKind::file && ours.is_ours(path, folder, place.name))
    unlinkat(folder.descriptor(), place.name.c_str(), 0);
  if (!place.folder.empty())
    unlinkat(current.descriptor(), place.folder.c_str(), AT_REMOVEDIR);  // fails if the user has files in it
}

}  // namespace

bool exchange_folders(const ResultExchange& exchange, const foundation::FolderHandle& next_place,
                      const std::string& next_name, const foundation::FolderHandle& place, const std::string& name,
                      std::vector<std::string>& notes) {
  UsersFiles users(exchange.current, exchange.ours);
  if (!users.link_into(exchange.next)) return false;
  struct stat status;
  if (fstat(exchange.current.descriptor(), &status) == 0) {
    static_cast<void>(!fchown(exchange.next.descriptor(), status.st_uid, status.st_gid));
    fchmod(exchange.next.descriptor(), status.st_mode & 07777);
  }
  if (renameat2(next_place.descriptor(), next_name.c_str(), place.descriptor(), name.c_str(), RENAME_EXCHANGE) != 0) {
    require(errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP, name);
    return false;
  }
  const bool complete = users.move_latecomers_into(exchange.next);
  notes.insert(notes.end(), users.notes().begin(), users.notes().end());
  if (!complete)
    throw std::runtime_error(fmt::format("{} is replaced, but files created in it meanwhile could not be moved", name));
  return true;
}

void replace_one_by_one(const ResultExchange& exchange, std::vector<std::string>& notes) {
  ResultManifest both = exchange.ours;
  both.add(exchange.next_ours);
  foundation::write_new_file(exchange.next, manifest_of_both, both.text(), manifest_name);
  require(renameat(exchange.next.descriptor(), manifest_of_both, exchange.current.descriptor(), manifest_name) == 0,
          manifest_name);
  for (const auto& [path, content] : exchange.next_ours.files()) put_in_place(path, exchange, notes);
  for (const auto& [path, content] : exchange.ours.files())
    if (!exchange.next_ours.names(path)) remove_from(exchange.current, path, exchange.ours);
  require(renameat(exchange.next.descriptor(), manifest_name, exchange.current.descriptor(), manifest_name) == 0,
          manifest_name);
}

}  // namespace trivet::results
