// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace trivet::exports {

/// Throws if an Excel workbook is cut off anywhere: libxlsxwriter does not report a disk that is full while it writes
/// the sheets. The archive must have its directory at its end, every part its checksum, and every part must end with
/// the tag that it begins with.
/// @throws std::runtime_error with the file
void require_complete_workbook(const std::filesystem::path& path);

}  // namespace trivet::exports
