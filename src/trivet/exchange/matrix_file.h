// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

struct MatrixFileOptions {
  /// One of `matrix_formats()`; empty: determined by the first bytes and the file extension.
  std::string format;
  /// Which matrix, if a file can hold several: name of the DMIG, type of the *MATRIX ("stiffness" if empty).
  std::string name;
};

/// "matrix_market", "numpy", "csv", "nastran", "abaqus", "calculix".
[[nodiscard]] const std::vector<std::string>& matrix_formats();

/// Reads a matrix from a file; with a CalculiX .sti or .mas also the .dof file of the same name.
[[nodiscard]] foundation::Expected<NamedMatrix> read_matrix_file(const std::filesystem::path& path,
                                                                 const MatrixFileOptions& options = {});

}  // namespace trivet::exchange
