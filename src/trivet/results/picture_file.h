// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "trivet/foundation/temporary_folder.h"

namespace trivet::results {

/// A picture file, checked before the results are computed. The picture is written to a temporary folder next to the
/// target and then replaces the target as a whole, or not at all.
class PictureFile {
 public:
  /// An existing target may be an earlier SVG picture or an empty file.
  /// @throws foundation::InvalidInput if it is `project`, a link, or contains something else, or if its folder is not
  /// writable
  PictureFile(const std::filesystem::path& target, const std::filesystem::path& project);
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;

  /// @throws std::runtime_error with the reason; an earlier picture then stays unchanged
  void publish(const std::string& svg) const;

 private:
  std::filesystem::path target_;
  std::unique_ptr<foundation::TemporaryFolder> temporary_;
};

}  // namespace trivet::results
