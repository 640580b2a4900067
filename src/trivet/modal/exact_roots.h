// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>

#include "trivet/assembly/assembled.h"

namespace trivet::modal {

/// A root of the exact Z: Z(−iλ) v = 0.
struct ExactRoot {
  std::complex<double> eigenvalue;
  Eigen::VectorXcd shape;  ///< first rows of the layout
  bool converged = false;
};

/// Inverse iteration with Newton steps on λ from a root of the nearest linear system, for frequency-dependent elements.
/// Im λ > 0.
[[nodiscard]] ExactRoot exact_root(const assembly::Assembled& assembled, std::complex<double> start,
                                   const Eigen::VectorXcd& shape);

/// dZ/dλ of the exact Z(−iλ), to about ten digits.
[[nodiscard]] Eigen::MatrixXcd stiffness_slope(const assembly::Assembled& assembled, std::complex<double> lambda);

}  // namespace trivet::modal
