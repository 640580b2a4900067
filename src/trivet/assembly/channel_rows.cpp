// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/channel_rows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/assembly/following.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {

namespace {

/// Adds factor · (motion of a place), in ground axes.
/// @param other  place on a body where the ground is observed
void add_motion(const model::System& system, const Assembled& assembled, const model::Place& place,
                const model::Place& other, double factor, MotionRows& rows) {
  if (!place.body) {
    assert(model::position(system.bodies(), other) && "a place on the ground moves with it where the other place is");
    rows.on_ground.leftCols<6>() += factor * spatial::rigid_motion(*model::position(system.bodies(), other));
    return;
  }
  const spatial::Matrix6 motion =
      spatial::both_blocks(system.bodies()[*place.body].pose.rotation) * spatial::rigid_motion(place.at);
  for (int i = 0; i < 6; ++i)
    if (const Eigen::Index row = assembled.layout.row(*place.body, i); row >= 0)
      rows.on_coordinates.col(row) += factor * motion.col(i);
}

/// Sets the rounding of products of rotation matrices to zero: a motion along x does not depend on a coordinate along
/// y.
void remove_round_off(double lever, Eigen::Matrix<double, 6, Eigen::Dynamic>& rows) {
  constexpr double round_off = 16 * std::numeric_limits<double>::epsilon();
  rows = (rows.array().abs() <= round_off * std::max(1.0, lever)).select(0, rows).eval();
}

}  // namespace

MotionRows motion_between(const model::System& system, const Assembled& assembled, const model::Place& of,
                          const model::Place& to, const Eigen::Matrix3d& axes) {
  // Unit vectors of a file are normalised; a rotation of them keeps their lengths to round-off of some products.
  [[maybe_unused]] constexpr double of_products = 1e-9;
  assert(axes.isUnitary(of_products) && "motions are along and about orthonormal axes");
  MotionRows rows{Eigen::MatrixXd::Zero(6, assembled.layout.size()), Eigen::MatrixXd::Zero(6, assembled.ground.size())};
  add_motion(system, assembled, of, to, 1, rows);
  add_motion(system, assembled, to, of, -1, rows);
  const spatial::Matrix6 turn = spatial::both_blocks(axes).transpose();
  rows.on_coordinates = (turn * rows.on_coordinates).eval();
  rows.on_ground = (turn * rows.on_ground).eval();
  double lever = 0;
  for (const model::Place* place : {&of, &to}) {
    lever = std::max(lever, place->at.norm());
    if (const auto at = model::position(system.bodies(), *place)) lever = std::max(lever, at->norm());
  }
  remove_round_off(lever, rows.on_coordinates);
  remove_round_off(lever, rows.on_ground);
  return rows;
}

namespace {

using spatial::Matrix6;

/// Longest lever arm of the moments of an element [m].
double longest_lever(const model::System& system, const model::Element& element) {
  return std::max(
      {element.n.at.norm(), element.k.at.norm(), model::span(system.bodies(), element.n, element.k).arm.norm()});
}

bool is_rotation(const model::System& system, const Assembled& assembled, Eigen::Index row) {
  for (std::size_t b = 0; b < system.bodies().size(); ++b)
    for (int j = 3; j < 6; ++j)
      if (assembled.layout.row(b, j) == row) return true;
  return false;
}

/// Gravity on the element's own mass as forces on its two ends.
spatial::Vector12 own_weight(const model::System& system, const Assembled& assembled, std::size_t e) {
  const model::Element& element = system.elements()[e];
  const Eigen::Vector3d& gravity = *system.description().gravity;
  spatial::Vector12 fall = spatial::Vector12::Zero();
  fall.segment<3>(0) = model::end_in_ground(system.bodies(), element.n).rotation.transpose() * gravity;
  fall.segment<3>(6) = model::end_in_ground(system.bodies(), element.k).rotation.transpose() * gravity;
  return assembled.elements[e].matrices.mass.topLeftCorner<12, 12>() * fall;
}

/// The rows on N of one element.
class EndRows {
 public:
  EndRows(const model::System& system, const Assembled& assembled, std::size_t e)
      : system_(system),
        assembled_(assembled),
        map_(assembled.elements[e]),
        turn_(spatial::both_blocks(model::end_in_ground(system.bodies(), system.elements()[e].n).rotation)),
        lever_(longest_lever(system, system.elements()[e])) {}

  [[nodiscard]] const Matrix6& turn() const { return turn_; }

  /// Sets the round-off (1e-17) of products of rotation matrices to zero: a strut has no moment, a turned spring no
  /// transverse force.
  [[nodiscard]] WrenchRows::Real on_coordinates(const Eigen::MatrixXd& matrix) const {
    constexpr double round_off = 64 * std::numeric_limits<double>::epsilon();
    WrenchRows::Real rows = -(turn_ * matrix.topRows<6>() * map_.ends);
    double force = 0, moment = 0;
    for (int i = 0; i < 12; ++i)
      (i % 6 < 3 ? force : moment) = std::max(i % 6 < 3 ? force : moment, std::abs(matrix(i, i)));
    for (Eigen::Index j = 0; j < map_.end_columns; ++j)
      for (int i = 0; i < 6; ++i) {
        const bool moment_row = i >= 3, rotation_column = is_rotation(system_, assembled_, map_.rows[j]);
        double typical = force * (moment_row ? lever_ : 1) * (rotation_column ? lever_ : 1);
        if (moment_row && rotation_column) typical += moment;
        if (std::abs(rows(i, j)) <= round_off * typical) rows(i, j) = 0;
      }
    return rows;
  }

  [[nodiscard]] WrenchRows::Real on_ground(const Eigen::MatrixXd& matrix) const {
    return -(turn_ * matrix.topRows<6>() * map_.ground_ends);
  }

 private:
  const model::System& system_;
  const Assembled& assembled_;
  const ElementMap& map_;
  Matrix6 turn_;
  double lever_;
};

/// Sets the terms of an element with constant matrices.
void set_constant_terms(const ElementMap& map, const EndRows& end, const Ground& ground, WrenchRows& rows) {
  using Scalar = std::complex<double>;
  const auto lossy = [](const auto& real, const auto& imaginary) {
    return (real.template cast<Scalar>() + Scalar(0, 1) * imaginary.template cast<Scalar>()).eval();
  };
  const WrenchRows::Real stiffness = end.on_coordinates(map.matrices.stiffness),
                         damping = end.on_coordinates(map.matrices.damping),
                         mass = end.on_coordinates(map.matrices.mass), loss = end.on_coordinates(map.matrices.loss);
  for (Eigen::Index j = 0; j < map.ends.cols(); ++j) {
    const Eigen::Index row = map.rows[j];
    rows.on_displacement.col(row) += lossy(stiffness.col(j), loss.col(j));
    rows.on_velocity.col(row) += damping.col(j);
    rows.on_acceleration.col(row) += mass.col(j);
  }
  const WrenchRows::Real ground_stiffness = end.on_ground(map.matrices.stiffness),
                         ground_damping = end.on_ground(map.matrices.damping),
                         ground_mass = end.on_ground(map.matrices.mass), ground_loss = end.on_ground(map.matrices.loss);
  for (Eigen::Index j = 0; j < map.ground_ends.cols(); ++j) {
    const Eigen::Index row = map.ground_rows[j];
    rows.ground_displacement.col(row) += lossy(ground_stiffness.col(j), ground_loss.col(j));
    rows.ground_velocity.col(row) += ground_damping.col(j);
    rows.ground_acceleration.col(row) += ground_mass.col(j);
  }
  const FollowedForces followed = followed_forces(map, ground);
  assert(followed.stiffness.rows() == map.ends.rows() && followed.stiffness.cols() == ground.followed());
  rows.ground_displacement.rightCols(ground.followed()) =
      -lossy(WrenchRows::Real(end.turn() * followed.stiffness.topRows<6>()),
             WrenchRows::Real(end.turn() * followed.loss.topRows<6>()));
  rows.ground_velocity.rightCols(ground.followed()) = -(end.turn() * followed.damping.topRows<6>());
  rows.ground_acceleration.rightCols(ground.followed()) = -(end.turn() * followed.mass.topRows<6>());
}

}  // namespace

WrenchRows::WrenchRows(const Assembled& assembled) {
  const Eigen::Index n = assembled.layout.size(), g = assembled.ground.size();
  on_displacement = Complex::Zero(6, n);
  ground_displacement = Complex::Zero(6, g);
  for (Real* rows : {&on_velocity, &on_acceleration}) *rows = Real::Zero(6, n);
  for (Real* rows : {&ground_velocity, &ground_acceleration}) *rows = Real::Zero(6, g);
}

void WrenchRows::add(const Matrix6& carry, const WrenchRows& other) {
  assert(on_displacement.cols() == other.on_displacement.cols() && "wrenches of one machine");
  assert(ground_displacement.cols() == other.ground_displacement.cols());
  on_displacement += carry * other.on_displacement;
  on_velocity += carry * other.on_velocity;
  on_acceleration += carry * other.on_acceleration;
  ground_displacement += carry * other.ground_displacement;
  ground_velocity += carry * other.ground_velocity;
  ground_acceleration += carry * other.ground_acceleration;
  for (const auto& [element, rows] : other.dynamic) dynamic.emplace_back(element, carry * rows);
  at_rest += carry * other.at_rest;
}

WrenchRows wrench_on_n(const model::System& system, const Assembled& assembled, std::size_t e) {
  const ElementMap& map = assembled.elements[e];
  const EndRows end(system, assembled, e);
  WrenchRows rows(assembled);
  if (map.frequency_dependent()) {
    Eigen::Matrix<double, 6, 12> exact = Eigen::Matrix<double, 6, 12>::Zero();
    exact.leftCols<6>() = -end.turn();
    rows.dynamic.emplace_back(e, exact);
  } else {
    set_constant_terms(map, end, assembled.ground, rows);
  }
  if (system.description().gravity) rows.at_rest = end.turn() * own_weight(system, assembled, e).head<6>();
  const elements::Law& law = system.elements()[e].law;
  if (law.preload) rows.at_rest -= end.turn() * law.preload->head<6>();
  if (law.nonlinear) rows.at_rest -= end.turn() * law.nonlinear->offset.head<6>();
  return rows;
}

WrenchRows section_wrench(const model::System& system, const Assembled& assembled, const model::Section& section) {
  WrenchRows sum(assembled);
  const Matrix6 turn = spatial::both_blocks(section.axes).transpose();
  for (const std::size_t e : section.elements) {
    const Eigen::Vector3d at = model::end_in_ground(system.bodies(), system.elements()[e].n).position;
    sum.add(turn * spatial::rigid_motion(at - section.at).transpose(), wrench_on_n(system, assembled, e));
  }
  return sum;
}

}  // namespace trivet::assembly
