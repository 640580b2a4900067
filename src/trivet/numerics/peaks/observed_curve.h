// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>

namespace trivet::numerics {

/// Linear form (on_displacement + s on_velocity + s² on_acceleration)ᵀ x of coordinates x, s = iω. If the vectors are
/// longer than x, only their first rows count.
struct CurveTerms {
  Eigen::VectorXcd on_displacement;
  Eigen::VectorXd on_velocity, on_acceleration;
  [[nodiscard]] bool empty() const { return on_displacement.size() == 0; }
};

/// y = s^derivative (terms of the response q + terms of the prescribed motion), s = iω.
struct ObservedCurve {
  CurveTerms of_response;
  CurveTerms of_given;  ///< empty if it adds nothing
  int derivative = 0;
};

/// A curve with real terms, for the kernels that solve many designs: y = s^derivative (on_displacement + s
/// on_velocity)ᵀ q, s = iω.
struct ObservedRow {
  Eigen::VectorXd on_displacement;
  Eigen::VectorXd on_velocity;  ///< or empty
  int derivative = 0;
};

[[nodiscard]] ObservedCurve observed_curve(const ObservedRow& row);

/// Values of the terms for x, one column per ω, which may be complex.
[[nodiscard]] Eigen::RowVectorXcd weighted(const CurveTerms& terms, const Eigen::MatrixXcd& x,
                                           const Eigen::RowVectorXcd& omega);

/// Values of a curve, one per ω. @param given  prescribed motion; no columns if there is none
[[nodiscard]] Eigen::RowVectorXcd curve_values(const ObservedCurve& curve, const Eigen::MatrixXcd& q,
                                               const Eigen::MatrixXcd& given, const Eigen::RowVectorXcd& omega);

/// Possible amplitude: |y| if the terms of coordinates of these sizes all add up in phase; values far below are
/// round-off. @param omega  |ω|
[[nodiscard]] Eigen::RowVectorXd possible_amplitudes(const ObservedCurve& curve, const Eigen::MatrixXd& q,
                                                     const Eigen::MatrixXd& given, const Eigen::RowVectorXd& omega);

}  // namespace trivet::numerics
