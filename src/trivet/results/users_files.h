// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "trivet/foundation/folder_handle.h"
#include "trivet/results/result_manifest.h"

namespace trivet::results {

/// What a result folder holds and Trivet did not write, or the user has edited since, on its way into the next result.
class UsersFiles {
 public:
  /// @param earlier   the folder that is in place  @param ours  its manifest
  UsersFiles(const foundation::FolderHandle& earlier, const ResultManifest& ours) : earlier_(earlier), ours_(ours) {}

  /// Gives every file a second name (a hard link) in the new result, and makes its folders there. The earlier folder
  /// stays as it is. A file whose name the new result needs is called NAME.kept-1 there. @returns false if the file
  /// system cannot do that for one of them
  [[nodiscard]] bool link_into(const foundation::FolderHandle& next);
  /// Moves what has come into the earlier folder since then into the result that is now in place. @returns false if
  /// something stayed behind
  [[nodiscard]] bool move_latecomers_into(const foundation::FolderHandle& current);

  /// One sentence for each file that got another name.
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

/// "modes.kept-1.csv": a name that is free in both folders.
[[nodiscard]] std::string kept_name(const std::string& name, const foundation::FolderHandle& one,
                                    const foundation::FolderHandle& other);

/// The sentence about a file that got another name. @param listed  whether the manifest names it, so that the user has
/// edited it
[[nodiscard]] std::string kept_words(const std::string& path, const std::string& new_name, bool listed);

}  // namespace trivet::results
