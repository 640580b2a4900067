// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/nonlinear/laws/bristle_loop.h"

namespace trivet::nonlinear {

/// Fourier coefficients of the force of bristles beyond that at the state, and their derivatives; first coefficients
/// are doubled.
struct BristleHarmonics {
  Eigen::VectorXd force;
  Eigen::MatrixXd tangent;   ///< by the coefficients of the deflection; empty if not asked for
  Eigen::VectorXd by_omega;  ///< the same
};
/// @param deflection  that of the loop
[[nodiscard]] BristleHarmonics bristle_harmonics(const BristleLoop& loop, const Eigen::VectorXd& deflection,
                                                 double omega, bool with_tangent);

/// The force at the frequencies μ + k, k = −K … K, by a variation e^{i(μ + l)φ} of the deflection.
class BristleVariation {
 public:
  BristleVariation(const BristleLoop& loop, double omega, Eigen::Index harmonics);

  /// @param mu  0 … 1/2
  [[nodiscard]] Eigen::MatrixXcd at(double mu) const;

 private:
  /// Of bristles from 0 on, which is a smooth function of μ, and what closes them.
  struct Open {
    Eigen::MatrixXcd from_zero;  ///< their amplitudes
    Eigen::VectorXcd fading;     ///< amplitudes of the fading
    Eigen::RowVectorXcd ends;    ///< after a period
  };
  [[nodiscard]] Open open(const BristleLoop& loop, double mu) const;

  elements::LuGreFriction law_;
  bool moves_;
  double omega_, faded_;
  Eigen::Index harmonics_;
  std::vector<Open> at_places_;  ///< of Chebyshev's polynomials
};

}  // namespace trivet::nonlinear
