// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::exchange {

/// Largest matrix file that is read.
inline constexpr std::size_t largest_matrix_file = std::size_t{1} << 30;

/// The bytes of a file; refuses directories, unreadable, empty and absurdly large ones.
[[nodiscard]] foundation::Expected<std::string> file_bytes(const std::filesystem::path& path);

}  // namespace trivet::exchange
