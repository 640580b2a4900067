// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

/// Any bytes through one of the doors by which data come in, and on to the quick answers. Whatever they are, they are
/// read or refused.
namespace trivet::fuzz {

/// "#role NAME\n" and the bytes of a file in that role; without such a line, or with the role "project", a project
/// file.
/// @throws std::exception only for a defect: refusals are handled here
void exercise(std::string_view input);

/// The roles of files: "matrix", "stl", "msh", "catalogue", "spectrum", "history" …
[[nodiscard]] std::vector<std::string_view> roles();

}  // namespace trivet::fuzz
