// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "trivet/elements/hysteretic_branch.h"
#include "trivet/nonlinear/laws/law_about.h"

namespace trivet::nonlinear {

/// The closed loop of one hysteretic force over a periodic deflection: the force after one period is that before it,
/// found by Newton's method on the force at the first turning point, not by marching.
class HystereticLoop {
 public:
  /// @param deflection  Fourier coefficients of the deviation from the state
  /// @param turns          phases of its turning points, ascending in [0, 2π)
  /// @param turning_slope  |dδ/dφ| of the given harmonics there
  HystereticLoop(const LawAbout::Hysteretic& part, const Eigen::VectorXd& deflection, const std::vector<double>& turns,
                 double turning_slope = 0);

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

  LawAbout::Hysteretic part_;
  std::vector<Branch> branches_;
  double turning_slope_;
  bool sticks_ = false;
};

}  // namespace trivet::nonlinear
