// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/model/system.h"
#include "trivet/nonlinear/balance/observed_motion.h"
#include "trivet/nonlinear/balance/steady_equations.h"
#include "trivet/nonlinear/branch/detached_motions.h"
#include "trivet/response/machinery/deflection_shape.h"

namespace trivet::nonlinear {

/// A periodic motion on the branch.
struct SteadyPoint {
  double angular_frequency = 0;  ///< of the excitation, or of the shaft [rad/s]
  double load_factor = 1;
  Eigen::MatrixXd deflections;          ///< Fourier coefficients × nonlinear deflections
  std::vector<ObservedMotion> results;  ///< in the order of SteadyBranch::results
  /// Motion of all places at each harmonic, from the mean on, as deviations from rest; of SteadyBranch::at alone.
  std::vector<response::DeflectionShape> shapes = {};
  Eigen::VectorXcd multipliers;
  double multiplier_uncertainty = 0;  ///< PeriodicStability::Multipliers
  bool multipliers_hold = true;       ///< are they accurate, and is their product that of Liouville's formula?
  bool stable = true;
  /// Stability is not known, and `stable` is false: the multipliers do not hold and there is no second verdict, or it
  /// contradicts them.
  bool uncertain = false;
  std::vector<double> contact;             ///< shares of the period in which stops are touched, as SteadyBranch::stops
  std::optional<int> unstable_by_winding;  ///< Floquet exponents with Re > 0 (WindingStability), where computed

  [[nodiscard]] int unstable_multipliers() const;  ///< their number outside the unit circle

  [[nodiscard]] double largest_multiplier() const { return multipliers.cwiseAbs().maxCoeff(); }
};

/// Where the parameter turns. Beyond it the motion jumps to another one at the same parameter.
struct Fold {
  SteadyPoint point;
  std::size_t after = 0;             ///< index of the point of the branch before it
  bool upper = false;                ///< the parameter is largest there: the jump as it rises
  std::optional<SteadyPoint> lands;  ///< the only stable motion of the same period known there; empty if there are
                                     ///< several or none
  std::size_t stable_there = 0;      ///< number of stable motions known there, those of twice the period included
};

/// Where the stability changes without a fold: a multiplier leaves the unit circle.
struct StabilityChange {
  enum class Kind {
    period_doubling,  ///< at −1: motions of twice the period begin
    quasi_periodic,   ///< a complex pair: motions with a second frequency begin (Neimark–Sacker)
    branch_point      ///< at +1: another branch of motions begins, often one that is less symmetric
  };
  SteadyPoint point;
  std::size_t after = 0;  ///< index of the point of the branch before it
  Kind kind = Kind::branch_point;
  bool sought = false;               ///< have motions that begin here been sought?
  std::optional<std::size_t> curve;  ///< of the further ones: motions that begin or end here; empty: none was found
};
[[nodiscard]] const char* words(StabilityChange::Kind kind);

struct SteadyBranch {
  std::vector<std::string> deflections;  ///< names
  std::vector<std::string> stops;        ///< names of the deflections that have any
  std::vector<std::string> results, units;
  std::vector<SteadyPoint> points;       ///< along the branch, from `from`
  std::vector<double> requested_at;      ///< parameters at which the harmonics are reported
  std::vector<SteadyPoint> at;           ///< there, in the order of the branch
  std::vector<Fold> folds;               ///< in the order of the branch
  std::vector<StabilityChange> changes;  ///< in the order of the branch
  Parameter over = Parameter::frequency;
  std::vector<std::string> excitations;
  std::optional<PhaseLag> at_phase;  ///< the frequency of each point is the one at this phase
  bool of_shaft = false;             ///< the frequency is that of a shaft, and the excitation its orders
  double first_harmonic = 1;         ///< frequency of the first harmonic over that of the excitation or the shaft
  Eigen::Index harmonics = 0;
  /// Amplitudes of the machine that is linear about rest, at these parameters; empty if it does not hold all its
  /// bodies.
  std::vector<double> linear_at;
  Eigen::MatrixXd linear;  ///< parameters × results
  [[nodiscard]] double parameter(const SteadyPoint& point) const {
    return over == Parameter::frequency ? point.angular_frequency : point.load_factor;
  }
  double left_out = 0;    ///< largest share of the deflections beyond the harmonics, at any point
  double held_share = 0;  ///< of harmonics beyond the end of the data of an element, which is held constant there
  /// What the multipliers are of.
  enum class Multipliers {
    machine,
    viscous_machine,  ///< loss factors were replaced
    constant_machine  ///< elements that depend on frequency were replaced by the nearest constant matrices
  };
  Multipliers multipliers_of = Multipliers::machine;
  bool of_amplitude = false;  ///< parts that depend on the amplitude have the stiffness and loss of each motion's
  /// The second verdict at some or all points.
  struct Winding {
    int points = 0;                  ///< judged
    int undecided = 0;               ///< an exponent on the axis
    std::vector<double> differs_at;  ///< parameters where it contradicts the multipliers
    bool decides = false;            ///< stability is that of the winding number at every point
  };
  Winding winding;
  std::vector<std::string> sticking;    ///< deflections with a slider that never slips at some point: the mean of its
                                        ///< force depends on what happened before
  std::vector<std::string> lost_means;  ///< deflections whose smooth loops bear a force at rest and lose it in motion
  std::string ended;                    ///< why the branch ends before the end of the band; empty: it does not
  std::optional<double> begun_at;       ///< parameter, if none at the lower end is on it
  std::vector<double> corners;          ///< parameters at which its direction changes at once
  bool closed = false;                  ///< a detached one that returns to its first point
  /// How a further curve was found: by the search for detached ones, or followed from a change of stability.
  enum class Found { detached, branched };
  Found found = Found::detached;
  int periods = 1;  ///< of the excitation, after which the motions repeat
  std::optional<DetachedSearch> search;
  std::vector<SteadyBranch> further;

  [[nodiscard]] std::vector<const SteadyBranch*> further_ones(Found how) const;
};

/// The branch of periodic motions that is connected with the motion at the lower end of the band, or if there is none,
/// with the first one found above it, through all folds, with the motions that begin where it loses its stability.
/// @throws foundation::NotComputable if no motion is found, or for what CondensedMachine and
/// PeriodicStability cannot represent
[[nodiscard]] SteadyBranch steady_branch(const model::System& system, const SteadyOptions& options,
                                         const foundation::Progress& progress = {});

}  // namespace trivet::nonlinear
