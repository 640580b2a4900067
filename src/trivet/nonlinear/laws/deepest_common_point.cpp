// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/rubbing_loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::nonlinear {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

using Found = std::optional<DeepestPlace>;

Found of_one(const std::vector<Disc>& discs, std::size_t i) {
  return DeepestPlace{discs[i].center, -discs[i].radius, {{i}}};
}

/// Between two centers, as far beyond the one as beyond the other.
Found of_two(const std::vector<Disc>& discs, std::size_t i, std::size_t j) {
  const Disc &a = discs[i], &b = discs[j];
  const double distance = (b.center - a.center).norm();
  const double from_first = (distance + a.radius - b.radius) / 2;
  if (!(distance > 0 && from_first >= 0 && from_first <= distance)) return std::nullopt;
  const Vector2d along = (b.center - a.center) / distance;
  const Matrix2d same = along * along.transpose(), aside = Matrix2d::Identity() - same;
  const Matrix2d by_second = from_first / distance * aside + same / 2;
  return DeepestPlace{a.center + from_first * along,
                      from_first - a.radius,
                      {{i, Matrix2d::Identity() - by_second, along / 2}, {j, by_second, -along / 2}}};
}

/// |c − u| = t + r for three discs: their differences are linear in c and t.
Found of_three(const std::vector<Disc>& discs, std::size_t i, std::size_t j, std::size_t k) {
  const Disc& a = discs[i];
  Matrix2d left;
  Vector2d right, by_beyond;
  int row = 0;
  for (const std::size_t other : {j, k}) {
    const Disc& b = discs[other];
    const Vector2d apart = b.center - a.center;
    left.row(row) = 2 * apart.transpose();
    right(row) = apart.squaredNorm() - b.radius * b.radius + a.radius * a.radius;
    by_beyond(row) = -2 * (b.radius - a.radius);
    ++row;
  }
  const double determinant = left(0, 0) * left(1, 1) - left(0, 1) * left(1, 0);
  if (std::abs(determinant) <= std::numeric_limits<double>::epsilon() * left.squaredNorm()) return std::nullopt;
  Matrix2d inverse;
  inverse << left(1, 1), -left(0, 1), -left(1, 0), left(0, 0);
  inverse /= determinant;
  const Vector2d fixed = inverse * right, moves = inverse * by_beyond;  // c − u_a = fixed + moves · t
  // |fixed + moves t|² = (t + r)².
  const double square = moves.squaredNorm() - 1, half = fixed.dot(moves) - a.radius,
               constant = fixed.squaredNorm() - a.radius * a.radius;
  const double root = half * half - square * constant;
  if (root < 0) return std::nullopt;
  double beyond = std::numeric_limits<double>::infinity();
  for (const double sign : {-1.0, 1.0}) {
    const double denominator = -half + sign * std::sqrt(root);
    if (const double t = constant / denominator; t + a.radius >= 0 && t < beyond) beyond = t;
  }
  if (!std::isfinite(beyond)) return std::nullopt;
  DeepestPlace found{a.center + fixed + moves * beyond, beyond, {}};
  // n · (δc − δu) = δt + δr for each, with n from its center to the place.
  Matrix3d rows;
  std::vector<Vector2d> directions;
  row = 0;
  for (const std::size_t one : {i, j, k}) {
    const Vector2d apart = found.place - discs[one].center;
    if (!(apart.norm() > 0)) return std::nullopt;
    directions.push_back(apart / apart.norm());
    rows.row(row++) << directions.back().transpose(), -1;
  }
  const numerics::PivotedLu<double> solver{Eigen::MatrixXd(rows)};
  row = 0;
  for (const std::size_t one : {i, j, k}) {
    const Vector2d by = Eigen::VectorXd(solver.solve(Eigen::VectorXd(Vector3d::Unit(row)))).head<2>();
    found.held.push_back({one, by * directions[static_cast<std::size_t>(row)].transpose(), by});
    ++row;
  }
  return found;
}

/// From one disc that is farther away to the next: each time the deepest place in those that hold it and the new one.
/// `beyond` only grows, so that it ends.
DeepestPlace deepest_in_circles(const std::vector<Disc>& discs) {
  assert(!discs.empty() && std::ranges::all_of(discs, [](const Disc& disc) { return !(disc.radius < 0); }));
  double largest = 0;
  for (const Disc& disc : discs) largest = std::max({largest, disc.radius, disc.center.norm()});
  const double round_off = 1e-12 * largest;
  const auto beyond = [&](std::size_t i, const Vector2d& place) {
    return (place - discs[i].center).norm() - discs[i].radius;
  };
  DeepestPlace best = *of_one(discs, 0);
  constexpr int most = 500;
  for (int step = 0; step < most; ++step) {
    std::size_t worst = 0;
    double farthest = best.beyond + round_off;
    for (std::size_t i = 0; i < discs.size(); ++i)
      if (const double by = beyond(i, best.place); by > farthest) {
        farthest = by;
        worst = i;
      }
    if (farthest <= best.beyond + round_off) return best;
    std::vector<std::size_t> with;
    for (const DeepestPlace::Held& held : best.held) with.push_back(held.disc);
    std::vector<Found> choices = {of_one(discs, worst)};
    for (std::size_t a = 0; a < with.size(); ++a) {
      choices.push_back(of_two(discs, worst, with[a]));
      for (std::size_t b = a + 1; b < with.size(); ++b) choices.push_back(of_three(discs, worst, with[a], with[b]));
    }
    const DeepestPlace* next = nullptr;
    for (const Found& choice : choices) {
      if (!choice || (next && choice->beyond >= next->beyond)) continue;
      bool holds = beyond(worst, choice->place) <= choice->beyond + round_off;
      for (const std::size_t one : with) holds = holds && beyond(one, choice->place) <= choice->beyond + round_off;
      if (holds) next = &*choice;
    }
    best.beyond = std::max(best.beyond, farthest);  // of the last place, if there is no better one
    if (!next) return best;
    best = *next;
  }
  return best;
}

}  // namespace

namespace {

Matrix2d inverse_of(const Matrix2d& matrix) {
  Matrix2d adjugate;
  adjugate << matrix(1, 1), -matrix(0, 1), -matrix(1, 0), matrix(0, 0);
  return adjugate / (matrix(0, 0) * matrix(1, 1) - matrix(0, 1) * matrix(1, 0));
}

}  // namespace

/// An ellipse is as deep around a place c as a circle with its center moved along the first axis by (1 − hoop) (c −
/// center): Newton's method for the place that the circles around it have.
DeepestPlace deepest_place(const std::vector<Disc>& discs) {
  DeepestPlace found = deepest_in_circles(discs);
  if (std::ranges::all_of(discs, [](const Disc& disc) { return disc.hoop == 1; })) return found;
  constexpr int most = 50;
  constexpr double accurate = 1e-12;
  double size = 0;
  for (const Disc& disc : discs) size = std::max(size, disc.radius);
  Vector2d place = found.place;
  Matrix2d inverse = Matrix2d::Identity();
  std::vector<Disc> circles = discs;
  bool done = false;
  for (int i = 0; i < most && !done; ++i) {
    for (std::size_t d = 0; d < discs.size(); ++d)
      circles[d].center.x() = discs[d].center.x() + (1 - discs[d].hoop) * (place - discs[d].center).x();
    found = deepest_in_circles(circles);
    Matrix2d left = Matrix2d::Identity();
    for (const DeepestPlace::Held& held : found.held)
      left.col(0) -= (1 - discs[held.disc].hoop) * held.by_center.col(0);
    inverse = inverse_of(left);
    const Vector2d change = inverse * (found.place - place);
    place += change;
    done = change.norm() <= accurate * size;
  }
  found.place = place;
  if (!done) found.beyond = std::numeric_limits<double>::infinity();
  for (DeepestPlace::Held& held : found.held) {
    held.by_hoop = -(place - discs[held.disc].center).x() * inverse * held.by_center.col(0);
    held.by_radius = (inverse * held.by_radius).eval();
    held.by_center.col(0) *= discs[held.disc].hoop;
    held.by_center = (inverse * held.by_center).eval();
  }
  return found;
}

}  // namespace trivet::nonlinear
