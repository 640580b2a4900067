// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "trivet/nonlinear/balance/harmonic_balance.h"
#include "trivet/nonlinear/machine/periodic_excitation.h"
#include "trivet/nonlinear/machine/reference_machine.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

/// What is held along a curve over the load: a harmonic of a deflection lags the excitation by an angle.
struct HeldPhase {
  Eigen::Index deflection = 0;  ///< an independent one (DeflectionBasis)
  Eigen::Index harmonic = 1;    ///< an excited one
  double lag = 0;               ///< [rad]
  PeriodicExcitation::Reference reference = {};
};

/// Harmonic balance at a frequency that is unknown and a phase that is held. Unknowns: those of the balance, and the
/// logarithm of the frequency; parameter: the load factor. With the coefficients a, b of the harmonic, its phase is
/// that of a − i b. Where it lags cos ωt by ψ, a sin ψ − b cos ψ is zero; ψ is the lag behind the excitation less the
/// phase of that.
class PhaseEquations {
 public:
  /// The machine must outlive it.
  /// @param load  a typical one
  PhaseEquations(const ReferenceMachine& machine, Eigen::Index harmonics, const HeldPhase& held, double load);
  PhaseEquations(const PhaseEquations&) = delete;
  PhaseEquations& operator=(const PhaseEquations&) = delete;
  ~PhaseEquations() = default;

  [[nodiscard]] const HarmonicBalance& balance() const { return balance_; }
  [[nodiscard]] const numerics::Branch& branch() const { return branch_; }
  [[nodiscard]] static Driving driving(const numerics::BranchPoint& point);
  [[nodiscard]] Eigen::VectorXd motion(const numerics::BranchPoint& point) const {
    return point.unknowns.head(balance_.size());
  }

  /// Where the linear motion at a load has the phase, and is largest: frequency of the first harmonic; empty: nowhere.
  [[nodiscard]] std::optional<double> linear_resonance(double load, double from, double to) const;
  /// The motion near the linear one at a frequency of the first harmonic.
  [[nodiscard]] std::optional<numerics::BranchPoint> near_linear(double omega, double load) const;

 private:
  /// Behind cos ωt.
  /// @param omega  of the first harmonic
  [[nodiscard]] double lag_at(double omega) const;
  [[nodiscard]] double order() const { return static_cast<double>(held_.harmonic); }
  [[nodiscard]] double phase_equation(const Eigen::VectorXd& motion, double lag) const;
  [[nodiscard]] double slope_of_phase_equation(const Eigen::VectorXd& motion, double lag) const;
  void evaluate(const Eigen::VectorXd& unknowns, double load, numerics::Equations& equations) const;
  [[nodiscard]] Eigen::VectorXd scale(const Eigen::VectorXd& unknowns) const;

  HeldPhase held_;
  HarmonicBalance balance_;
  Eigen::Index cosine_;
  numerics::Branch branch_;
};

}  // namespace trivet::nonlinear
