// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/shared/study_folder.h"

#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "trivet/foundation/invalid_input.h"

namespace trivet::study {
namespace {

using foundation::FolderHandle;
using foundation::InvalidInput;
namespace fs = std::filesystem;

constexpr std::string_view unfinished_end = ".new";

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw InvalidInput(fmt::format("study folder {}: {}", path.string(), reason));
}

/// A file that a study writes.
bool is_of_study(std::string name) {
  if (name.ends_with(unfinished_end)) name.resize(name.size() - unfinished_end.size());
  return name == manifest_file || StudyPart::of_file(name).has_value();
}

FolderHandle opened(const fs::path& path) {
  FolderHandle handle(path);
  if (!handle.is_open()) refuse(path, errno == ENOTDIR ? "this is a file" : std::strerror(errno));
  return handle;
}

/// Lock on the folder for the moment in which its manifest is written; without locks there is none.
class FolderLock {
 public:
  explicit FolderLock(const FolderHandle& folder) : own_(folder.folder(".")) {
    while (flock(own_.descriptor(), LOCK_EX) != 0 && errno == EINTR) {
    }
  }

 private:
  FolderHandle own_;  ///< closing it releases the lock
};

}  // namespace

StudyFolder StudyFolder::made(const fs::path& path) {
  if (mkdir(path.c_str(), 0777) != 0 && errno != EEXIST)
    refuse(path, errno == ENOENT ? "the folder above it does not exist" : std::strerror(errno));
  StudyFolder folder(path, opened(path));
  if (folder.handle_.kind(manifest_file) == FolderHandle::Kind::none)
    for (const std::string& name : folder.handle_.names())
      if (!is_of_study(name))
        refuse(path, fmt::format("it has no study but other files, such as {}; name a new or an empty folder", name));
  return folder;
}

StudyFolder StudyFolder::found(const fs::path& path) {
  StudyFolder folder(path, opened(path));
  if (!folder.has_manifest()) refuse(path, fmt::format("there is no study in it: {} is missing", manifest_file));
  return folder;
}

bool StudyFolder::has_manifest() const { return handle_.kind(manifest_file) != FolderHandle::Kind::none; }

std::optional<StudyManifest> StudyFolder::manifest() const {
  const auto text = handle_.content(manifest_file, largest_part_file);
  return text ? StudyManifest::read(*text) : std::nullopt;
}

StudyManifest StudyFolder::with_manifest(const StudyManifest& manifest) const {
  const FolderLock lock(handle_);
  if (auto other = this->manifest()) return *other;
  check_parts_without(manifest);
  close(replaced_file(handle_, manifest_file, manifest.text(), path_ / manifest_file));
  return manifest;
}

void StudyFolder::check_parts_without(const StudyManifest& manifest) const {
  const std::string study = manifest.hash();
  bool any = false;
  for (const StudyPart& part : parts()) {
    const auto text = handle_.content(part.file_name(), largest_part_file);
    const auto record = text ? PartRecord::read(*text) : std::nullopt;
    if (record && record->study != study)
      refuse(path_,
             fmt::format("{} is {}, and {} is of another study; name another folder", manifest_file,
                         has_manifest() ? "damaged" : "missing", part.file_name()));
    any = any || record;
  }
  if (has_manifest() && !any)
    refuse(
        path_,
        fmt::format("{} is damaged, and no other file says what the study is of; name another folder", manifest_file));
}

std::vector<StudyPart> StudyFolder::parts() const {
  std::vector<StudyPart> found;
  for (const std::string& name : handle_.names())
    if (const auto part = StudyPart::of_file(name)) found.push_back(*part);
  std::ranges::sort(found, [](const StudyPart& one, const StudyPart& other) {
    return std::pair(one.of, one.number) < std::pair(other.of, other.number);
  });
  return found;
}

void StudyFolder::check_identity(const StudyIdentity& identity) const {
  const auto there = manifest();
  const std::string differences = there ? identity_differences(there->identity, identity) : "";
  if (!differences.empty())
    throw InvalidInput(
        fmt::format("study folder {} is of another study: {}; name another folder", path_.string(), differences));
}

StudyFolder::Content StudyFolder::content(const StudyManifest& manifest, std::uint64_t chunks) const {
  const std::string study = manifest.hash();
  std::vector<std::pair<StudyPart, PartRecord>> all;
  Content found{.chunks = ChunkSet(chunks)};
  for (const StudyPart& part : parts()) {
    const auto text = handle_.content(part.file_name(), largest_part_file);
    if (text && text->empty()) continue;  // its process has just begun
    auto record = text ? PartRecord::read(*text) : std::nullopt;
    if (record && record->study != study)
      refuse(path_,
             fmt::format("{} is of another study than {}; name another folder, or remove this file", part.file_name(),
                         manifest_file));
    if (record && record->chunks.chunks() == chunks) all.emplace_back(part, std::move(*record));
    else found.damaged.push_back(part.file_name());
  }
  std::ranges::stable_sort(all, std::ranges::greater(), [](const auto& one) { return one.second.chunks.size(); });
  for (auto& [part, record] : all) {
    if (found.chunks.overlaps(record.chunks)) {
      found.overlapping.push_back(part.file_name());
      continue;
    }
    found.chunks.add(record.chunks);
    found.parts.emplace_back(part, std::move(record));
  }
  return found;
}

void StudyFolder::check_number_of_parts(std::uint64_t of) const {
  for (const StudyPart& part : parts())
    if (part.of != of && is_worked_on(handle_, part))
      refuse(path_,
             fmt::format("a process works on part {} of {} now, so the study cannot be shared in {} part{}; wait, or "
                         "use the same number of parts",
                         part.number, part.of, of, of == 1 ? "" : "s"));
}

}  // namespace trivet::study
