// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/following.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/elements/checks.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

using spatial::Matrix6;

constexpr double of_geometry = 1e-12;  // round-off of products of rotations and levers

/// Replaces each entry by the largest of its three columns: translations of the ground, or its rotations. A component
/// in turned axes that is zero except for rounding has terms that are rounding too; the other axes of the ground give
/// their scale.
Eigen::MatrixXd over_axes(Eigen::MatrixXd terms) {
  for (Eigen::Index j = 0; j + 3 <= terms.cols(); j += 3)
    terms.middleCols(j, 3).colwise() = terms.middleCols(j, 3).rowwise().maxCoeff().eval();
  return terms;
}

/// The same over the three components of each translation and rotation of the ends.
Eigen::MatrixXd over_components(Eigen::MatrixXd terms) {
  for (Eigen::Index i = 0; i + 3 <= 12; i += 3)
    terms.middleRows(i, 3).rowwise() = terms.middleRows(i, 3).colwise().maxCoeff().eval();
  return terms;
}

/// The sums, set to zero if they are below a share of their terms.
Eigen::MatrixXd without_rounding(Eigen::MatrixXd sum, const Eigen::MatrixXd& terms, const Eigen::ArrayXd& share) {
  assert(terms.rows() == sum.rows() && terms.cols() == sum.cols() && share.size() == sum.cols());
  assert((share >= 0).all() && "a share of the terms below which a sum is rounding");
  for (Eigen::Index j = 0; j < sum.cols(); ++j)
    for (Eigen::Index i = 0; i < sum.rows(); ++i)
      if (std::abs(sum(i, j)) <= share(j) * terms(i, j)) sum(i, j) = 0;
  return sum;
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& x, const Eigen::ArrayXd& share) {
  return without_rounding(a * x, over_axes(a.cwiseAbs() * x.cwiseAbs()), share);
}

/// The same for the forces of an element; its first twelve rows are components of forces and moments.
Eigen::MatrixXd element_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& x, const Eigen::ArrayXd& share) {
  if (a.isZero(0)) return Eigen::MatrixXd::Zero(a.rows(), x.cols());
  return without_rounding(a * x, over_axes(over_components(a.cwiseAbs() * x.cwiseAbs())), share);
}

/// Tolerance of the rule for a stress-free element.
Eigen::ArrayXd stress_free(const Ground& ground) {
  return ground.rigid.select(Eigen::ArrayXd::Constant(ground.followed(), elements::silent_residual), ground.round_off);
}

void follow_with_bodies(const model::System& system, const Layout& layout, Eigen::MatrixXd& R) {
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const spatial::Pose& pose = system.bodies()[b].pose;
    const Matrix6 rigid = spatial::both_blocks(pose.rotation).transpose() * spatial::rigid_motion(pose.position);
    for (int j = 0; j < 6; ++j)
      if (layout.row(b, j) >= 0) R.row(layout.row(b, j)).head<6>() = rigid.row(j);
  }
}

/// Coordinates of a foundation so that its ends move rigidly with the ground, as far as possible.
void follow_with_foundations(const model::System& system, const Assembled& assembled, Eigen::MatrixXd& R) {
  for (std::size_t f = 0; f < system.description().foundations.size(); ++f) {
    const Eigen::Index first = assembled.layout.foundation_row(f),
                       count = system.description().foundations[f].mass.rows();
    Eigen::MatrixXd shapes(0, count), wanted(0, 6);
    Eigen::Array<double, 6, 1> reach = Eigen::Array<double, 6, 1>::Zero();
    for (const model::Element& element : system.elements())
      for (const model::End* end : {&element.n, &element.k})
        if (!model::couples_ground_points(element) && end->foundation && end->foundation->foundation == f) {
          shapes.conservativeResize(shapes.rows() + 6, Eigen::NoChange);
          wanted.conservativeResize(wanted.rows() + 6, Eigen::NoChange);
          shapes.bottomRows<6>() = end->foundation->shape;
          wanted.bottomRows<6>() = (Matrix6::Identity() - end->foundation->fixed_directions) *
              spatial::rigid_motion(end->at);  // the fixed directions move with the ground anyway
          reach = reach.max(spatial::rigid_motion(end->at).cwiseAbs().colwise().maxCoeff().transpose().array());
        }
    if (shapes.rows() == 0 || count == 0) continue;
    Eigen::MatrixXd follow = numerics::smallest_solution(shapes, wanted);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < 6; ++j)
        if (std::abs(follow(i, j)) * shapes.col(i).cwiseAbs().maxCoeff() <= of_geometry * reach(j)) follow(i, j) = 0;
    R.block(first, 0, count, 6) = follow;
  }
}

/// Motion of the ends, and of the internal coordinates according to R.
Eigen::MatrixXd followed_ends(const ElementMap& map, const Ground& ground) {
  Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(map.ends.rows(), ground.followed());
  for (Eigen::Index j = 0; j < map.ground_ends.cols(); ++j)
    for (std::size_t t = 0; t < ground.together.size(); ++t)
      for (const Eigen::Index first : ground.together[t])
        if (const Eigen::Index part = map.ground_rows[j] - first; part >= 0 && part < 6)
          ends.col(6 * to_index(t) + part) += map.ground_ends.col(j);
  Eigen::MatrixXd terms = ends.cwiseAbs();
  for (Eigen::Index j = 0; j < map.ends.cols(); ++j) {
    const Eigen::RowVectorXd follow = ground.R.row(map.rows[j]);
    ends += map.ends.col(j) * follow;
    terms += map.ends.col(j).cwiseAbs() * follow.cwiseAbs();
  }
  terms = over_axes(over_components(terms));
  for (Eigen::Index j = 0; j < ends.cols(); ++j)
    for (Eigen::Index i = 0; i < 12; ++i)
      if (std::abs(ends(i, j)) <= of_geometry * terms(i, j)) ends(i, j) = 0;
  return ends;
}

/// Sets the internal coordinates to their static values for the given ends; strains of an element that moves rigidly
/// are zero.
void follow_inside(Assembled& assembled) {
  Eigen::MatrixXd& R = assembled.ground.R;
  assert(R.rows() == assembled.layout.size() && R.cols() == assembled.ground.followed());
  for (ElementMap& map : assembled.elements) {
    map.followed_ends = followed_ends(map, assembled.ground);
    const Eigen::Index inner = map.ends.rows() - 12;
    if (inner == 0) continue;
    const Eigen::MatrixXd& K = map.matrices.stiffness;
    const Eigen::MatrixXd own = K.bottomRightCorner(inner, inner);
    map.followed_ends.bottomRows(inner) = -numerics::smallest_solution(
        own, product(K.bottomLeftCorner(inner, 12), map.followed_ends.topRows(12), stress_free(assembled.ground)));
    for (Eigen::Index i = 0; i < inner; ++i) R.row(map.rows[map.end_columns + i]) = map.followed_ends.row(12 + i);
  }
}

struct Columns {
  Eigen::MatrixXd K, B, K_loss;
};

/// In the order of the elements.
std::vector<FollowedForces> all_followed_forces(const Assembled& assembled) {
  std::vector<FollowedForces> all;
  all.reserve(assembled.elements.size());
  for (const ElementMap& map : assembled.elements) all.push_back(followed_forces(map, assembled.ground));
  return all;
}

/// Forces that the motion R g causes in the free rows: from the elements that `is_selected` accepts, the weights and
/// the foundations.
template <typename Predicate>
Columns coupled(const model::System& system, const Assembled& assembled, const std::vector<FollowedForces>& all_forces,
                const Predicate& is_selected) {
  assert(all_forces.size() == assembled.elements.size());
  const Eigen::Index n = assembled.layout.size();
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, assembled.ground.followed());
  Columns c{none, none, none};
  for (std::size_t e = 0; e < all_forces.size(); ++e) {
    const ElementMap& map = assembled.elements[e];
    if (!is_selected(map)) continue;
    const FollowedForces& forces = all_forces[e];
    if (forces.stiffness.isZero(0) && forces.damping.isZero(0)) continue;
    const Eigen::MatrixXd stiffness = map.ends.transpose() * forces.stiffness,
                          damping = map.ends.transpose() * forces.damping, loss = map.ends.transpose() * forces.loss;
    for (Eigen::Index i = 0; i < stiffness.rows(); ++i) {
      const Eigen::Index row = map.rows[i];
      c.K.row(row) += stiffness.row(i);
      c.B.row(row) += damping.row(i);
      c.K_loss.row(row) += loss.row(i);
    }
  }
  const Ground& ground = assembled.ground;
  c.K += product(assembled.of_levers, ground.R, ground.round_off);
  for (std::size_t f = 0; f < system.description().foundations.size(); ++f) {
    const model::Foundation& own = system.description().foundations[f];
    const Eigen::Index first = assembled.layout.foundation_row(f), count = own.mass.rows();
    c.K.middleRows(first, count) += product(own.stiffness, ground.R.middleRows(first, count), ground.round_off);
    c.B.middleRows(first, count) += product(own.damping, ground.R.middleRows(first, count), ground.round_off);
  }
  return c;
}

/// True for a motion of the ground, not a wave, given by its velocity or acceleration.
bool gives_rates(const model::Action& action) { return !action.body && !action.wave && action.derivative > 0; }

bool given_by_rates(const model::System& system) {
  return std::ranges::any_of(system.description().excitations,
                             [](const model::Excitation& excitation) { return gives_rates(excitation.action); });
}

/// R = −K⁻¹K_g in the columns with a resisting stiffness.
void follow_at_rest(const Columns& resisting, Assembled& assembled) {
  constexpr double regular = 1e-10;
  Ground& ground = assembled.ground;
  const numerics::DynamicMatrices& m = assembled.matrices;
  const Eigen::VectorXd scale = numerics::unit_scale(m);
  const numerics::PivotedLu<double> stiffness(scale.asDiagonal() * m.K * scale.asDiagonal());
  const double condition = stiffness.reciprocal_condition();
  if (!(condition > regular)) return;
  for (Eigen::Index j = 0; j < ground.followed(); ++j) {
    if (resisting.K.col(j).isZero(0)) continue;
    ground.rigid(j) = false;
    ground.round_off(j) = std::max(of_geometry, 64 * std::numeric_limits<double>::epsilon() / condition);
    Eigen::VectorXd follow = ground.R.col(j).cwiseQuotient(scale) -
        stiffness.solve(Eigen::VectorXd(scale.asDiagonal() * resisting.K.col(j)));
    for (double& each : follow)
      if (std::abs(each) <= ground.round_off(j) * follow.cwiseAbs().maxCoeff()) each = 0;
    ground.R.col(j) = scale.asDiagonal() * follow;
  }
  follow_inside(assembled);
}

/// True if the motion with the ground causes a force in the element at any of the probed frequencies.
bool resists(const ElementMap& map, const FollowedForces& forces) {
  if (!forces.stiffness.isZero(0) || !forces.damping.isZero(0) || !forces.mass.isZero(0)) return true;
  if (!map.frequency_dependent()) return false;
  std::vector<double> probed = {std::max(map.defined_from, 1.0)};
  if (std::isfinite(map.defined_to)) probed.push_back(map.defined_to);
  if (!map.knots.empty()) probed.push_back(map.knots[map.knots.size() / 2]);
  const Eigen::MatrixXd ends = map.followed_ends.topRows(12);
  const auto silent = [&](double omega) {
    const elements::Matrix12c d =
        map.dynamic_stiffness(std::min(omega, map.defined_to), std::min(omega, map.defined_to));
    const Eigen::MatrixXd force = (d * ends.cast<std::complex<double>>()).cwiseAbs(),
                          terms = over_axes(over_components(d.cwiseAbs() * ends.cwiseAbs()));
    return (force.array() <= elements::silent_residual * terms.array()).all();
  };
  return !std::ranges::all_of(probed, silent);
}

/// Damping of the whole system on the motion beyond the static one; zero if R is the static motion.
Eigen::MatrixXd beyond_rest(const SystemDampingMatrices& damping, const Ground& ground,
                            const Eigen::MatrixXd& resisting) {
  constexpr double of_a_solution = 1e-9;  // accuracy of a solution with a singular K
  const Eigen::MatrixXd direct = ground.gathered(damping.on_ground),
                        terms = over_axes(damping.on_coordinates.cwiseAbs() * ground.R.cwiseAbs() + direct.cwiseAbs());
  Eigen::MatrixXd beyond = damping.on_coordinates * ground.R + direct;
  for (Eigen::Index j = 0; j < beyond.cols(); ++j) {
    const bool at_rest = damping.regular && (!ground.rigid(j) || resisting.col(j).isZero(0));
    for (Eigen::Index i = 0; i < beyond.rows(); ++i)
      if (at_rest || std::abs(beyond(i, j)) <= of_a_solution * terms(i, j)) beyond(i, j) = 0;
  }
  return beyond;
}

}  // namespace

FollowedForces followed_forces(const ElementMap& map, const Ground& ground) {
  const Eigen::ArrayXd share = stress_free(ground);
  return {element_product(map.matrices.stiffness, map.followed_ends, share),
          element_product(map.matrices.damping, map.followed_ends, share), map.matrices.mass * map.followed_ends,
          element_product(map.matrices.loss, map.followed_ends, share)};
}

Eigen::RowVectorXd followed_row(const Ground& ground, const Eigen::RowVectorXd& on_coordinates,
                                const Eigen::RowVectorXd& on_ground) {
  const Eigen::RowVectorXd direct = ground.gathered(on_ground);
  Eigen::RowVectorXd sum = on_coordinates * ground.R + direct;
  const Eigen::RowVectorXd terms = over_axes(on_coordinates.cwiseAbs() * ground.R.cwiseAbs() + direct.cwiseAbs());
  // A component may vanish along all axes of the ground: rounding of its largest coefficient times the longest lever
  // counts as zero too.
  double lever = 1;
  for (const GroundEnd& end : ground.ends) lever = std::max(lever, end.pose.position.norm());
  const double largest = lever * std::max(on_coordinates.cwiseAbs().maxCoeff(), on_ground.cwiseAbs().maxCoeff());
  for (Eigen::Index j = 0; j < sum.size(); ++j)
    if (std::abs(sum(j)) <= ground.round_off(j) * std::max(terms(j), largest)) sum(j) = 0;
  return sum;
}

void move_together(const model::System& system, Ground& ground) {
  for (const model::Excitation& excitation : system.description().excitations) {
    const std::vector<std::size_t>& moved = excitation.action.elements;
    if (moved.empty() || !gives_rates(excitation.action)) continue;
    std::vector<Eigen::Index> rows;
    for (const GroundEnd& end : ground.ends)
      if (std::ranges::find(moved, end.element) != moved.end()) rows.push_back(end.first_row);
    if (!rows.empty() && std::ranges::find(ground.together, rows) == ground.together.end())
      ground.together.push_back(rows);
  }
}

void follow_ground(const model::System& system, const SystemDampingMatrices& damping, Assembled& assembled) {
  Ground& ground = assembled.ground;
  const Eigen::Index n = assembled.layout.size(), followed = ground.followed();
  ground.R = Eigen::MatrixXd::Zero(n, followed);
  ground.rigid.setConstant(followed, true);
  ground.round_off.setConstant(followed, of_geometry);
  follow_with_bodies(system, assembled.layout, ground.R);
  follow_with_foundations(system, assembled, ground.R);
  follow_inside(assembled);
  std::vector<FollowedForces> forces = all_followed_forces(assembled);
  if (given_by_rates(system)) {
    const Columns resisting = coupled(system, assembled, forces, [](const ElementMap&) { return true; });
    if (!resisting.K.isZero(0)) {
      follow_at_rest(resisting, assembled);
      forces = all_followed_forces(assembled);  // the elements may move otherwise now
    }
  }
  for (std::size_t e = 0; e < forces.size(); ++e)
    assembled.elements[e].resists_following = resists(assembled.elements[e], forces[e]);
  Columns own = coupled(system, assembled, forces, [](const ElementMap& map) { return !map.frequency_dependent(); });
  if (damping.on_coordinates.size() > 0) own.B += beyond_rest(damping, ground, own.K);
  for (Eigen::Index j = 0; j < followed && !assembled.frequency_dependent(); ++j)
    if (!ground.rigid(j)) own.K.col(j).setZero();  // by the choice of R
  ground.K.rightCols(followed) = own.K;
  ground.B.rightCols(followed) = own.B;
  if (!own.K_loss.isZero(0)) {
    if (ground.K_loss.size() == 0) ground.K_loss = Eigen::MatrixXd::Zero(n, ground.size());
    ground.K_loss.rightCols(followed) = own.K_loss;
  }
  const numerics::DynamicMatrices& m = assembled.frequency_dependent() ? assembled.constant : assembled.matrices;
  ground.A.topRightCorner(m.size(), followed) =
      m.A * ground.R.topRows(m.size()) + ground.gathered(ground.A).topRows(m.size());
}

}  // namespace trivet::assembly
