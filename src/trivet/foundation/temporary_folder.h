// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace trivet::foundation {

/// A new, empty folder for this owner only, removed with all it holds when the object goes, whatever happened before.
class TemporaryFolder {
 public:
  /// @throws std::filesystem::filesystem_error if the system has no place for it
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace trivet::foundation
