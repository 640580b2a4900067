// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/followed_motions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::nonlinear {

using numerics::Branch;
using numerics::BranchPoint;

FollowedMotions::FollowedMotions(const Branch& branch, const std::vector<double>& wanted)
    : branch_(branch), wanted_(wanted) {}

/// The pieces of the step, with the fold between them if the parameter turns, and the requested motions.
void FollowedMotions::add(BranchPoint added, double length) {
  points_.push_back(std::move(added));
  lengths_.push_back(length);
  const std::size_t from = points_.size() - 2, first_new = pieces_.size();
  const BranchPoint &now = points_[from], &next = points_.back();
  const bool turns = next.parameter_direction() * now.parameter_direction() < 0;
  if (turns) {
    const BranchPoint fold = branch_.fold(now, length);
    const double to_fold = Branch::length(now, fold);
    turns_.push_back({fold, from, now.parameter_direction() > 0});
    pieces_.push_back({from, 0, to_fold, now.parameter, fold.parameter});
    pieces_.push_back({from, to_fold, length, fold.parameter, next.parameter});
  } else {
    pieces_.push_back({from, 0, length, now.parameter, next.parameter});
  }
  for (const double wanted : wanted_)
    for (std::size_t i = first_new; i < pieces_.size(); ++i)
      if (std::optional<BranchPoint> there = at(wanted, pieces_[i])) requested_.push_back(std::move(*there));
}

void FollowedMotions::clear() {
  points_.clear();
  requested_.clear();
  lengths_.clear();
  corners_.clear();
  turns_.clear();
  pieces_.clear();
}

void FollowedMotions::remove_turns_of_round_off() {
  constexpr double round_off = 1e-10;  // of the scale of the parameter; Newton's method leaves 1e-11
  if (turns_.empty()) return;
  const double least = round_off * points_.front().scale(points_.front().scale.size() - 1);
  const auto parameter_of = [](const Turn& turn) { return turn.point.parameter; };
  std::vector<Turn> kept;
  for (Turn& turn : turns_) {
    if (!kept.empty() && std::abs(parameter_of(kept.back()) - parameter_of(turn)) <= least) kept.pop_back();
    else if (kept.empty() && std::abs(points_.front().parameter - parameter_of(turn)) <= least) continue;
    else kept.push_back(std::move(turn));
  }
  while (!kept.empty() && std::abs(points_.back().parameter - parameter_of(kept.back())) <= least) kept.pop_back();
  turns_ = std::move(kept);
}

BranchPoint FollowedMotions::reversed(BranchPoint point) {
  point.tangent = -point.tangent;
  point.bend.resize(0);
  return point;
}

void FollowedMotions::reverse_and_append(const FollowedMotions& onward) {
  std::vector<BranchPoint> all;
  for (std::size_t i = points_.size() - 1; i > 0; --i) all.push_back(reversed(points_[i]));
  all.insert(all.end(), onward.points_.begin(), onward.points_.end());
  std::vector<double> lengths(lengths_.rbegin(), lengths_.rend()), corners(corners_.rbegin(), corners_.rend());
  lengths.insert(lengths.end(), onward.lengths_.begin(), onward.lengths_.end());
  corners.insert(corners.end(), onward.corners_.begin(), onward.corners_.end());
  clear();
  corners_ = std::move(corners);
  begin(all.front());
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double length = Branch::length(points_.back(), all[i]);
    add(all[i], length > 0 ? length : lengths[i - 1]);  // over a kink it has the length of the hop
  }
}

void FollowedMotions::cut_to(const Extent& end) {
  points_.erase(points_.begin() + to_index(end.points), points_.end());
  lengths_.resize(end.points - 1);
  requested_.erase(requested_.begin() + to_index(end.requested), requested_.end());
  turns_.erase(turns_.begin() + to_index(end.turns), turns_.end());
  pieces_.erase(pieces_.begin() + to_index(end.pieces), pieces_.end());
}

bool FollowedMotions::split_step(std::size_t after) {
  std::optional<BranchPoint> middle = branch_.after(points_[after], lengths_[after] / 2);
  if (!middle) return false;
  const auto place = static_cast<std::ptrdiff_t>(after) + 1;
  const auto piece = std::ranges::find(pieces_, after, &Piece::from);
  const double first = Branch::length(points_[after], *middle), second = Branch::length(*middle, points_[after + 1]);
  const Piece latter{after, 0, second, middle->parameter, piece->parameter_end};
  *piece = {after, 0, first, piece->parameter_begin, middle->parameter};
  // Its indices are those before the new point, like those of the pieces after it.
  for (auto one = pieces_.insert(piece + 1, latter); one != pieces_.end(); ++one) ++one->from;
  for (Turn& turn : turns_)
    if (turn.after > after) ++turn.after;
  lengths_[after] = first;
  lengths_.insert(lengths_.begin() + place, second);
  points_.insert(points_.begin() + place, std::move(*middle));
  return true;
}

std::optional<BranchPoint> FollowedMotions::at(double parameter, const Piece& piece) const {
  if ((piece.parameter_begin < parameter) == (piece.parameter_end < parameter)) return std::nullopt;
  const bool is_whole_step = piece.begin == 0 && piece.end == lengths_[piece.from];
  return is_whole_step ? branch_.at(parameter, points_[piece.from], points_[piece.from + 1])
                       : branch_.at(parameter, points_[piece.from], piece.begin, piece.end);
}

std::vector<BranchPoint> FollowedMotions::all_at(double parameter) const {
  std::vector<BranchPoint> found;
  for (const Piece& piece : pieces_)
    if (std::optional<BranchPoint> there = at(parameter, piece)) found.push_back(std::move(*there));
  return found;
}

using Eigen::VectorXd;
using numerics::BranchPoint;

namespace {

constexpr numerics::StepControl raising_steps{.sharp_turns = 1e-4};

/// The solution at parameter 1 on the branch of a point.
std::optional<BranchPoint> followed_to_one(const numerics::Branch& branch, std::optional<BranchPoint> now) {
  double step = 0.01;
  constexpr int most_points = 2000;
  for (int i = 0; now && i < most_points; ++i) {
    const std::optional<numerics::Branch::Advance> advance = branch.advance(*now, step, raising_steps);
    if (!advance) return std::nullopt;
    if (advance->to.parameter > 1) return branch.at(1, *now, 0, advance->length);
    now = advance->to;
  }
  return std::nullopt;
}

std::optional<BranchPoint> at_small_load(const SteadyEquations& equations, const numerics::Branch& over_load,
                                         double parameter) {
  constexpr double small = 1e-3;
  const Driving whole = equations.driving(parameter);
  return over_load.start(equations.balance().linear_motion({whole.omega, small * whole.factor}), small);
}

}  // namespace

std::optional<BranchPoint> first_motion(const SteadyEquations& equations, const numerics::Branch& branch,
                                        double parameter) {
  const VectorXd linear = equations.balance().linear_motion(equations.driving(parameter));
  if (std::optional<BranchPoint> found = branch.start(linear, parameter)) return found;
  const numerics::Branch over_load = equations.over_load(parameter);
  if (const auto raised = followed_to_one(over_load, at_small_load(equations, over_load, parameter)))
    if (std::optional<BranchPoint> found = branch.start(raised->unknowns, parameter)) return found;
  const numerics::Branch over_forces = equations.over_nonlinear_forces(parameter);
  if (const auto raised = followed_to_one(over_forces, over_forces.start(linear, 0)))
    if (std::optional<BranchPoint> found = branch.start(raised->unknowns, parameter)) return found;
  // A force that jumps as friction breaks away cannot be raised.
  for (const double larger : {1.5, 2.0, 3.0, 5.0})
    if (std::optional<BranchPoint> found = branch.start(larger * linear, parameter)) return found;
  return std::nullopt;
}

std::vector<BranchPoint> motions_over_load(const SteadyEquations& equations, const numerics::Branch& branch,
                                           double parameter, double most_load) {
  const numerics::Branch over_load = equations.over_load(parameter);
  constexpr int most_points = 600;
  std::vector<BranchPoint> found;
  std::optional<BranchPoint> now = at_small_load(equations, over_load, parameter);
  double step = 0.02;
  for (int i = 0; now && i < most_points && std::abs(now->parameter) < most_load; ++i) {
    const std::optional<numerics::Branch::Advance> advance = over_load.advance(*now, step, raising_steps);
    if (!advance) break;
    if ((now->parameter < 1) != (advance->to.parameter < 1))
      if (const std::optional<BranchPoint> there = over_load.at(1, *now, 0, advance->length))
        if (std::optional<BranchPoint> motion = branch.start(there->unknowns, parameter))
          found.push_back(std::move(*motion));
    now = advance->to;
  }
  return found;
}

}  // namespace trivet::nonlinear
