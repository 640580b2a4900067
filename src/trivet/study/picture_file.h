// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace trivet::study {

/// A picture in the making, begun before the answer is computed: it is written beside the target and takes its place as a whole, or not at all.
class PictureFile {
 public:
  /// A target that exists may be an earlier SVG picture, or empty. A link stands for what it leads to.
  /// @throws foundation::InvalidInput if it is `project` or holds something else, or if nothing can be written in its folder
  PictureFile(const std::filesystem::path& target, const std::filesystem::path& project);
  ~PictureFile();
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;

  /// @throws std::runtime_error with the reason; an earlier picture then stays as it was
  void publish(const std::string& svg) const;

 private:
  std::filesystem::path target_;
  std::filesystem::path working_;
};

}  // namespace trivet::study
