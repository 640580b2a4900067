// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "trivet/elements/knot_curve.h"
#include "trivet/elements/table_law.h"
#include "trivet/spatial/types.h"

namespace trivet::elements {

/// k*(ω) of a table without amplitudes as a piecewise cubic in ω, each piece continued to complex ω.
class PiecewiseStiffness {
 public:
  explicit PiecewiseStiffness(const StiffnessTable& table);

  /// Value by the piece at the real frequency `near` [rad/s]; the end pieces also apply beyond the ends.
  [[nodiscard]] std::complex<double> at(std::complex<double> omega, double near) const;

 private:
  std::vector<double> knots_;
  std::vector<std::array<std::complex<double>, 4>> pieces_;  ///< values at four equidistant frequencies of each
};

/// The 12×12 of an element about its states at several deflections of K relative to N along one of its axes, each with
/// its force: tangents of large deformations. A rigid rotation turns the force, and does nothing else.
class StiffnessOverDeflection {
 public:
  struct State {
    double deflection = 0;  ///< [m]
    double force = 0;       ///< of K on the element along the axis [N]
    spatial::Matrix12 stiffness = spatial::Matrix12::Zero();
  };
  /// @param states  three or more, ascending
  /// @param axis    0, 1 or 2
  /// @param arm     from N to K along it [m], ≥ 0; 0: at one point
  /// @throws foundation::InvalidInput otherwise
  StiffnessOverDeflection(const std::vector<State>& states, Eigen::Index axis, double arm);

  [[nodiscard]] Eigen::Index axis() const { return axis_; }

  /// Between the states by a cubic of each entry, about the nearest one outside.
  /// @param force  at the deflection
  [[nodiscard]] spatial::Matrix12 at(double deflection, double force) const;

 private:
  Eigen::Index axis_;
  double from_ = 0, to_ = 0;
  spatial::Matrix12 per_force_;           ///< per unit of the force
  std::vector<KnotCurve> without_force_;  ///< entries column by column
};

}  // namespace trivet::elements
