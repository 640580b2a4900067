// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::exchange {

/// Size limit of a matrix file [bytes].
inline constexpr std::size_t largest_matrix_file = std::size_t{1} << 30;

/// Content of a file; errors for directories and for unreadable, empty or too large files.
[[nodiscard]] foundation::Expected<std::string> file_bytes(const std::filesystem::path& path);

}  // namespace trivet::exchange
