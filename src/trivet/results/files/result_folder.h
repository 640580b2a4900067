// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "trivet/foundation/files.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/results/files/result_manifest.h"

namespace trivet::results {

/// A result folder that is being written: files go to a temporary folder next to the target, which replaces the target
/// in one step when `publish` is called; without it, everything written is removed again. Files of an earlier result
/// (listed in its manifest) are removed, everything else in the target stays. Only one process at a time publishes to
/// the same target (docs/decisions/result-folders.md).
class ResultFolder {
 public:
  /// @param folders  names of the folders that the result will have, "00-base"
  /// @throws std::runtime_error if the target is a link or a file, contains something but no manifest, or needs a name
  /// that the user uses for something else; or if it is not writable
  ResultFolder(const std::filesystem::path& target, const std::vector<std::string>& folders);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Writes one file; `name` may include a folder. @throws std::runtime_error with the reason (a full disk, for
  /// instance)
  void write(const std::string& name, const std::string& content);
  /// Replaces the target by the result. @returns notes for the user: files of theirs that were renamed
  [[nodiscard]] std::vector<std::string> publish();

 private:
  static constexpr const char* new_result = "new";

  void make_parents();
  void remove_parents();
  void check(const foundation::FolderHandle& parent, const std::vector<std::string>& folders);

  std::filesystem::path target_;  ///< absolute
  std::list<foundation::RegisteredFolder> made_parents_;
  bool one_by_one_ = false;  ///< a mount point cannot be exchanged with another folder
  std::unique_ptr<foundation::TemporaryFolder> temporary_;
  foundation::FolderHandle working_;  ///< new_result in the temporary folder
  ResultManifest manifest_;
  bool published_ = false;
};

}  // namespace trivet::results
