// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/folder_handle.h"

namespace trivet::results {

/// Held by one process at a time on one folder (flock); the system releases it when its holder ends, however that
/// happens.
class FolderLock {
 public:
  /// Waits for the lock. @param shown  what a message calls the folder  @throws std::runtime_error if others hold it
  /// for a minute
  FolderLock(const foundation::FolderHandle& folder, const std::filesystem::path& shown);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Not if the file system has no locks.
  [[nodiscard]] bool is_held() const { return error_ == 0; }
  [[nodiscard]] std::string reason() const;

 private:
  foundation::FolderHandle own_;  ///< opened for this lock alone: two locks of one process exclude each other too
  int error_ = 0;
};

}  // namespace trivet::results
