// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/branch.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/linalg/reduced_lu.h"

namespace trivet::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// [∂r/∂u ∂r/∂λ; alongᵀ] with columns times the scale.
MatrixXd bordered(const Equations& equations, const VectorXd& scale, const VectorXd& along) {
  const Index n = equations.value.size();
  MatrixXd matrix(n + 1, n + 1);
  for (Index j = 0; j < n; ++j) matrix.col(j).head(n) = scale(j) * equations.by_unknowns.col(j);
  matrix.col(n).head(n) = scale(n) * equations.by_parameter;
  matrix.bottomRows<1>() = along.transpose();
  return matrix;
}

}  // namespace

VectorXd BranchPoint::way_to(const VectorXd& other, double other_parameter) const {
  VectorXd way(scale.size());
  way << other - unknowns, other_parameter - parameter;
  return way.cwiseQuotient(scale);
}

/// All unknowns share the largest, unless they are smaller than their own smallest scale.
Branch::Branch(EvaluateEquations evaluate, VectorXd smallest_scale, double parameter_scale, BranchOptions options)
    : Branch(
          std::move(evaluate), parameter_scale,
          [smallest = std::move(smallest_scale)](const VectorXd& unknowns) {
            return VectorXd(smallest.cwiseMax(unknowns.size() > 0 ? unknowns.cwiseAbs().maxCoeff() : 0.0));
          },
          options) {}

Branch::Branch(EvaluateEquations evaluate, double parameter_scale, ScaleUnknowns scale, BranchOptions options)
    : evaluate_(std::move(evaluate)),
      scale_unknowns_(std::move(scale)),
      parameter_scale_(parameter_scale),
      options_(options) {}

VectorXd Branch::scale(const VectorXd& unknowns) const {
  VectorXd result(unknowns.size() + 1);
  result << scale_unknowns_(unknowns), parameter_scale_;
  return result;
}

namespace {

ReducedLu factored(const MatrixXd& bordered) { return {bordered, ReducedLu::Border::last_row}; }

/// The direction of the branch at a point, by the factors of its bordered matrix with columns times `scale`. They are
/// those of the last Newton step, which changed the point by less than its tolerance.
bool set_direction(BranchPoint& point, const ReducedLu& factors, const VectorXd& scale) {
  VectorXd right = VectorXd::Zero(scale.size());
  right(right.size() - 1) = 1;
  const VectorXd tangent = factors.solve(right).cwiseProduct(scale).cwiseQuotient(point.scale);
  if (!tangent.allFinite()) return false;
  point.tangent = tangent.normalized();
  return true;
}

}  // namespace

namespace {

/// Do Newton steps no longer shrink, because round-off of the equations is larger than the tolerance?
bool is_round_off(double size, double before) {
  constexpr double small = 1e-8, shrinks = 0.3;
  return size < small && before < small && size > shrinks * before;
}

}  // namespace

std::optional<BranchPoint> Branch::start(const VectorXd& guess, double parameter, bool downwards) const {
  BranchPoint point{guess, parameter, scale(guess), {}, 0};
  Equations equations;
  bool done = false;
  for (double last = 1; !done; ++point.iterations) {
    if (point.iterations == options_.most_iterations) return std::nullopt;
    evaluate_(point.unknowns, parameter, equations);
    const VectorXd change = ReducedLu(equations.by_unknowns, ReducedLu::Border::none).solve(equations.value);
    if (!change.allFinite()) return std::nullopt;
    point.unknowns -= change;
    point.scale = scale(point.unknowns);
    const double size = change.cwiseQuotient(point.scale.head(change.size())).norm();
    done = size <= options_.tolerance || is_round_off(size, last);
    last = size;
  }
  VectorXd along = VectorXd::Zero(guess.size() + 1);
  along(guess.size()) = downwards ? -1 : 1;
  evaluate_(point.unknowns, parameter, equations);
  if (!set_direction(point, factored(bordered(equations, point.scale, along)), point.scale)) return std::nullopt;
  return point;
}

std::optional<BranchPoint> Branch::after(const BranchPoint& from, double step) const {
  return after(from, step, false);
}

std::optional<BranchPoint> Branch::after(const BranchPoint& from, double step, bool exact_direction) const {
  VectorXd place(from.unknowns.size() + 1);
  place << from.unknowns, from.parameter;
  place += step * from.tangent.cwiseProduct(from.scale);
  if (from.bend.size() > 0) place += step * step / 2 * from.bend.cwiseProduct(from.scale);
  return in_plane(from, std::move(place), exact_direction);
}

std::optional<BranchPoint> Branch::in_plane(const BranchPoint& from, VectorXd place, bool exact_direction) const {
  constexpr double farthest = 10;          // in scaled lengths, of which steps are a small part: another branch
  constexpr double good_direction = 1e-5;  // that of the place before such a step
  const Index n = from.unknowns.size();
  Equations equations;
  BranchPoint point;
  std::optional<ReducedLu> factors;
  bool done = false, by_last_factors = false;
  for (double last = 1; !done; ++point.iterations) {
    if (point.iterations == options_.most_iterations) return std::nullopt;
    equations.value_only = by_last_factors;
    evaluate_(place.head(n), place(n), equations);
    VectorXd right = VectorXd::Zero(n + 1);
    right.head(n) = equations.value;  // the place already has its length along the tangent
    if (!by_last_factors) factors.emplace(bordered(equations, from.scale, from.tangent), ReducedLu::Border::last_row);
    const VectorXd change = factors->solve(right);
    if (!change.allFinite() || change.norm() > farthest) return std::nullopt;
    place -= change.cwiseProduct(from.scale);
    // The next step would be smaller by the same factor at least; the direction is that of the factors.
    const double size = change.norm();
    const bool is_near = !exact_direction && point.iterations > 0 && size <= good_direction;
    done = size <= options_.tolerance || (!by_last_factors && is_round_off(size, last)) ||
        (is_near && size * size <= options_.tolerance * last);
    // So near the factors hardly change. Where they do, beside a kink, new ones are taken.
    constexpr double shrinks = 0.1;
    by_last_factors = is_near && (!by_last_factors || size <= shrinks * last);
    last = size;
  }
  point.unknowns = place.head(n);
  point.parameter = place(n);
  point.scale = scale(point.unknowns);
  if (!set_direction(point, *factors, from.scale)) return std::nullopt;
  return point;
}

namespace {

/// By the directions at both ends of a step.
void set_bend(const BranchPoint& from, double step, BranchPoint& to) {
  const VectorXd before = from.tangent.cwiseProduct(from.scale).cwiseQuotient(to.scale).normalized();
  to.bend = (to.tangent - before) / step;
  to.bend -= to.bend.dot(to.tangent) * to.tangent;
}

}  // namespace

std::optional<Branch::Advance> Branch::advance(const BranchPoint& from, double& step,
                                               const StepControl& control) const {
  constexpr int easy = 4;  // Newton steps
  const auto is_good = [&](const BranchPoint& to) {
    const double cosine = from.tangent.dot(to.tangent.cwiseProduct(to.scale).cwiseQuotient(from.scale).normalized());
    if (cosine > control.least_cosine) return step < control.hidden_folds || !hides_folds(from, to, step);
    return step < control.sharp_turns && orientation(to) == orientation(from);  // else it is beside the branch
  };
  for (; step >= control.shortest; step /= 2) {
    std::optional<BranchPoint> to = after(from, step);
    if (!to || !is_good(*to)) continue;
    Advance found{std::move(*to), step};
    set_bend(from, step, found.to);
    if (found.to.iterations <= easy) step = std::min(control.longest, control.growth * step);
    return found;
  }
  return std::nullopt;
}

std::optional<Branch::Advance> Branch::beyond_kink(const BranchPoint& from, double least, double lowest,
                                                   double highest) const {
  constexpr double close = 0.02;
  const int along = orientation(from);
  if (along == 0) return std::nullopt;
  const double sense = from.parameter_direction() < 0 ? -1 : 1;
  // From the point itself, a solution behind it is found first, or, at a contact that is half closed, none: also from
  // one that has it closed, and open. λ may turn at the kink.
  for (const double towards : {sense, -sense})
    for (const double share : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
      const double parameter = std::clamp(from.parameter + towards * share * parameter_scale_, lowest, highest);
      if (parameter == from.parameter) continue;
      for (const double size : {1.0, 1.001, 0.999}) {
        std::optional<BranchPoint> there = start(size * from.unknowns, parameter);
        if (!there) continue;
        const int found = orientation(*there);
        if (found == 0) continue;
        if (found != along) there->tangent = -there->tangent;
        const VectorXd way = from.way_to(there->unknowns, there->parameter);
        const double away = way.norm();
        // Before the kink, the way to a solution is against the direction that the branch has there.
        if (away >= least && away <= close && way.dot(there->tangent) > 0) return Advance{*there, away};
      }
    }
  return std::nullopt;
}

int Branch::orientation(const BranchPoint& point) const {
  Equations equations;
  evaluate_(point.unknowns, point.parameter, equations);
  return factored(bordered(equations, point.scale, point.tangent)).determinant_sign();
}

double Branch::length(const BranchPoint& from, const BranchPoint& to) {
  return from.tangent.dot(from.way_to(to.unknowns, to.parameter));
}

bool Branch::hides_folds(const BranchPoint& from, const BranchPoint& to, double step) {
  const double scale = from.scale(from.scale.size() - 1), rise = (to.parameter - from.parameter) / scale;
  const double at_from = step * from.parameter_direction(), at_to = step * to.parameter_direction();
  if (at_from * at_to <= 0) return false;
  constexpr double round_off = 1e-8;  // λ stays the same across the step
  if (std::abs(at_from) + std::abs(at_to) + std::abs(rise) < round_off * std::abs(step)) return false;
  // slope (1 − t)² a + t² b + 2 t (1 − t) c, by its values at the ends and the rise between them
  const double sign = at_from > 0 ? 1 : -1, a = sign * at_from, b = sign * at_to, c = 3 * sign * rise - a - b;
  return c < 0 && c * c >= a * b;
}

namespace {

/// Unknowns and λ at a length from a point along its tangent, by Hermite's cubic through two solutions at other lengths
/// with their directions. Empty if one of them has its direction in such a plane.
std::optional<VectorXd> by_cubic(const BranchPoint& from, double place, const BranchPoint& a, double at_a,
                                 const BranchPoint& b, double at_b) {
  constexpr double least_rise = 1e-2;  // of the length along the tangent by that along the branch
  const Index n = from.unknowns.size();
  const double length = at_b - at_a, t = (place - at_a) / length;
  const auto value = [&](const BranchPoint& point) {
    VectorXd all(n + 1);
    all << point.unknowns, point.parameter;
    return all;
  };
  const auto by_length = [&](const BranchPoint& point) -> std::optional<VectorXd> {
    const VectorXd along = point.tangent.cwiseProduct(point.scale);
    const double rise = from.tangent.dot(along.cwiseQuotient(from.scale));
    if (std::abs(rise) < least_rise) return std::nullopt;
    return VectorXd(along / rise);
  };
  const std::optional<VectorXd> slope_a = by_length(a), slope_b = by_length(b);
  if (!slope_a || !slope_b) return std::nullopt;
  const VectorXd first = value(a);
  return VectorXd(first + t * t * (3 - 2 * t) * (value(b) - first) +
                  t * (1 - t) * length * ((1 - t) * *slope_a - t * *slope_b));
}

}  // namespace

std::optional<BranchPoint> Branch::zero(const std::function<double(const BranchPoint&)>& quantity,
                                        const BranchPoint& from, double low, double high, double accurate,
                                        bool exact_direction) const {
  constexpr int most = 60;
  constexpr double round_off = 1e-14;
  const auto at = [&](double place) { return place == 0 ? std::optional(from) : after(from, place, exact_direction); };
  std::optional<BranchPoint> begin = at(low), found = at(high);
  if (!begin || !found) return std::nullopt;
  double at_low = quantity(*begin), at_high = quantity(*found);
  if (!(at_low * at_high <= 0)) return std::nullopt;
  const double range = std::abs(high - low);
  for (int i = 0; i < most && std::abs(at_high) > accurate && std::abs(high - low) > round_off * range; ++i) {
    const double place = (low * at_high - high * at_low) / (at_high - at_low);
    // Between two solutions Newton's method has half of the way less than from the point.
    std::optional<BranchPoint> next;
    if (std::optional<VectorXd> guess = by_cubic(from, place, *begin, low, *found, high))
      next = in_plane(from, *std::move(guess), exact_direction);
    if (!next) next = at(place);
    if (!next) return std::nullopt;
    const double value = quantity(*next);
    if (!std::isfinite(value)) return std::nullopt;
    if (value * at_high > 0) {
      at_low /= 2;
    } else {
      low = high;
      at_low = at_high;
      begin = std::move(found);
    }
    high = place;
    at_high = value;
    found = std::move(next);
  }
  return found;
}

std::optional<BranchPoint> Branch::at(double parameter, const BranchPoint& from, double low, double high) const {
  constexpr double near = 1e-10;  // of the scale of λ: Newton's method at fixed λ does the rest
  const std::optional<BranchPoint> middle = zero([&](const BranchPoint& point) { return point.parameter - parameter; },
                                                 from, low, high, near * parameter_scale_);
  if (!middle) return std::nullopt;
  std::optional<BranchPoint> exact = start(middle->unknowns, parameter);
  constexpr double same = 1e-3;
  if (!exact ||
      (exact->unknowns - middle->unknowns).cwiseQuotient(middle->scale.head(middle->unknowns.size())).norm() > same)
    return std::nullopt;
  return exact;
}

namespace {

/// Solutions between two points by Hermite's cubic over the length between them.
class CubicBetween {
 public:
  CubicBetween(const BranchPoint& from, const BranchPoint& to, double length)
      : from_(from), to_(to), length_(length), n_(from.unknowns.size()) {}
  [[nodiscard]] double parameter(double share) const {
    return value(share, from_.parameter, to_.parameter, slope(from_, n_), slope(to_, n_));
  }
  [[nodiscard]] VectorXd unknowns(double share) const {
    VectorXd result(n_);
    for (Index i = 0; i < n_; ++i)
      result(i) = value(share, from_.unknowns(i), to_.unknowns(i), slope(from_, i), slope(to_, i));
    return result;
  }

 private:
  [[nodiscard]] double slope(const BranchPoint& at, Index i) const { return length_ * at.tangent(i) * at.scale(i); }
  static double value(double t, double a, double b, double at_a, double at_b) {
    return a + t * t * (3 - 2 * t) * (b - a) + t * (1 - t) * ((1 - t) * at_a - t * at_b);
  }
  const BranchPoint &from_, &to_;
  double length_;
  Index n_;
};

}  // namespace

std::optional<BranchPoint> Branch::at(double parameter, const BranchPoint& from, const BranchPoint& to) const {
  const double length = Branch::length(from, to);
  const CubicBetween cubic(from, to, length);
  double low = 0, high = 1;
  const bool rises = to.parameter > from.parameter;
  constexpr double near = 1e-9;
  while (high - low > near) {
    const double middle = (low + high) / 2;
    ((cubic.parameter(middle) < parameter) == rises ? low : high) = middle;
  }
  const VectorXd guess = cubic.unknowns(low);
  std::optional<BranchPoint> found = start(guess, parameter);
  constexpr double same = 0.03;  // of the step: the error of the cubic
  if (found && (found->unknowns - guess).cwiseQuotient(from.scale.head(guess.size())).norm() < same * length)
    return found;
  return at(parameter, from, 0, length);
}

BranchPoint Branch::fold(const BranchPoint& from, double step) const {
  constexpr double flat = 1e-12;  // λ then differs from the fold by less than 1e-24 of its curvature's scale
  std::optional<BranchPoint> smooth =
      zero([](const BranchPoint& point) { return point.parameter_direction(); }, from, 0, step, flat, true);
  return smooth ? std::move(*smooth) : before_kink(from, step);
}

/// The last solution at which λ still changes as at a point, between it and the length `step` from it.
BranchPoint Branch::before_kink(const BranchPoint& from, double step) const {
  constexpr double round_off = 1e-12;
  BranchPoint last = from;
  double beyond = step;
  for (double before = 0; std::abs(beyond - before) > round_off * std::abs(step);) {
    const double middle = (before + beyond) / 2;
    std::optional<BranchPoint> there = after(from, middle, true);
    if (there && there->parameter_direction() * from.parameter_direction() > 0) {
      last = std::move(*there);
      before = middle;
    } else {
      beyond = middle;
    }
  }
  return last;
}

}  // namespace trivet::numerics
