// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/result_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "trivet/foundation/files.h"
#include "trivet/results/files/folder_lock.h"
#include "trivet/results/files/result_exchange.h"

namespace trivet::results {
namespace {

namespace fs = std::filesystem;
using FileKind = foundation::FolderHandle::Kind;

constexpr const char* advice = "choose another folder with -o";

[[noreturn]] void refuse(const fs::path& target, const std::string& reason) {
  throw std::runtime_error(fmt::format("{} {}; {}", target.string(), reason, advice));
}

[[noreturn]] void refuse_writing(const fs::path& target, const std::string& reason) {
  throw std::runtime_error(fmt::format("{} cannot be created: {}; {}", target.string(), reason, advice));
}

/// Absolute path of the target that ends in a name, so that it can be addressed from its parent folder.
fs::path absolute_target(const fs::path& given) {
  std::error_code error;
  fs::path target = fs::absolute(given, error);
  if (error)
    refuse(given, fmt::format("is relative to the current folder, which cannot be found ({})", error.message()));
  while (target.filename().empty() && target.has_relative_path()) target = target.parent_path();
  if (target.filename() == "." || target.filename() == "..") target = fs::canonical(target, error);
  if (error) refuse(given, fmt::format("cannot be found ({})", error.message()));
  if (!target.has_relative_path()) refuse(given, "is the root of the file system");
  return target;
}

/// Manifest of the existing folder: an empty one for an empty folder. @throws std::runtime_error if Trivet must not
/// replace the folder
ResultManifest earlier_result(const foundation::FolderHandle& folder, const fs::path& target) {
  if (!folder.is_open()) refuse(target, fmt::format("cannot be read ({})", std::strerror(errno)));
  if (const auto manifest = ResultManifest::read(folder)) return *manifest;
  const std::vector<std::string> names = folder.names();
  if (std::ranges::all_of(names,
                          [](const std::string& name) { return name.starts_with(foundation::temporary_name_start); }))
    return {};
  refuse(target,
         fmt::format("exists and is not an earlier result of trivet (no {} that lists its files)", manifest_name));
}

/// Kind of the file or folder at the target. @throws std::runtime_error for an error of the system
FileKind kind_at(const foundation::FolderHandle& parent, const fs::path& target) {
  struct stat status;
  if (fstatat(parent.descriptor(), target.filename().c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 && errno != ENOENT)
    refuse_writing(target, std::strerror(errno));
  return parent.kind(target.filename().string());
}

bool is_mount_point(const foundation::FolderHandle& folder, const foundation::FolderHandle& parent) {
  struct stat inner, outer;
  return fstat(folder.descriptor(), &inner) == 0 && fstat(parent.descriptor(), &outer) == 0 &&
      inner.st_dev != outer.st_dev;
}

}  // namespace

ResultFolder::ResultFolder(const fs::path& target, const std::vector<std::string>& folders)
    : target_(absolute_target(target)) {
  std::error_code error;
  if (fs::equivalent(target_, fs::current_path(error), error))
    refuse(target_, "is the current folder, which cannot be replaced");
  try {
    make_parents();
    const foundation::FolderHandle parent(target_.parent_path());
    if (!parent.is_open()) refuse_writing(target_, std::strerror(errno));
    check(parent, folders);
    temporary_ = std::make_unique<foundation::TemporaryFolder>(one_by_one_ ? target_ : target_.parent_path());
    working_ = foundation::FolderHandle(temporary_->path()).made_folder(new_result);
    if (!working_.is_open()) throw std::system_error(errno, std::generic_category());
  } catch (const std::system_error& reason) {
    remove_parents();
    refuse_writing(target_, reason.code().message());
  } catch (...) {
    remove_parents();
    throw;
  }
}

ResultFolder::~ResultFolder() {
  temporary_.reset();
  if (!published_) remove_parents();
}

void ResultFolder::make_parents() {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path folder = target_.parent_path(); !fs::exists(folder, error) && folder.has_relative_path();
       folder = folder.parent_path()) {
    if (error && error != std::errc::no_such_file_or_directory) throw std::system_error(error);
    missing.push_back(folder);
  }
  for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
    const foundation::Undisturbed step;
    if (mkdir(folder->c_str(), 0777) == 0)
      made_parents_.emplace_back(*folder, foundation::RegisteredFolder::Removal::if_empty);
    else if (errno != EEXIST) throw std::system_error(errno, std::generic_category());
  }
}

void ResultFolder::remove_parents() {
  for (auto folder = made_parents_.rbegin(); folder != made_parents_.rend(); ++folder) rmdir(folder->path().c_str());
}

void ResultFolder::check(const foundation::FolderHandle& parent, const std::vector<std::string>& folders) {
  const FolderLock lock(parent, target_.parent_path());
  const FileKind kind = kind_at(parent, target_);
  if (kind == FileKind::none) return;
  if (kind == FileKind::link) refuse(target_, "is a symbolic link, which is neither followed nor replaced");
  if (kind != FileKind::folder) refuse(target_, fmt::format("is {}, not a folder", kind_name(kind)));
  const foundation::FolderHandle current = parent.folder(target_.filename().string());
  const ResultManifest ours = earlier_result(current, target_);
  for (const char* name : {"results.json", "report.html", manifest_name}) {
    const FileKind found = current.kind(name);
    if (found != FileKind::none && (found != FileKind::file || !ours.names(name)))
      refuse(target_ / name, fmt::format("is {} not written by trivet, and its name is needed", kind_name(found)));
  }
  for (const std::string& name : folders)
    if (const FileKind found = current.kind(name); found != FileKind::none && found != FileKind::folder)
      refuse(target_ / name, fmt::format("is {}, but the result needs a folder of this name", kind_name(found)));
  one_by_one_ = is_mount_point(current, parent);
}

void ResultFolder::write(const std::string& name, const std::string& content) {
  const fs::path path(name);
  foundation::FolderHandle inner;
  for (const fs::path& part : path.parent_path()) {
    inner = (inner.is_open() ? inner : working_).made_folder(part.string());
    if (!inner.is_open())
      throw std::runtime_error(fmt::format("cannot write {}: {}", (target_ / name).string(), std::strerror(errno)));
  }
  foundation::write_new_file(inner.is_open() ? inner : working_, path.filename().string(), content, target_ / name);
  if (name != manifest_name) manifest_.add(name, content);
}

std::vector<std::string> ResultFolder::publish() {
  write(manifest_name, manifest_.text());
  const std::string name = target_.filename().string();
  const foundation::FolderHandle parent(target_.parent_path()), temporary(temporary_->path());
  const FolderLock lock(parent, target_.parent_path());
  const foundation::Undisturbed step;
  std::vector<std::string> notes;
  const FileKind kind = kind_at(parent, target_);
  if (kind == FileKind::none && renameat(temporary.descriptor(), new_result, parent.descriptor(), name.c_str()) != 0)
    throw std::runtime_error(fmt::format("cannot create {}: {}", target_.string(), std::strerror(errno)));
  if (kind != FileKind::none) {
    if (kind != FileKind::folder) refuse(target_, fmt::format("has become {}", kind_name(kind)));
    const foundation::FolderHandle current = parent.folder(name);
    const ResultManifest ours = earlier_result(current, target_);
    const ResultExchange exchange{current, ours, working_, manifest_};
    if (one_by_one_ || !exchange_folders(exchange, temporary, new_result, parent, name, notes))
      replace_one_by_one(exchange, notes);
  }
  published_ = true;
  made_parents_.clear();
  if (!lock.is_held())
    notes.push_back(
        fmt::format("{}: this file system has no locks ({}); do not let two runs write there at the same time",
                    target_.parent_path().string(), lock.reason()));
  return notes;
}

}  // namespace trivet::results
