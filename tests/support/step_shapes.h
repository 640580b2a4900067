// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace trivet::test {

/// Writes a STEP file of the solids that gmsh makes from these commands (OpenCASCADE kernel, millimetres).
/// @throws std::runtime_error with gmsh's message; the tests' packages include gmsh
void write_step(const std::filesystem::path& file, const std::string& commands);

}  // namespace trivet::test
