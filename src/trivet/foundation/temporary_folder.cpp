// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/temporary_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <system_error>

namespace trivet::foundation {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "trivet-XXXXXX").string();
  if (!mkdtemp(pattern.data()))
    throw std::filesystem::filesystem_error("cannot make a temporary folder", pattern, std::error_code(errno, std::generic_category()));
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;  // a destructor has nobody to tell
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace trivet::foundation
