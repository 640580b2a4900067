// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace trivet::numerics {

/// r(u, λ) = 0: as many equations as unknowns u, and one parameter λ.
struct Equations {
  Eigen::VectorXd value;         ///< r
  Eigen::MatrixXd by_unknowns;   ///< ∂r/∂u
  Eigen::VectorXd by_parameter;  ///< ∂r/∂λ
  bool value_only = false;       ///< set by the caller: the derivatives are not needed, and may have any values
};
/// A typical size of each unknown near a solution.
using ScaleUnknowns = std::function<Eigen::VectorXd(const Eigen::VectorXd& unknowns)>;
using EvaluateEquations = std::function<void(const Eigen::VectorXd& unknowns, double parameter, Equations& equations)>;

/// A solution on a branch, with the direction of the branch there.
struct BranchPoint {
  Eigen::VectorXd unknowns;
  double parameter = 0;
  Eigen::VectorXd scale;      ///< of the unknowns and, last, of the parameter: lengths on the branch are without unit
  Eigen::VectorXd tangent;    ///< d(u, λ)/ds divided by `scale`, of unit length
  int iterations = 0;         ///< of Newton's method
  Eigen::VectorXd bend = {};  ///< estimate of d(tangent)/ds, across the tangent; empty: unknown

  [[nodiscard]] double parameter_direction() const { return tangent(tangent.size() - 1); }
  /// To a place nearby, divided by `scale`, as the tangent is.
  [[nodiscard]] Eigen::VectorXd way_to(const Eigen::VectorXd& other, double other_parameter) const;
};

struct BranchOptions {
  double tolerance = 1e-11;  ///< of the last Newton step, relative to `scale`
  int most_iterations = 12;
};

/// Lengths of steps along a branch, without unit.
struct StepControl {
  double longest = 0.1, shortest = 1e-9;
  double growth = 1.4;          ///< of the step after an easy one
  double least_cosine = 0.966;  ///< between the directions at both ends of a step: 15°
  double hidden_folds = 1e-4;   ///< a shorter step hides no pair of folds worth finding
  double sharp_turns = 0;       ///< a shorter step may turn by any angle: the branch has a kink
};

/// Solutions of r(u, λ) = 0 along their branch by pseudo arc length: the predictor follows the tangent, and Newton's
/// method corrects in the plane across it, so that turning points of λ (folds) are ordinary points.
/// [Keller 1977; Allgower, Georg, Numerical Continuation Methods, 1990]
class Branch {
 public:
  /// @param smallest_scale   of each unknown, for those that are almost zero
  /// @param parameter_scale  a typical change of λ along the branch
  Branch(EvaluateEquations evaluate, Eigen::VectorXd smallest_scale, double parameter_scale,
         BranchOptions options = {});
  Branch(EvaluateEquations evaluate, double parameter_scale, ScaleUnknowns scale, BranchOptions options = {});

  /// The solution at a fixed λ near a guess, with its direction towards larger λ (or smaller, if `downwards`). Empty if
  /// Newton's method does not converge.
  [[nodiscard]] std::optional<BranchPoint> start(const Eigen::VectorXd& guess, double parameter,
                                                 bool downwards = false) const;

  /// The solution at the length `step` (negative: backwards) from a point. Empty if Newton's method does not converge.
  [[nodiscard]] std::optional<BranchPoint> after(const BranchPoint& from, double step) const;

  struct Advance {
    BranchPoint to;
    double length = 0;
  };
  /// The next point. The step is halved until Newton's method converges and the branch is smooth enough across it, and
  /// grows after an easy one. Empty if it would become shorter than the shortest.
  [[nodiscard]] std::optional<Advance> advance(const BranchPoint& from, double& step, const StepControl& control) const;

  /// Where the direction turns by more than a right angle at once, no plane across the old one meets the branch: a
  /// solution at a fixed λ from `lowest` to `highest` that is close to a point, ahead of it on the branch, and at least
  /// the length `least` away.
  [[nodiscard]] std::optional<Advance> beyond_kink(const BranchPoint& from, double least, double lowest,
                                                   double highest) const;

  /// The sign of the determinant of [∂r/∂u ∂r/∂λ; tangentᵀ]: all along a branch the same, also beyond kinks at which
  /// the direction turns by any angle, but for branch points, where it changes. [Allgower, Georg 1990, chapters 2 and
  /// 12]
  [[nodiscard]] int orientation(const BranchPoint& point) const;

  /// Length from a point to one near it on the branch, as `after` counts it.
  [[nodiscard]] static double length(const BranchPoint& from, const BranchPoint& to);

  /// Does the cubic through both ends of a step, with their directions, turn twice between them?
  [[nodiscard]] static bool hides_folds(const BranchPoint& from, const BranchPoint& to, double step);

  /// The solution between two lengths from a point at which a quantity is zero, by regula falsi (Illinois): to
  /// `accurate`, or to round-off of the length. Empty if it has the same sign at both ends, or if Newton's method does
  /// not converge on the way, or the quantity is no number there.
  [[nodiscard]] std::optional<BranchPoint> zero(const std::function<double(const BranchPoint&)>& quantity,
                                                const BranchPoint& from, double low, double high, double accurate,
                                                bool exact_direction = false) const;

  /// The solution at λ between two lengths from a point, where the branch passes λ once. Empty if it does not.
  [[nodiscard]] std::optional<BranchPoint> at(double parameter, const BranchPoint& from, double low, double high) const;

  /// The same between two neighbouring points, from the cubic through them with their directions.
  [[nodiscard]] std::optional<BranchPoint> at(double parameter, const BranchPoint& from, const BranchPoint& to) const;

  /// The fold between a point and the one at `step` from it, where the parameter direction has the other sign; at a
  /// kink, the last solution before it.
  [[nodiscard]] BranchPoint fold(const BranchPoint& from, double step) const;

 private:
  [[nodiscard]] std::optional<BranchPoint> after(const BranchPoint& from, double step, bool exact_direction) const;
  /// The solution in the plane at the length `step` from a point.
  /// @param place  unknowns and λ in that plane, near the solution
  [[nodiscard]] std::optional<BranchPoint> in_plane(const BranchPoint& from, Eigen::VectorXd place,
                                                    bool exact_direction) const;
  [[nodiscard]] BranchPoint before_kink(const BranchPoint& from, double step) const;
  [[nodiscard]] Eigen::VectorXd scale(const Eigen::VectorXd& unknowns) const;

  EvaluateEquations evaluate_;
  ScaleUnknowns scale_unknowns_;
  double parameter_scale_;
  BranchOptions options_;
};

/// Walks along a branch, over its kinks too: where no step leads further, or short steps turn sharply again and again,
/// it returns to the last smooth point and hops from there over the kink.
class BranchWalk {
 public:
  /// @param branch          must outlive it
  /// @param control         shorter steps than `sharp_turns` are not smooth
  /// @param lowest,highest  parameters between which a hop may land
  BranchWalk(const Branch& branch, BranchPoint start, const StepControl& control, double first_step, double lowest,
             double highest);

  [[nodiscard]] const BranchPoint& now() const { return now_; }
  /// Can a later hop begin here? What was found since the last such point is not on the branch if it does.
  [[nodiscard]] bool is_smooth() const { return since_ == 0; }

  struct Step {
    BranchPoint to;
    double length = 0;
    bool hops = false;  ///< now() is the last smooth point again
  };
  /// The next step, not yet taken. Empty if none leads further.
  [[nodiscard]] std::optional<Step> next();
  /// Takes it.
  void go(Step step);
  /// Does not take it: the next one is at most as long as this.
  void shorten(double length) { step_ = length; }

 private:
  [[nodiscard]] std::optional<Step> advance();

  const Branch& branch_;
  StepControl control_;
  double first_step_, lowest_, highest_;
  double step_;
  BranchPoint now_, smooth_;
  double since_ = 0;     ///< length from the last smooth point
  double hopped_ = 0;    ///< of the last hop, until a smooth step follows it
  int sharp_turns_ = 0;  ///< since the last smooth point
};

}  // namespace trivet::numerics
