// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/nonlinear/condensed_machine.h"
#include "trivet/nonlinear/law_harmonics.h"
#include "trivet/numerics/periodic/linear_flow.h"

namespace trivet::nonlinear {

/// Stability of periodic motions of a machine with finitely many states: the linear machine ẋ = F x with the tangent of
/// every law along the motion, over one period, from kink to kink of the laws. If all tangents are constant between the
/// kinks, each piece is the exact flow of its own linear machine. Otherwise steps are exact flow of the linear machine
/// around a kick by the tangents (splitting), extrapolated from three step lengths.
/// [Strang 1968; Hairer, Lubich, Wanner, Geometric Numerical Integration, II.4]
class PeriodicStability {
 public:
  /// @throws foundation::NotComputable with loss factors, which have no motion in time, or if a law acts on a
  /// coordinate without mass
  PeriodicStability(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections);

  /// Floquet multipliers: eigenvalues of the state transition over one period 2π/ω. The motion is stable if all are
  /// inside the unit circle.
  /// @param deflections  Fourier coefficients of one deflection after another
  [[nodiscard]] Eigen::VectorXcd multipliers(const std::vector<LawHarmonics>& laws, const Eigen::VectorXd& deflections,
                                             double omega) const;

 private:
  using Laws = std::vector<LawHarmonics>;
  [[nodiscard]] Eigen::VectorXd tangents(const Laws& laws, const Eigen::VectorXd& deflections, double phase) const;
  /// State transition between two phases: of constant tangents; by splitting.
  [[nodiscard]] Eigen::MatrixXd with_constant_tangents(const Laws& laws, const Eigen::VectorXd& deflections,
                                                       double from, double to, double omega) const;
  [[nodiscard]] Eigen::MatrixXd split(const Laws& laws, const Eigen::VectorXd& deflections, double from, double to,
                                      double omega) const;
  [[nodiscard]] Eigen::MatrixXd split(const Laws& laws, const Eigen::VectorXd& deflections, double from, double to,
                                      double omega, int steps) const;

  Eigen::MatrixXd F_;       ///< states × states
  Eigen::MatrixXd force_;   ///< states × deflections: ẋ per unit of each nonlinear force
  Eigen::MatrixXd values_;  ///< deflections × states
  numerics::LinearFlow flow_;
  Eigen::MatrixXd kick_, seen_;  ///< `force_` and `values_` in the coordinates of the flow
  /// Flows with tangents that occurred: the states of contact.
  mutable std::map<std::vector<double>, numerics::LinearFlow> flows_;
};

}  // namespace trivet::nonlinear
