// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "trivet/foundation/temporary_folder.h"

namespace trivet::results {

/// A picture in the making, begun before the answer is computed: it is written to a temporary folder beside the target
/// and takes its place as a whole, or not at all.
class PictureFile {
 public:
  /// A target that exists may be an earlier SVG picture, or empty.
  /// @throws foundation::InvalidInput if it is `project`, a link, or holds something else, or if nothing can be written
  /// in its folder
  PictureFile(const std::filesystem::path& target, const std::filesystem::path& project);
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;

  /// @throws std::runtime_error with the reason; an earlier picture then stays as it was
  void publish(const std::string& svg) const;

 private:
  std::filesystem::path target_;
  std::unique_ptr<foundation::TemporaryFolder> temporary_;
};

}  // namespace trivet::results
