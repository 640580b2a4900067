// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

/// Passes any bytes to one of the readers of input data, then computes the quick results. All bytes must be read or
/// rejected.
namespace trivet::fuzz {

/// "#role NAME\n" and the bytes of a file in that role; without such a line, or with the role "project", a project
/// file.
/// @throws std::exception only for a defect: rejections are handled here
void exercise(std::string_view input);

/// Roles of files: "matrix", "stl", "msh", "catalogue", "spectrum", "history" …
[[nodiscard]] std::vector<std::string_view> roles();

}  // namespace trivet::fuzz
