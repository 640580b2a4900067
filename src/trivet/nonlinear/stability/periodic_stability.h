// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/nonlinear/laws/law_set.h"
#include "trivet/nonlinear/laws/periodic_laws.h"
#include "trivet/nonlinear/machine/condensed_machine.h"
#include "trivet/numerics/periodic/linear_flow.h"

namespace trivet::nonlinear {

struct PeriodicLaws;

/// Stability of periodic motions of a machine with finitely many states: the linear machine ẋ = F x with the tangent of
/// every law along the motion, over one period, from corner to corner of the laws. Each moving loop adds two states,
/// the variations of deflection and force at its last turning point, bristles that move their own variation,
/// contacts that rub the variations of the force since they stuck and of its direction. Where a force jumps, the
/// variation of that instant is an impulse. Parts that depend on the amplitude have their stiffness at that of the
/// motion, and as viscous damping their loss at the first harmonic. If all tangents are constant between the corners,
/// each piece is the exact flow of its own linear machine. Otherwise steps are exact flow of the linear machine around
/// a kick by the tangents (splitting), extrapolated from smaller and smaller steps, none of which is longer than the
/// quickest oscillation by the tangents bears. [Strang 1968; Hairer, Lubich, Wanner, Geometric Numerical Integration,
/// II.4] Where these would be too many, as beside a very light body, steps are exponentials of the whole linear machine
/// with its tangents, of fourth order [Blanes, Moan, Appl. Numer. Math. 56 (2006) 1519–1537], or if all that is quick
/// decays, implicit: Radau IIA, of fifth order [Hairer, Wanner, Solving Ordinary Differential Equations II, IV.5].
/// Nodes without mass follow by their own balance of forces (static condensation with the tangents of each instant), or
/// drift with their dampers. It keeps flows for the next motion: not for several threads at once.
class PeriodicStability {
 public:
  /// Loss factors, which define no motion in time, are replaced by viscous damping that is the same in every mode at
  /// its own frequency. @throws foundation::NotComputable if a law that depends on rates or jumps acts on a node
  /// without mass
  PeriodicStability(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections);

  struct Multipliers {
    Eigen::VectorXcd values;
    double uncertainty = 0;  ///< share of the transition that the smallest steps still change, if it is too much
    /// Does their product agree with Liouville's formula, exp(∫ tr F dt), as far as the smallest of them are known?
    /// (With memories, which are set again, it is zero.) Multipliers so large that the others are lost in their
    /// round-off are not confirmed either.
    bool confirmed = true;
  };
  /// Floquet multipliers: eigenvalues of the state transition over one period 2π/ω. The motion is stable if all are
  /// inside the unit circle.
  /// @param deflections  Fourier coefficients of one deflection after another
  /// @param accurate     at most this share of the transition changes by the last column of the extrapolation
  [[nodiscard]] Multipliers multipliers(const LawSet& laws, const Eigen::VectorXd& deflections, double omega,
                                        double accurate = 1e-7) const;

  /// Is the linear machine undamped? Exponents of motions that are stable then lie on the axis.
  [[nodiscard]] bool is_undamped() const { return F_.trace() == 0; }
  /// Is it that of the machine with its loss factors replaced?
  [[nodiscard]] bool is_of_viscous_machine() const { return replaced_losses_; }

 private:
  struct Transition {
    Eigen::MatrixXd states;
    double uncertainty = 0;  ///< as of the multipliers
  };
  /// State transition between two phases: of constant tangents; by splitting; by exponentials.
  [[nodiscard]] Eigen::MatrixXd with_constant_tangents(const PeriodicLaws& motion, double from, double to) const;
  [[nodiscard]] Transition smooth(const PeriodicLaws& motion, double from, double to, double accurate) const;
  [[nodiscard]] Transition split(const PeriodicLaws& motion, double from, double to, int fewest, double accurate) const;
  [[nodiscard]] Eigen::MatrixXd split(const PeriodicLaws& motion, double from, double to, int steps) const;
  [[nodiscard]] Transition stiff(const PeriodicLaws& motion, double from, double to, double accurate) const;
  [[nodiscard]] Eigen::MatrixXd exponentials(const PeriodicLaws& motion, double from, double to, int steps) const;
  [[nodiscard]] Eigen::MatrixXd collocated(const PeriodicLaws& motion, double from, double to, int steps) const;
  [[nodiscard]] bool is_overdamped(const PeriodicLaws& motion, double from, double to) const;
  [[nodiscard]] double fastest_kicked(const Eigen::MatrixXd& largest, double time) const;
  [[nodiscard]] Eigen::MatrixXd rates_of_states(const PeriodicLaws& motion, double phase) const;
  [[nodiscard]] double fastest(const PeriodicLaws& motion, double from, double to) const;
  [[nodiscard]] double trace(const PeriodicLaws& motion, double from, double to) const;
  [[nodiscard]] const Eigen::MatrixXd& rows_in_steps(const PeriodicLaws& motion, double from, double to, int steps,
                                                     Eigen::MatrixXd& of_piece) const;
  [[nodiscard]] numerics::RowMatrix elastic_jacobians(const PeriodicLaws& motion, double from, double to,
                                                      int steps) const;
  void check_nodes(const std::vector<Deflection>& deflections) const;
  [[nodiscard]] Eigen::RowVectorXd deflection(const PeriodicLaws& motion, Eigen::Index j, double phase,
                                              const Eigen::MatrixXd& states) const;
  void turn(const PeriodicLaws& motion, std::size_t loop, double phase, Eigen::MatrixXd& states) const;
  void forget_unused(const PeriodicLaws& motion, Eigen::MatrixXd& states) const;
  void change_rubbing(const PeriodicLaws& motion, std::size_t rubbing, double phase, Eigen::MatrixXd& states) const;
  void jump(const PeriodicLaws& motion, std::size_t loop, double phase, Eigen::MatrixXd& states) const;

  bool replaced_losses_;
  Eigen::MatrixXd F_;       ///< states × states
  Eigen::MatrixXd force_;   ///< states × deflections: ẋ per unit of each nonlinear force
  Eigen::MatrixXd values_;  ///< deflections × states
  Eigen::MatrixXd rates_;   ///< their rates
  DeflectionResponse deflection_response_;
  Eigen::VectorXd accelerations_;  ///< of each deflection per unit of its force
  Eigen::MatrixXd alike_;          ///< accelerations by forces, deflections in units in which the diagonal is alike
  numerics::LinearFlow flow_;
  Eigen::MatrixXd kick_, seen_, seen_rates_;  ///< `force_`, `values_` and `rates_` in the coordinates of the flow
  Eigen::MatrixXd kicked_, moved_;  ///< sizes of `kick_` and `seen_`; of both parts of a turning mode in its first
  /// Flows with tangents that occurred: the states of contact.
  mutable std::map<std::vector<double>, numerics::LinearFlow> flows_;
  /// Rows of the Fourier basis in the middle of each step of a whole period, by the numbers of steps and harmonics.
  mutable std::map<std::pair<int, Eigen::Index>, Eigen::MatrixXd> rows_;
};

/// Stability of periodic motions from the receptance alone, so also of machines that are not a set of states in time.
/// Floquet exponents s are zeros of D(s) = det(I + G(s + ikω) T), k = −K … K, in one strip |Im s| ≤ ω/2, where T is the
/// Toeplitz matrix of the tangents along the motion. By the argument principle the number of zeros with Re s > 0 is
/// that of the poles of G there less the turns of D(iν) about 0 for ν from −ω/2 to ω/2.
/// [Hill 1886; Lazarus, Thomas, C. R. Mécanique 338 (2010)]
class WindingStability {
 public:
  /// Both must outlive it. The machine has no loss factors, which are not analytic in s.
  WindingStability(const CondensedMachine& machine, const std::vector<Deflection>& deflections)
      : machine_(machine), deflections_(deflections) {}

  /// Number of Floquet exponents with Re s > 0; empty if an exponent lies on the axis, to
  /// round-off: D is then almost zero somewhere, and its turns cannot be told.
  /// @param motion  Fourier coefficients × all deflections
  /// @param omega   of the first harmonic [rad/s]
  [[nodiscard]] std::optional<int> unstable_exponents(const Eigen::MatrixXd& motion, double omega) const;

 private:
  const CondensedMachine& machine_;
  const std::vector<Deflection>& deflections_;
};

}  // namespace trivet::nonlinear
