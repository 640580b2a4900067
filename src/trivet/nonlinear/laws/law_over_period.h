// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "trivet/elements/hysteresis.h"
#include "trivet/nonlinear/laws/bristle_loop.h"
#include "trivet/nonlinear/laws/deviation_law.h"

namespace trivet::nonlinear {

/// The closed loop of one hysteretic force over a periodic deflection: the force after one period is that before it,
/// found by Newton's method on the force at the first turning point, not by marching.
class HystereticLoop {
 public:
  /// @param deflection  Fourier coefficients of the deviation from the state
  /// @param turns          phases of its turning points, ascending in [0, 2π)
  /// @param turning_slope  |dδ/dφ| of the given harmonics there
  HystereticLoop(const DeviationLaw::Hysteretic& part, const Eigen::VectorXd& deflection,
                 const std::vector<double>& turns, double turning_slope = 0);

  /// From one turning point to the next.
  struct Branch {
    double from = 0, to = 0;            ///< phases; that of the last branch ends beyond 2π
    double deflection = 0;              ///< at the turning point
    double force = 0;                   ///< the whole force there, before it jumps
    double jump = 0;                    ///< of the force there
    Eigen::VectorXd force_slopes = {};  ///< derivative of `force` by the coefficients of the deflection
    std::optional<elements::HystereticBranch> course = {};  ///< of the force from there on
    std::optional<double> kink = {};                        ///< phase at which the force is not smooth
    double kink_jump = 0;                                   ///< of the force there
  };
  /// Empty if the deflection does not move.
  [[nodiscard]] const std::vector<Branch>& branches() const { return branches_; }
  [[nodiscard]] const Branch& branch_at(double phase) const;

  /// @return force beyond that at the state
  [[nodiscard]] elements::ForceOnTravel at(const Branch& branch, double deflection) const;

  /// Instants at which the force jumps, and how they move: by the deflection and its rate there, by the deflection and
  /// the force at the turning point before.
  struct Jump {
    double phase = 0, force = 0;
    std::size_t branch = 0;
    double by_deflection = 0,
           by_slope = 0;  ///< of the phase, by the deflection and by its derivative by the phase there
    double by_start = 0;  ///< of the phase, by the force at the turning point; −by_deflection by the deflection there
    double by_log_omega = 0;  ///< of the phase, by the logarithm of the frequency
  };
  [[nodiscard]] std::vector<Jump> jumps(const Eigen::VectorXd& deflection) const;

  [[nodiscard]] const elements::HystereticForce& law() const { return part_.law; }

  /// Does a slider stick all the time? Its force is then an elastic one, and its mean depends on what happened before;
  /// here on sticking since the state.
  [[nodiscard]] bool sticks() const { return sticks_; }
  /// Does a slider reach its slip and no more? Loaded at rest up to there it does, and its mean depends on what
  /// happened before too.
  [[nodiscard]] bool just_reaches_slip() const;

 private:
  /// Smooth loops of two turning points: the force at one is the opposite of that at the other.
  [[nodiscard]] bool is_symmetric() const;
  /// Forces at all turning points from that at the first one. @return force and its derivative after one period
  elements::ForceOnTravel around(double start);
  [[nodiscard]] double closed(double guess);
  [[nodiscard]] std::vector<elements::ForceOnTravel> ends() const;  ///< of the branches
  [[nodiscard]] Eigen::VectorXd row_at_turn(std::size_t turn, const Eigen::VectorXd& deflection) const;
  /// Slopes of the force at the end of a branch, from those at its start.
  [[nodiscard]] Eigen::VectorXd slopes_after(std::size_t branch, const elements::ForceOnTravel& end,
                                             const Eigen::VectorXd& slopes, const Eigen::VectorXd& deflection) const;
  void set_slopes(const Eigen::VectorXd& deflection);
  void set_slopes_of_sticking(const elements::ForceOnTravel& first, const Eigen::VectorXd& deflection);

  DeviationLaw::Hysteretic part_;
  std::vector<Branch> branches_;
  double turning_slope_;
  bool sticks_ = false;
};

/// One law along one periodic deflection: where it is not smooth, and its closed loops.
class LawOverPeriod {
 public:
  /// The law must outlive it.
  /// @param deflection  Fourier coefficients of the deviation from the state (numerics/periodic/fourier_basis.h)
  /// @param harmonics   of the motion; the others are zero
  /// @param omega       of the first harmonic [rad/s]
  /// @param samples     evenly spaced phases × coefficients to those harmonics: rows of the basis; of laws that have
  ///                    neither corners nor memory they are not needed
  /// @param round_off   a smaller amplitude is none: the turning points of noise would decide on the memory of friction
  LawOverPeriod(const DeviationLaw& law, const Eigen::VectorXd& deflection, Eigen::Index harmonics, double omega,
                const Eigen::Ref<const Eigen::MatrixXd>& samples, double round_off = 0);

  /// Phases at which the parts without memory are not smooth, ascending in [0, 2π).
  [[nodiscard]] const std::vector<double>& corners() const { return corners_; }
  /// One per hysteretic part that moves.
  [[nodiscard]] const std::vector<HystereticLoop>& loops() const { return loops_; }
  /// Of those that do not, which stick.
  [[nodiscard]] double resting_stiffness() const { return resting_stiffness_; }
  /// One per law of bristles.
  [[nodiscard]] const std::vector<BristleLoop>& bristles() const { return bristles_; }
  /// `corners`, the turning points and kinks of the loops, and the panels of bristles, in no order.
  [[nodiscard]] std::vector<double> all_corners() const;

  [[nodiscard]] bool has_no_law() const { return law_.is_empty(); }
  [[nodiscard]] bool is_damped() const { return law_.has_dampers(); }
  [[nodiscard]] double deflection_at(double phase) const;
  [[nodiscard]] double rate_at(double phase) const;  ///< by time
  /// With the row of the basis at a phase, which may go on beyond the motion.
  [[nodiscard]] double deflection_at(const Eigen::RowVectorXd& row) const {
    return row.head(deflection_.size()).dot(deflection_);
  }
  [[nodiscard]] double rate_at(const Eigen::RowVectorXd& row) const { return row.head(rate_.size()).dot(rate_); }
  /// Of the parts without memory, of those that rest, and of those that depend on the amplitude: k' over the
  /// deflection, k''/ω over the rate of the first harmonic, at the amplitude of the motion.
  [[nodiscard]] DeviationLaw::Force at(double phase) const;
  /// The tangents alone at many phases, rows of the basis, if no part depends on the rate.
  [[nodiscard]] Eigen::VectorXd elastic_tangents(const Eigen::MatrixXd& rows) const;
  /// The force, with the row of the basis at a phase (set_fourier_row).
  [[nodiscard]] DeviationLaw::Force at(const Eigen::RowVectorXd& row) const;

  /// Of the motion about its mean: that of a harmonic motion of the same root mean square.
  [[nodiscard]] double amplitude() const;
  /// k' and k'' there.
  [[nodiscard]] const elements::StiffnessOfAmplitude& of_amplitude() const { return of_amplitude_; }
  /// Coefficients of the motion, each harmonic a quarter of its period ahead: k'' times it is the force of the losses.
  [[nodiscard]] const Eigen::VectorXd& ahead() const { return ahead_; }

 private:
  [[nodiscard]] double turning_slope(Eigen::Index harmonics) const;

  const DeviationLaw& law_;
  double omega_;
  Eigen::VectorXd deflection_, rate_, ahead_;
  elements::StiffnessOfAmplitude of_amplitude_;
  std::vector<double> corners_;
  std::vector<HystereticLoop> loops_;
  double resting_stiffness_ = 0;
  std::vector<BristleLoop> bristles_;
};

}  // namespace trivet::nonlinear
