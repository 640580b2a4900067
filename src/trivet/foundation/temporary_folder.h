// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "trivet/foundation/leftovers.h"

namespace trivet::foundation {

/// Prefix of the names of all temporary folders.
inline constexpr std::string_view temporary_name_start = ".trivet-";

/// Removes temporary folders that killed processes of this user left in $TMPDIR or /tmp, or in `parent`.
void remove_abandoned_folders();
void remove_abandoned_folders(const std::filesystem::path& parent);

/// A new folder for this user only, with a name that cannot be guessed, removed with its contents when the object is
/// destroyed. It contains one file, the owner's mark, on which this process holds a lock; creating the next temporary
/// folder in the same place removes those of killed owners. On a file system without locks those remain.
class TemporaryFolder {
 public:
  /// In $TMPDIR, or in /tmp if that is not set. @throws std::runtime_error with reason and remedy if no folder can be
  /// created there
  TemporaryFolder();
  /// In an existing folder. @throws std::system_error if no folder can be created there
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
