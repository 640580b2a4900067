// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// Variables of a MATLAB file of level 5 ("MAT-File Format", The MathWorks), as bytes. Inside a structure or a cell
/// they have no name.
namespace trivet::exports {

using MatBytes = std::string;
using MatSizes = std::vector<std::size_t>;

/// The start of a file; its variables follow.
[[nodiscard]] MatBytes mat_header(const std::string& description);

/// Numbers by columns; `sizes` has at least two.
[[nodiscard]] MatBytes mat_real(const std::string& name, const MatSizes& sizes, const std::vector<double>& numbers);
[[nodiscard]] MatBytes mat_complex(const std::string& name, const MatSizes& sizes,
                                   const std::vector<std::complex<double>>& numbers);
/// @param words  UTF-8
[[nodiscard]] MatBytes mat_text(const std::string& name, const std::string& words);

/// A column of texts.
[[nodiscard]] MatBytes mat_texts(const std::string& name, const std::vector<std::string>& texts);

/// @param fields  their names, at most 63 letters, digits and _, and their variables
[[nodiscard]] MatBytes mat_structure(const std::string& name,
                                     const std::vector<std::pair<std::string, MatBytes>>& fields);

}  // namespace trivet::exports
