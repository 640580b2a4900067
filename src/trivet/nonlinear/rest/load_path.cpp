// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rest/load_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/periodic/branch.h"
#include "trivet/numerics/search/zeros_and_minima.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using numerics::BranchPoint;

namespace {

/// Of laws at their deflections at rest.
model::System without_built_in_forces(const model::System& linear) {
  model::Description description = linear.description();
  for (model::Element& element : description.elements)
    if (element.law.nonlinear) {
      element.law.nonlinear->offset.setZero();
      element.law.nonlinear->inner_offset.setZero();
    }
  return linear.in_other_state(std::move(description));
}

/// Forces on all deflections without any deflection, without signs.
VectorXd built_in_forces(const model::System& undeformed, Index count) {
  VectorXd found = VectorXd::Zero(count);
  Index next = 0;
  for (const model::Element& element : undeformed.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts)
      found(next++) = std::abs(elements::force_at_rest(part.laws, 0).force);
  for (const model::Element& element : undeformed.elements())
    for (const model::DistancePart& part : element.distance_parts) {
      const Eigen::Vector3d none = Eigen::Vector3d::Zero();
      found.segment<3>(next) = elements::force_in_motion(part.law, none, none).force.cwiseAbs();
      next += 3;
    }
  assert(next <= count && "friction of stops, which comes last, has no built-in force");
  return found;
}

}  // namespace

LoadPath::LoadPath(const model::System& undeformed) {
  const References references = positive_references(undeformed);
  const model::System linear = with_references(undeformed, references);
  const assembly::Assembled assembled = assembly::assemble_first_order(linear);
  deflections_ = nonlinear_deflections(linear, assembled, references);
  add_rubbings(linear, assembled, deflections_);
  const Index count = to_index(deflections_.size());
  stiffness_ = assembled.matrices.K;
  across_.resize(stiffness_.rows(), count);
  references_ = VectorXd::Zero(count);  // distances are held by their tangents alone
  for (Index j = 0; j < count; ++j) {
    across_.col(j) = deflections_[j].on_coordinates;
    if (to_size(j) < references.parts.size()) references_(j) = references.parts[j].stiffness;
  }
  load_ = assembly::static_load(linear, assembled);
  const numerics::PivotedLu<double> stiffness(stiffness_);
  constexpr double singular = 1e-13;
  if (!(stiffness.reciprocal_condition() > singular)) {
    if (load_.isZero(0)) return;
    throw foundation::NotComputable(
        "static: the machine is free to move, so it has no position of rest; hold it by another element, or give a "
        "strut "
        "a free_length with which it is tensioned");
  }
  receptance_ = across_.transpose() * stiffness.solve(across_);
  sizes_.emplace(deflections_, receptance_);
  const VectorXd displacement = stiffness.solve(load_);
  linear_ = across_.transpose() * displacement;
  of_load_ = across_.transpose() * stiffness.solve(assembly::static_load(without_built_in_forces(linear), assembled));
  typical_ = of_load_.cwiseAbs() + receptance_.cwiseAbs() * built_in_forces(undeformed, count);
  // A load across a deflection does not move it; nor does one that built-in forces just bear.
  constexpr double round_off = 1e-12;
  for (Index j = 0; j < count; ++j)
    loaded_ = loaded_ || std::abs(linear_(j)) > round_off * (across_.col(j).norm() * displacement.norm() + typical_(j));
}

LoadPath::Forces LoadPath::forces(const VectorXd& deflections) const {
  const Index count = deflections.size();
  assert(count == to_index(deflections_.size()));
  Forces found{VectorXd::Zero(count), MatrixXd::Zero(count, count)};
  for (Index j = 0; j < count; ++j) {
    const Deflection& deflection = deflections_[j];
    const elements::ForceAndTangent single = deflection.law.at_rest(deflections(j));
    found.force(j) += single.force;
    found.tangent(j, j) += single.tangent;
    if (deflection.rubbing) {  // bears no force at rest
      const Eigen::Matrix3d own = deflection.rubbing->law.own_stiffness();
      const Index own_first = deflection.rubbing->law.is_ring() ? 0 : 1, size = 3 - own_first;
      found.force.segment(j, size) -= own.bottomRightCorner(size, size) * deflections.segment(j, size);
      found.tangent.block(j, j, size, size) -= own.bottomRightCorner(size, size);
    }
    if (!deflection.distance) continue;
    const elements::SpatialForce spatial = deflection.distance->at(deflections.segment<3>(j), Eigen::Vector3d::Zero());
    found.force.segment<3>(j) += spatial.force;
    found.tangent.block<3, 3>(j, j) += spatial.by_deflection;
  }
  return found;
}

void LoadPath::evaluate(const VectorXd& deflections, const VectorXd& missing, numerics::Equations& equations) const {
  const Index count = deflections.size();
  const Forces found = forces(deflections);
  equations.value = deflections + receptance_ * found.force - (linear_ - missing);
  equations.by_unknowns = MatrixXd::Identity(count, count) + receptance_ * found.tangent;
}

std::optional<VectorXd> LoadPath::only_one() const {
  if (!std::ranges::all_of(deflections_, [](const Deflection& d) { return d.law.is_monotone() && !d.distance; }))
    return std::nullopt;
  if (std::optional<VectorXd> at_once = solved(linear_, 0)) return at_once;
  std::optional<Forced> found = Forced{linear_, VectorXd::Zero(linear_.size())};
  for (const double held : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0.0}) {
    found = least_energy(std::move(*found), held);
    if (!found) return std::nullopt;
  }
  return found->deflections;
}

std::optional<LoadPath::Forced> LoadPath::least_energy(Forced now, double held) const {
  constexpr int most = 200;
  constexpr double accurate = 1e-13, beyond = 0.1;
  const Index count = linear_.size();
  const auto forces = [&](const VectorXd& deflections) {
    return VectorXd(held * references_.cwiseProduct(deflections) + this->forces(deflections).force);
  };
  for (int i = 0; i < most; ++i) {
    MatrixXd tangents = this->forces(now.deflections).tangent;
    tangents.diagonal() += held * references_;
    const VectorXd missing = forces(now.deflections) - now.forces;
    const MatrixXd matrix = MatrixXd::Identity(count, count) + tangents * receptance_;
    const VectorXd more = numerics::PivotedLu<double>(matrix).solve(missing), change = -(receptance_ * more);
    if (!change.allFinite()) return std::nullopt;
    if (change.norm() <= accurate * std::max(now.deflections.norm(), typical_.norm())) return now;
    // Slope of the energy along the step.
    const auto slope = [&](double step) {
      return (forces(now.deflections + step * change) - now.forces - step * more).dot(change);
    };
    const double first = slope(0), last = slope(1);
    if (!(first < 0) || !std::isfinite(last)) return std::nullopt;
    const double step = last > -beyond * first ? numerics::zero_between(0, 1, slope) : 1;
    now.deflections += step * change;
    now.forces += step * more;
  }
  return std::nullopt;
}

bool LoadPath::is_zero_change(const VectorXd& change, const VectorXd& of) const {
  constexpr double accurate = 1e-13;
  return change.norm() <= accurate * std::max(of.norm(), typical_.norm());
}

std::optional<VectorXd> LoadPath::solved(VectorXd now, double held) const {
  return solved(std::move(now), held, VectorXd::Zero(linear_.size()));
}

/// Where no stiffness acts in a direction, it does not move in that direction.
std::optional<VectorXd> LoadPath::solved(VectorXd now, double held, const VectorXd& missing) const {
  constexpr int most = 100;
  constexpr double least_step = 1e-6;
  const MatrixXd added = held * receptance_ * references_.asDiagonal();
  numerics::Equations equations;
  const auto at = [&](const VectorXd& deflections) {
    evaluate(deflections, missing, equations);
    equations.value += added * deflections;
    equations.by_unknowns += added;
  };
  at(now);
  for (int i = 0; i < most; ++i) {
    VectorXd change = -numerics::PivotedLu<double>(equations.by_unknowns).solve(equations.value);
    if (!change.allFinite()) change = -numerics::smallest_solution(equations.by_unknowns, equations.value);
    if (!change.allFinite()) return std::nullopt;
    const double before = equations.value.norm();
    if (is_zero_change(change, now)) {
      constexpr double solves = 1e-9;  // else it is in a hollow of the forces
      if (before > solves * std::max(now.norm(), typical_.norm())) return std::nullopt;
      return VectorXd(now + change);
    }
    double step = 1;
    for (;; step /= 2) {
      at(now + step * change);
      if (equations.value.norm() < before || step < least_step) break;
    }
    now += step * change;
  }
  return std::nullopt;
}

std::pair<VectorXd, std::vector<double>> LoadPath::followed() const {
  Followed found = followed(of_load_, false);
  if (!found.deflections && of_load_ != linear_)
    if (Followed together = followed(linear_, false); together.deflections || !found.starts)
      found = std::move(together);
  // From an unstable position without load, the machine may leave to either side.
  for (const VectorXd& growing : {of_load_, linear_})
    if (!found.deflections)
      if (Followed other_side = followed(growing, true); other_side.deflections) found = std::move(other_side);
  if (found.deflections) return {std::move(*found.deflections), std::move(found.turns)};
  if (std::optional<VectorXd> fallen = released()) return {std::move(*fallen), {}};
  throw foundation::NotComputable(fmt::format(
      "static: no position of rest was found: the load can be raised to {:.4g} of its whole only", found.highest));
}

VectorXd LoadPath::scale(const VectorXd& deflections) const {
  constexpr double smallest = 1e-3;
  return sizes_->largest_of_kind(deflections.cwiseAbs().cwiseMax(smallest * typical_));
}

/// The directions of the path are those which [∂r/∂δ ∂r/∂λ] does not change: of them the one along which the load grows
/// most. If none changes it, because nothing is stiff against it, the one in which the load does most work.
std::optional<BranchPoint> LoadPath::start(const VectorXd& growing, bool other_side) const {
  const Index n = linear_.size();
  std::optional<VectorXd> without = VectorXd(VectorXd::Zero(n));
  if (growing != linear_) without = solved(*without, 0, growing);
  if (!without) return std::nullopt;
  BranchPoint found{*without, 0, VectorXd(n + 1), {}, 0};
  found.scale << scale(*without), 1;
  numerics::Equations equations;
  evaluate(*without, growing, equations);
  MatrixXd rows(n, n + 1);
  rows << equations.by_unknowns, -growing;
  const VectorXd sizes = found.scale.head(n);
  rows = (sizes.cwiseInverse().asDiagonal() * rows * found.scale.asDiagonal()).eval();
  constexpr double round_off = 1e-12, none = 1e-6;
  const numerics::PivotedQr factors = numerics::pivoted_qr(rows.transpose(), round_off);
  const MatrixXd changing = factors.Q.leftCols(factors.rank);
  const auto unchanging = [&](const VectorXd& direction) {
    return VectorXd(direction - changing * (changing.transpose() * direction));
  };
  found.tangent = unchanging(VectorXd::Unit(n + 1, n));
  if (found.tangent.norm() < none) {
    VectorXd work = VectorXd::Zero(n + 1);
    work.head(n) = growing.cwiseQuotient(sizes);
    found.tangent = unchanging(work.normalized());
  }
  if (found.tangent.norm() < none) return growing.isZero(0) ? std::optional(found) : std::nullopt;
  assert((sizes.array() > 0).all() && "of kinds that move");
  found.tangent.normalize();
  if (other_side) found.tangent = -found.tangent;
  return found;
}

LoadPath::Followed LoadPath::followed(const VectorXd& growing, bool other_side) const {
  constexpr numerics::StepControl control{.longest = 0.5,
                                          .shortest = 1e-10,
                                          .growth = 1.5,
                                          .least_cosine = 0.9,
                                          .hidden_folds = 1e-4,
                                          .sharp_turns = 1e-4};  // a stop closes
  constexpr int most_points = 5000;
  const numerics::Branch branch(
      [&](const VectorXd& unknowns, double share, numerics::Equations& equations) {
        evaluate(unknowns, (1 - share) * growing, equations);
        equations.by_parameter = -growing;
      },
      1.0, [&](const VectorXd& unknowns) { return scale(unknowns); });
  Followed found;
  const std::optional<BranchPoint> start = this->start(growing, other_side);
  const bool builds_in = growing != linear_;
  found.starts = start && !(builds_in && !is_stable(start->unknowns));
  if (!found.starts) return found;
  if (growing.isZero(0)) {
    found.deflections = start->unknowns;
    return found;
  }
  constexpr double first_step = 0.05;
  numerics::BranchWalk walk(branch, *start, control, first_step, -foundation::infinity, 1);
  std::size_t turns_before = 0;  // at the last smooth point
  for (int i = 0; i < most_points; ++i) {
    std::optional<numerics::BranchWalk::Step> step = walk.next();
    if (!step) break;
    if (step->hops) found.turns.resize(turns_before);
    const BranchPoint& now = walk.now();
    const bool turns_back = step->to.parameter_direction() < 0 && now.parameter_direction() > 0;
    std::optional<BranchPoint> fold;
    if (turns_back) fold = branch.fold(now, step->length);
    const double reached = fold ? fold->parameter : step->to.parameter,
                 rising_to = fold ? numerics::Branch::length(now, *fold) : step->length;
    if (reached >= 1) {
      if (const std::optional<BranchPoint> whole = branch.at(1, now, 0, rising_to)) {
        found.deflections = whole->unknowns;
        return found;
      }
      walk.shorten(step->length / 2);
      continue;
    }
    found.highest = std::max(found.highest, reached);
    if (fold) found.turns.push_back(fold->parameter);
    walk.go(std::move(*step));
    if (walk.is_smooth()) turns_before = found.turns.size();
  }
  return found;
}

bool LoadPath::are_known(const VectorXd& deflections) const {
  const auto is_within = [](double value, const std::pair<double, double>& range) {
    return value >= range.first && value <= range.second;
  };
  for (Index j = 0; j < deflections.size(); ++j) {
    const Deflection& one = deflections_[j];
    if (one.distance ? !is_within(one.distance->distance(deflections.segment<3>(j)), one.distance->range())
                     : !is_within(deflections(j), one.law.range()))
      return false;
  }
  return true;
}

bool LoadPath::is_stable(const VectorXd& deflections) const {
  return is_positive(stiffness_ + across_ * forces(deflections).tangent * across_.transpose(), stiffness_);
}

bool is_positive(const MatrixXd& stiffness, const MatrixXd& typical) {
  assert(stiffness.rows() == stiffness.cols() && typical.rows() == stiffness.rows());
  const VectorXd scale =
      typical.diagonal().unaryExpr([](double entry) { return entry == 0 ? 1.0 : 1 / std::sqrt(std::abs(entry)); });
  const MatrixXd scaled = scale.asDiagonal() * (0.5 * (stiffness + stiffness.transpose())) * scale.asDiagonal();
  constexpr double round_off = 1e-12;
  return numerics::symmetric_eigen(scaled).values.minCoeff() > -round_off;
}

}  // namespace trivet::nonlinear
