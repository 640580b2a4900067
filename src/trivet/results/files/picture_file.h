// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "trivet/results/files/whole_file.h"

namespace trivet::results {

/// A picture file; an existing one may be an earlier SVG picture or an empty file.
class PictureFile : public WholeFile {
 public:
  /// @throws foundation::InvalidInput as WholeFile, and if it is `project` or contains something else
  PictureFile(const std::filesystem::path& target, const std::filesystem::path& project);
};

}  // namespace trivet::results
