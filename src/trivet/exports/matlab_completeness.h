// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace trivet::exports {

/// Throws if a MATLAB file of version 5 without compression is cut off anywhere: matio does not report a full disk.
/// Every element must end where the element that contains it ends, and structures and cells have all their parts.
/// @throws std::runtime_error with the file
void require_complete_matlab_file(const std::filesystem::path& path);

}  // namespace trivet::exports
