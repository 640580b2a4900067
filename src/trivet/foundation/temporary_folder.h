// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "trivet/foundation/leftovers.h"

namespace trivet::foundation {

/// The names of all temporary folders begin so.
inline constexpr std::string_view temporary_name_start = ".trivet-";

/// Removes what killed processes of this user have left of their temporary folders, in $TMPDIR or /tmp, or in a folder.
void remove_abandoned_folders();
void remove_abandoned_folders(const std::filesystem::path& parent);

/// A new folder for this owner only, under a name that cannot be guessed, removed with all it holds when the object
/// goes, whatever happened before. It holds one file, the owner's mark, on which this process keeps a lock; the next
/// temporary folder in the same place removes those whose owner was killed. On a file system without locks those stay.
class TemporaryFolder {
 public:
  /// In $TMPDIR, or in /tmp if that is not set. @throws std::runtime_error with reason and remedy if nothing can be
  /// made there
  TemporaryFolder();
  /// In a folder that exists. @throws std::system_error if nothing can be made there
  explicit TemporaryFolder(const std::filesystem::path& parent);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int mark_ = -1;  ///< file descriptor of the owner's mark
  std::optional<RegisteredFolder> registered_;
};

}  // namespace trivet::foundation
