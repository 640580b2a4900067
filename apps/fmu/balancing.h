// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fmu/matrix.h"

namespace trivet::fmu {

/// D⁻¹ A D with D = diag(2^e), whose rows and columns are nearly equal in size. Without it, displacements and
/// velocities differ by the angular frequency, and an exponential of A would be squared too often and lose digits.
/// [ParlettReinsch1969]
struct Balanced {
  Matrix matrix;
  std::vector<int> exponents;  ///< e
};

[[nodiscard]] Balanced balanced(Matrix a);

/// Exponent e for which 2^e times a column has absolute values with a sum of 1/2 to 1; 0 for a column of zeros.
[[nodiscard]] int column_exponent(const Matrix& b, std::size_t column);

}  // namespace trivet::fmu
