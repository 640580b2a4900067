// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/foundation/files.h"
#include "trivet/study/shared/part_file.h"
#include "trivet/study/shared/study_manifest.h"

namespace trivet::study {

inline constexpr const char* manifest_file = "study.txt";

/// A folder in which any number of processes keep what they have counted: a manifest, and one file of each part.
class StudyFolder {
 public:
  /// What all parts have together. A chunk is in at most one of `parts`.
  struct Content {
    std::vector<std::pair<StudyPart, PartRecord>> parts;
    ChunkSet chunks;
    std::vector<std::string> damaged;      ///< names of files that are not read
    std::vector<std::string> overlapping;  ///< names of files that share chunks with others; not in `parts`
  };

  /// Creates the folder if there is none. @throws foundation::InvalidInput if it cannot, or has other files
  [[nodiscard]] static StudyFolder made(const std::filesystem::path& path);
  /// @throws foundation::InvalidInput if there is no study in it
  [[nodiscard]] static StudyFolder found(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const foundation::FolderHandle& handle() const { return handle_; }

  /// Empty if there is none, or it is damaged.
  [[nodiscard]] std::optional<StudyManifest> manifest() const;
  [[nodiscard]] bool has_manifest() const;
  /// Writes the manifest, unless another process has done so meanwhile. @returns the one of the folder
  /// @throws foundation::InvalidInput if parts are of another study, or nothing says that a damaged one is of this
  [[nodiscard]] StudyManifest with_manifest(const StudyManifest& manifest) const;

  /// @throws foundation::InvalidInput that says what differs, if the folder is of another study
  void check_identity(const StudyIdentity& identity) const;

  /// Parts of this study. Of files with the same chunks, those with the most count.
  /// @param chunks  of the whole study  @throws foundation::InvalidInput if a part is of another study
  [[nodiscard]] Content content(const StudyManifest& manifest, std::uint64_t chunks) const;
  /// @throws foundation::InvalidInput if processes share the study in another number of parts now
  void check_number_of_parts(std::uint64_t of) const;

 private:
  StudyFolder(std::filesystem::path path, foundation::FolderHandle handle)
      : path_(std::move(path)), handle_(std::move(handle)) {}
  /// Of a folder without a readable manifest, that its parts are of this study.
  void check_parts_without(const StudyManifest& manifest) const;
  /// Parts with a file, in the order of their numbers.
  [[nodiscard]] std::vector<StudyPart> parts() const;

  std::filesystem::path path_;
  foundation::FolderHandle handle_;
};

}  // namespace trivet::study
