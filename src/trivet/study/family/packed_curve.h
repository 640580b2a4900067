// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>

#include "trivet/numerics/roots/driven_designs.h"

namespace trivet::study {

/// One curve of one design at one s = iω: y = cᵀq + constant with Z q = h.
struct PackedCurve {
  Eigen::MatrixXcd stiffness;  ///< Z
  Eigen::VectorXcd load, row;  ///< h, c
  std::complex<double> constant;
};
[[nodiscard]] PackedCurve packed_curve(const numerics::DrivenDesigns& designs, Eigen::Index design, std::size_t curve,
                                       double omega);

/// |y| at one frequency; NaN at an undamped resonance.
[[nodiscard]] double packed_magnitude(const numerics::DrivenDesigns& designs, Eigen::Index design, std::size_t curve,
                                      double omega);

}  // namespace trivet::study
