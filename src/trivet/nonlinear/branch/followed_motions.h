// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "trivet/nonlinear/balance/steady_equations.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

/// The motions found along a curve, in their order, and those between them: where the parameter turns, and where it has
/// given values.
class FollowedMotions {
 public:
  /// Both must outlive it.
  /// @param wanted  parameters
  FollowedMotions(const numerics::Branch& branch, const std::vector<double>& wanted);

  /// The first motion of an empty curve.
  void begin(const numerics::BranchPoint& first) { points_ = {first}; }
  /// @param length  of the step to it
  void add(numerics::BranchPoint added, double length);
  void add_corner(double parameter) { corners_.push_back(parameter); }
  void clear();
  /// Reverses it, and goes on from its first motion along another curve that begins there.
  void reverse_and_append(const FollowedMotions& onward);
  /// Adds the motion in the middle of the step after a point, in which the parameter must not turn.
  /// @return false if it is not found
  [[nodiscard]] bool split_step(std::size_t after);

  /// How much has been found, but for corners: one is noted where the motions after the last smooth point are cut.
  struct Extent {
    std::size_t points, requested, turns, pieces;
  };
  [[nodiscard]] Extent extent() const { return {points_.size(), requested_.size(), turns_.size(), pieces_.size()}; }
  void cut_to(const Extent& end);

  /// Where the parameter turns.
  struct Turn {
    numerics::BranchPoint point;
    std::size_t after = 0;  ///< index of the point before it
    bool upper = false;     ///< the parameter is largest there
  };
  [[nodiscard]] const std::vector<numerics::BranchPoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<Turn>& turns() const { return turns_; }
  /// Motions at the wanted parameters, in the order of the curve.
  [[nodiscard]] const std::vector<numerics::BranchPoint>& requested() const { return requested_; }
  /// Parameters at which the direction of the curve changes at once.
  [[nodiscard]] const std::vector<double>& corners() const { return corners_; }
  [[nodiscard]] double step_length(std::size_t after) const { return lengths_[after]; }
  /// All motions of the curve at a parameter.
  [[nodiscard]] std::vector<numerics::BranchPoint> all_at(double parameter) const;
  /// The motion between a point and the next one at which a quantity is zero; empty if none is found.
  [[nodiscard]] std::optional<numerics::BranchPoint> zero_after(
      std::size_t point, const std::function<double(const numerics::BranchPoint&)>& quantity, double accurate) const {
    return branch_.zero(quantity, points_[point], 0, lengths_[point], accurate);
  }

  /// Removes turns between which the parameter changes by round-off only: a curve that begins upright, at a crossing
  /// with another one, has its direction there by chance.
  void remove_turns_of_round_off();

  /// The same motion, followed in the other direction.
  [[nodiscard]] static numerics::BranchPoint reversed(numerics::BranchPoint point);

 private:
  /// A part in which the parameter rises or falls: lengths from a point, and their parameters.
  struct Piece {
    std::size_t from;
    double begin, end;
    double parameter_begin, parameter_end;
  };
  [[nodiscard]] std::optional<numerics::BranchPoint> at(double parameter, const Piece& piece) const;

  const numerics::Branch& branch_;
  const std::vector<double>& wanted_;
  std::vector<numerics::BranchPoint> points_, requested_;
  std::vector<double> lengths_, corners_;
  std::vector<Turn> turns_;
  std::vector<Piece> pieces_;
};

/// The motion at which a branch begins: by Newton's method from the linear motion; where that does not converge, from a
/// raised load or raised nonlinear forces, or from larger motions.
/// @param branch  of the equations
[[nodiscard]] std::optional<numerics::BranchPoint> first_motion(const SteadyEquations& equations,
                                                                const numerics::Branch& branch, double parameter);

/// Motions at a parameter on the path over the load, from a small one through its folds.
[[nodiscard]] std::vector<numerics::BranchPoint> motions_over_load(const SteadyEquations& equations,
                                                                   const numerics::Branch& branch, double parameter,
                                                                   double most_load);

}  // namespace trivet::nonlinear
