// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>

namespace trivet::numerics {

/// (on_displacement + s on_velocity + s² on_acceleration)ᵀ x of some coordinates x, s = iω. Vectors longer than x:
/// their first rows count.
struct CurveTerms {
  Eigen::VectorXcd on_displacement;
  Eigen::VectorXd on_velocity, on_acceleration;
  [[nodiscard]] bool empty() const { return on_displacement.size() == 0; }
};

/// y = s^derivative (terms of the response q, and terms of what is given), s = iω.
struct ObservedCurve {
  CurveTerms of_response;
  CurveTerms of_given;  ///< empty where that adds nothing
  int derivative = 0;
};

/// A curve of real terms, as kernels for many designs take it: y = s^derivative (on_displacement + s on_velocity)ᵀ q, s
/// = iω.
struct ObservedRow {
  Eigen::VectorXd on_displacement;
  Eigen::VectorXd on_velocity;  ///< or empty
  int derivative = 0;
};

[[nodiscard]] ObservedCurve observed_curve(const ObservedRow& row);

/// What terms make of x, one column for each ω, which may be complex.
[[nodiscard]] Eigen::RowVectorXcd weighted(const CurveTerms& terms, const Eigen::MatrixXcd& x,
                                           const Eigen::RowVectorXcd& omega);

/// Values of a curve, one for each ω. @param given  no columns if nothing is
[[nodiscard]] Eigen::RowVectorXcd curve_values(const ObservedCurve& curve, const Eigen::MatrixXcd& q,
                                               const Eigen::MatrixXcd& given, const Eigen::RowVectorXcd& omega);

/// |y| for coordinates of these sizes if all of them worked together: what is far below is round-off. @param omega  |ω|
[[nodiscard]] Eigen::RowVectorXd possible_amplitudes(const ObservedCurve& curve, const Eigen::MatrixXd& q,
                                                     const Eigen::MatrixXd& given, const Eigen::RowVectorXd& omega);

}  // namespace trivet::numerics
