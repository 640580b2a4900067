// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>

#include "trivet/numerics/roots/designs.h"
#include "trivet/study/family/case_vector.h"

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

/// Margins of the covered requirements of many designs at once, as `requirement_values` computes them for one: designs
/// × requirements; infinite for those that are not covered, NaN where the kernels prove nothing (no positive definite
/// matrices, roots that lost digits). On one thread.
/// @param entries  one packed design per row
[[nodiscard]] Eigen::ArrayXXd packed_margins(const CaseVector& of, const Eigen::MatrixXd& entries);

/// The same in two parts: everything but amplitudes and peaks; and these alone, which take most of the time.
[[nodiscard]] Eigen::ArrayXXd packed_quick_margins(const CaseVector& of, const Eigen::MatrixXd& entries);
[[nodiscard]] Eigen::ArrayXXd packed_curve_margins(const CaseVector& of, const Eigen::MatrixXd& entries);

/// A and K of some rows of all designs.
[[nodiscard]] numerics::Designs part_of_designs(const numerics::Designs& all, const std::vector<Eigen::Index>& rows);

}  // namespace trivet::study
