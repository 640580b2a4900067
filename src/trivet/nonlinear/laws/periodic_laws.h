// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/nonlinear/laws/law_set.h"
#include "trivet/numerics/periodic/linear_flow.h"

namespace trivet::nonlinear {

/// All laws along one periodic motion, by their derivatives.
struct PeriodicLaws {
  /// @param deflections  Fourier coefficients of one deflection after another
  /// @param frequency    of the first harmonic [rad/s]
  PeriodicLaws(const LawSet& laws, const Eigen::VectorXd& deflections, double frequency);
  PeriodicLaws(const PeriodicLaws&) = delete;  // loops belong to courses
  PeriodicLaws& operator=(const PeriodicLaws&) = delete;

  struct Loop {
    Eigen::Index deflection;
    const HystereticLoop* loop;
    std::vector<HystereticLoop::Jump> jumps;
  };
  struct Bristles {
    Eigen::Index deflection;
    const BristleLoop* loop;
  };
  /// Friction across a contact: with the two forces since it stuck, and the one across its slip.
  struct Rubbing {
    std::array<Eigen::Index, 3> on;  ///< deflections
    RubbingLoop loop;
    [[nodiscard]] bool remembers() const { return !loop.points().empty() && !loop.always_sticks(); }
  };
  /// Memories that change only where something turns, and those that change all the time.
  [[nodiscard]] Eigen::Index kept() const { return 2 * to_index(loops.size()) + 2 * to_index(rubbings.size()); }
  [[nodiscard]] Eigen::Index carried() const { return to_index(bristles.size()) + to_index(rubbings.size()); }
  [[nodiscard]] Eigen::Index memories() const { return kept() + carried(); }
  /// Places among the memories: of the two forces of a rubbing contact that sticks, and of that across its slip.
  [[nodiscard]] Eigen::Index first_kept(std::size_t rubbing) const {
    return 2 * to_index(loops.size()) + 2 * to_index(rubbing);
  }
  [[nodiscard]] Eigen::Index first_carried(std::size_t rubbing) const {
    return kept() + to_index(bristles.size()) + to_index(rubbing);
  }
  /// Does any force depend on a rate?
  [[nodiscard]] bool is_damped() const;
  [[nodiscard]] bool is_elastic() const {
    return !is_damped() && loops.empty() && sticking.empty() && distances.empty();
  }
  struct Distance {
    Eigen::Index first;
    const DistanceHarmonics* law;
    Eigen::MatrixXd course;  ///< coefficients × 3
  };

  double omega;
  Eigen::Index harmonics = 0;
  bool is_piecewise_linear = true;
  std::vector<LawOverPeriod> courses;
  std::vector<Loop> loops;     ///< with memory
  std::vector<Loop> sticking;  ///< as springs
  std::vector<Bristles> bristles, stuck;
  std::vector<Distance> distances;
  std::vector<Rubbing> rubbings;
};

/// Variation of the force of each deflection: by_deflection δ + by_rate δ̇ + Σ (by_travel (δ − δ_turn) + by_start
/// f_turn) of its loops, and of bristles, distances and rubbing contacts beside.
struct TangentsAlong {
  /// Of the friction of a contact on its three deflections, beside its memory.
  struct Rubbing {
    RubbingLoop::Moment moment;
    Eigen::Matrix3d by_deflection, by_rate;
  };
  Eigen::VectorXd by_deflection, by_rate;
  Eigen::VectorXd by_travel, by_start;  ///< one per loop
  Eigen::RowVectorXd row;               ///< of the Fourier basis
  std::vector<elements::SpatialForce> distances;
  std::vector<BristleLoop::Here> bristles;
  std::vector<Rubbing> rubbings;

  /// All numbers of these laws.
  [[nodiscard]] std::vector<double> list() const;
  /// Of all laws but their memories, deflections × deflections: forces by deflections, and by their rates.
  [[nodiscard]] Eigen::MatrixXd stiffness(const PeriodicLaws& motion) const;
  [[nodiscard]] Eigen::MatrixXd damping(const PeriodicLaws& motion) const;
  /// Deflections × states: values, rates and memory to forces, of laws without bristles and distances.
  [[nodiscard]] Eigen::MatrixXd forces(const PeriodicLaws& motion, const Eigen::MatrixXd& values,
                                       const Eigen::MatrixXd& rates) const;
};
/// At a phase.
void set_tangents(const PeriodicLaws& motion, double phase, TangentsAlong& found);

/// Response of the deflections to the forces of the nonlinear parts, deflections × forces. A node without mass follows
/// them at once if stiffness alone holds it, and drifts if dampers do.
struct DeflectionResponse {
  Eigen::MatrixXd at_once;  ///< D: deflections by forces
  Eigen::MatrixXd drifts;   ///< E: rates by forces
  Eigen::MatrixXd rates;    ///< R: rates by impulses on masses, or accelerations by forces
  bool massless = false;    ///< is any entry of D or E not zero?

  /// I − S_d (D + E h/2) − S_r (E + R h/2): times the mean forces of a step h it is the forces by the states before it,
  /// with the tangents S_d of the laws by deflections and S_r by rates (implicit midpoint rule).
  [[nodiscard]] Eigen::MatrixXd left_side(const Eigen::MatrixXd& by_deflection, const Eigen::MatrixXd& by_rate,
                                          double step) const;
};

/// Jacobians of the laws in the middle of each step: of the forces, times the step, and below them of the changes of
/// bristles and of the direction of rubbing contacts, by the values of all deflections, their rates if there are
/// dampers, and the memories of loops, rubbing contacts and bristles.
[[nodiscard]] numerics::RowMatrix law_jacobians(const PeriodicLaws& motion,
                                                const DeflectionResponse& deflection_response, double from, double to,
                                                int steps);

/// One unit of a memory of a rubbing contact: the spring's force over the travel for which its frequency alone with the
/// mass is the rate, so that all states have one size.
/// @param accelerations  of each deflection per unit of its force
[[nodiscard]] Eigen::VectorXd units_of_friction(const PeriodicLaws& motion, const Eigen::VectorXd& accelerations);

}  // namespace trivet::nonlinear
