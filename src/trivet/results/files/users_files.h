// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "trivet/foundation/files.h"
#include "trivet/results/files/result_manifest.h"

namespace trivet::results {

/// Transfers files of the user, and Trivet's files that the user has edited, from a result folder to the next one.
class UsersFiles {
 public:
  /// @param earlier   the existing folder  @param ours  its manifest
  UsersFiles(const foundation::FolderHandle& earlier, const ResultManifest& ours) : earlier_(earlier), ours_(ours) {}

  /// Creates a hard link to every file in the new result, with its folders. The earlier folder stays unchanged. If the
  /// new result needs the name of a file, the file is named NAME.kept-1 there. @returns false if the file system cannot
  /// do this for one of them
  [[nodiscard]] bool link_into(const foundation::FolderHandle& next);
  /// Moves files created in the earlier folder since then into the current result. @returns false if one could not be
  /// moved
  [[nodiscard]] bool move_latecomers_into(const foundation::FolderHandle& current);

  /// One sentence for each renamed file.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  bool link(const std::string& path, const foundation::FolderHandle& from, const foundation::FolderHandle& to);
  bool link_folder(const std::string& path, const std::string& name, const foundation::FolderHandle& from,
                   const foundation::FolderHandle& to);
  bool move(const std::string& path, const foundation::FolderHandle& from, const foundation::FolderHandle& to);

  const foundation::FolderHandle& earlier_;
  const ResultManifest& ours_;
  std::map<std::string, std::string> new_names_;  ///< by path: the name in the new folder
  std::vector<std::string> notes_;
};

/// "modes.kept-1.csv": a name that is unused in both folders.
[[nodiscard]] std::string kept_name(const std::string& name, const foundation::FolderHandle& one,
                                    const foundation::FolderHandle& other);

/// The sentence about a renamed file. @param listed  the manifest lists it, so the user has edited it
[[nodiscard]] std::string kept_words(const std::string& path, const std::string& new_name, bool listed);

}  // namespace trivet::results
