// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/nonlinear/balance/harmonic_balance.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

/// Instead of a fixed frequency over the load factor: that at which a result lags the excitation by a phase.
struct PhaseLag {
  std::string of;           ///< a displacement
  double lag = 0;           ///< of its harmonic at the lowest frequency of the excitation [rad]
  double from = 0, to = 0;  ///< the frequency at the lower end of the load is sought here [rad/s]
  std::string behind = {};  ///< of a result: the excitation (PeriodicExcitation::reference)
};

inline constexpr Eigen::Index most_steady_harmonics = 60;

struct SteadyOptions {
  double
      from = 0,
      to = 0;  ///< of the parameter: angular frequency of the excitation or the shaft [rad/s], or factor; 0 < from < to
  Parameter over = Parameter::frequency;
  double angular_frequency = 0;      ///< over the load factor: the fixed one [rad/s]
  std::optional<PhaseLag> at_phase;  ///< or, over the load factor, at this phase
  Eigen::Index harmonics = 9;        ///< 0: as many as `tolerance` needs, up to the next
  Eigen::Index most_harmonics = most_steady_harmonics;
  double tolerance = 1e-3;               ///< share of the deflections that the harmonics beyond may add
  std::vector<std::string> excitations;  ///< of these; empty: all harmonic ones, or without any, all orders
  std::vector<std::string> of;           ///< results, as channels; empty: none
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<assembly::MotionQuantity> quantities = {};  ///< one per result; empty: `quantity` of all
  std::vector<double> at;  ///< also exactly at these parameters, wherever the branch passes them
  bool detached = false;   ///< seek motions that are not connected with the one at the lower end of the band
  bool deep = false;       ///< judge the stability of every point in two ways
  int most_points = 20000;
};

/// Harmonic balance over the parameter of a curve, the frequency or the load factor, and how its unknowns are scaled.
class SteadyEquations {
 public:
  /// All but the excitation must outlive it.
  /// @throws foundation::NotComputable if no excitation moves a nonlinear part
  SteadyEquations(const CondensedMachine& machine, const std::vector<Deflection>& deflections,
                  const PeriodicExcitation& excitation, const SteadyOptions& options, Eigen::Index harmonics);
  SteadyEquations(const SteadyEquations&) = delete;
  SteadyEquations& operator=(const SteadyEquations&) = delete;
  ~SteadyEquations() = default;

  [[nodiscard]] const HarmonicBalance& balance() const { return balance_; }
  [[nodiscard]] const SteadyOptions& options() const { return options_; }
  [[nodiscard]] Driving driving(double parameter) const;
  [[nodiscard]] double width() const { return options_.to - options_.from; }
  /// "12.5 rad/s"
  [[nodiscard]] std::string place(double parameter) const;

  /// Harmonics are compared with the largest one of their kind (DeflectionScales), means with the largest mean too: a
  /// mean that changes little must not hide a resonance. What stays near zero is compared with a thousandth of the
  /// linear motion. Lengths on the branch count all deflections, also those that are no unknowns.
  [[nodiscard]] Eigen::VectorXd scale(const Eigen::VectorXd& unknowns) const;

  /// Its solutions. The equations must outlive it, and so for the next ones.
  [[nodiscard]] numerics::Branch branch() const;
  /// At the frequency of a parameter, over a share of the whole load.
  [[nodiscard]] numerics::Branch over_load(double parameter) const;
  /// At a parameter, from the linear motion over a share of the nonlinear forces.
  [[nodiscard]] numerics::Branch over_nonlinear_forces(double parameter) const;

  struct Place {
    Eigen::VectorXd unknowns;
    double parameter = 0;
  };
  /// The direction of the unknowns in which the equations change least; empty if they are not finite.
  [[nodiscard]] std::optional<Eigen::VectorXd> weakest_direction(const Place& place) const;
  /// Is the determinant of the equations negative, which it is beyond a fold: an odd number of real multipliers above
  /// 1?
  [[nodiscard]] bool is_beyond_fold(const Place& place) const;
  /// It passes zero where the equations do not change at all in a direction near the given one: two curves cross.
  [[nodiscard]] double change_along(const Place& place, const Eigen::VectorXd& direction) const;

 private:
  [[nodiscard]] numerics::Branch branch(numerics::EvaluateEquations evaluate, double width) const;
  [[nodiscard]] Eigen::MatrixXd derivatives(const Place& place) const;

  const SteadyOptions& options_;
  double first_harmonic_;  ///< its frequency over the one that is varied
  bool of_shaft_;
  HarmonicBalance balance_;
  Eigen::VectorXd smallest_;  ///< scales of harmonics, per deflection
  Eigen::VectorXd carried_;   ///< root of the number of deflections that move with each independent one
};

}  // namespace trivet::nonlinear
