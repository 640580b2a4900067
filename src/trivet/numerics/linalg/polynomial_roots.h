// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <vector>

namespace trivet::numerics {

/// Roots of Σ coefficients[k] xᵏ with a last coefficient ≠ 0: eigenvalues of its companion matrix.
[[nodiscard]] std::vector<std::complex<double>> polynomial_roots(const std::vector<double>& coefficients);

}  // namespace trivet::numerics
