// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/place_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

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

}  // namespace trivet::assembly
