// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/users_files.h"
#include "trivet/foundation/plain_text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stdexcept>

namespace trivet::results {
namespace {

using FileKind = foundation::FolderHandle::Kind;

constexpr std::size_t longest_stem = 200, longest_extension = 30;  // names have at most 255 bytes
constexpr int most_kept = 10000;

std::string inside(const std::string& path, const std::string& name) { return path.empty() ? name : path + "/" + name; }

/// Copies rights, owner and times of a folder of the user. Only the superuser may change the owner; for others it is
/// already right.
void copy_rights(const foundation::FolderHandle& from, const foundation::FolderHandle& to) {
  struct stat status;
  if (fstat(from.descriptor(), &status) != 0) return;
  static_cast<void>(!fchown(to.descriptor(), status.st_uid, status.st_gid));
  fchmod(to.descriptor(), status.st_mode & 07777);
  const timespec times[2] = {status.st_atim, status.st_mtim};
  futimens(to.descriptor(), times);
}

}  // namespace

std::string kept_name(const std::string& name, const foundation::FolderHandle& one,
                      const foundation::FolderHandle& other) {
  const std::filesystem::path path(name);
  const std::string stem = foundation::shortened(path.stem().string(), longest_stem),
                    extension = path.extension().string();
  for (int i = 1; i <= most_kept; ++i) {
    const std::string free =
        fmt::format("{}.kept-{}{}", stem, i, extension.size() > longest_extension ? "" : extension);
    if (one.kind(free) == FileKind::none && other.kind(free) == FileKind::none) return free;
  }
  throw std::runtime_error(fmt::format("{}: found no free name to keep it under; move it away", name));
}

std::string kept_words(const std::string& path, const std::string& new_name, bool listed) {
  const std::string new_path = (std::filesystem::path(path).parent_path() / new_name).string();
  return fmt::format(
      "{} {}; it is kept as {}", path,
      listed ? "was changed since trivet wrote it" : "was not written by trivet, and its name was needed", new_path);
}

bool UsersFiles::link_into(const foundation::FolderHandle& next) { return link("", earlier_, next); }

bool UsersFiles::link(const std::string& path, const foundation::FolderHandle& from,
                      const foundation::FolderHandle& to) {
  if (!from.is_open() || !to.is_open()) return false;  // no permission to read it: the other method reports the path
  for (const std::string& name : from.names()) {
    const std::string whole = inside(path, name);
    const FileKind kind = from.kind(name);
    if (kind == FileKind::folder && to.kind(name) == FileKind::folder) {  // in both: a case of both results
      if (!link(whole, from.folder(name), to.folder(name))) return false;
      continue;
    }
    if (kind == FileKind::file && ours_.is_ours(whole, from, name)) continue;
    std::string new_name = name;
    if (to.kind(name) != FileKind::none) {
      new_name = kept_name(name, from, to);
      notes_.push_back(kept_words(whole, new_name, ours_.names(whole)));
      new_names_[whole] = new_name;
    }
    const bool done = kind == FileKind::folder
        ? link_folder(whole, new_name, from.folder(name), to)
        : linkat(from.descriptor(), name.c_str(), to.descriptor(), new_name.c_str(), 0) == 0;
    if (!done) return false;
  }
  return true;
}

bool UsersFiles::link_folder(const std::string& path, const std::string& name, const foundation::FolderHandle& from,
                             const foundation::FolderHandle& to) {
  if (!from.is_open()) return false;
  const foundation::FolderHandle made = to.made_folder(name);
  if (!made.is_open() || !link(path, from, made)) return false;
  if (ours_.names_folder(path)) {  // a case that no longer exists: its folder stays only if the user has files in it
    unlinkat(to.descriptor(), name.c_str(), AT_REMOVEDIR);
    return true;
  }
  copy_rights(from, made);
  return true;
}

bool UsersFiles::move_latecomers_into(const foundation::FolderHandle& current) { return move("", earlier_, current); }

bool UsersFiles::move(const std::string& path, const foundation::FolderHandle& from,
                      const foundation::FolderHandle& to) {
  if (!from.is_open() || !to.is_open()) return false;
  bool complete = true;
  for (const std::string& name : from.names()) {
    const std::string whole = inside(path, name);
    const auto renamed = new_names_.find(whole);
    const std::string new_name = renamed == new_names_.end() ? name : renamed->second;
    const FileKind kind = from.kind(name);
    if (kind == FileKind::folder && to.kind(new_name) == FileKind::folder) {
      complete = move(whole, from.folder(name), to.folder(new_name)) && complete;
      continue;
    }
    const bool done_with =
        (kind == FileKind::file && ours_.is_ours(whole, from, name)) || from.is_same_file(name, to, new_name);
    if (done_with || (kind == FileKind::folder && ours_.names_folder(whole) && from.folder(name).names().empty()))
      continue;
    if (kind == FileKind::folder && ours_.names_folder(whole)) {
      complete = move(whole, from.folder(name), to.made_folder(name)) && complete;
      if (to.folder(name).names().empty()) unlinkat(to.descriptor(), name.c_str(), AT_REMOVEDIR);
      continue;
    }
    std::string free = new_name;
    if (to.kind(free) != FileKind::none) {
      free = kept_name(name, from, to);
      notes_.push_back(kept_words(whole, free, ours_.names(whole)));
    }
    complete =
        renameat2(from.descriptor(), name.c_str(), to.descriptor(), free.c_str(), RENAME_NOREPLACE) == 0 && complete;
  }
  return complete;
}

}  // namespace trivet::results
