// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/files.h"

namespace trivet::results {

/// Exclusive lock of one process on a folder (flock); the system releases it when the process ends for any reason.
class FolderLock {
 public:
  /// Waits for the lock. @param shown  name of the folder in messages  @throws std::runtime_error if another process
  /// holds it for a minute
  FolderLock(const foundation::FolderHandle& folder, const std::filesystem::path& shown);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False if the file system has no locks.
  [[nodiscard]] bool is_held() const { return error_ == 0; }
  [[nodiscard]] std::string reason() const;

 private:
  foundation::FolderHandle
      own_;  ///< opened only for this lock, so that two locks of one process also exclude each other
  int error_ = 0;
};

}  // namespace trivet::results
