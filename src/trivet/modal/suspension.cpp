// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/suspension.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/motion_words.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::modal {

namespace {

/// The body, and the nodes that elements join to it without another body between.
std::vector<bool> moving_with(const model::System& system, std::size_t body) {
  std::vector<bool> moving(system.bodies().size(), false);
  moving[body] = true;
  for (bool more = true; more;) {
    more = false;
    for (const model::Element& element : system.elements()) {
      if (!element.n.body || !element.k.body || moving[*element.n.body] == moving[*element.k.body]) continue;
      const std::size_t other = moving[*element.n.body] ? *element.k.body : *element.n.body;
      if (!system.bodies()[other].is_node) continue;
      moving[other] = more = true;
    }
  }
  return moving;
}

}  // namespace

bool is_on(const model::Element& element, const std::vector<bool>& moving) {
  return (element.n.body && moving[*element.n.body]) || (element.k.body && moving[*element.k.body]);
}

BodyRows rows_of(const model::System& system, const assembly::Assembled& assembled, std::size_t body) {
  BodyRows rows;
  for (int j = 0; j < 6; ++j)
    if (const Eigen::Index row = assembled.layout.row(body, j); row >= 0) {
      rows.body.push_back(row);
      rows.coordinates.push_back(j);
    }
  rows.moving = moving_with(system, body);
  for (std::size_t node = 0; node < system.bodies().size(); ++node)
    for (int j = 0; j < 6 && node != body && rows.moving[node]; ++j)
      if (const Eigen::Index row = assembled.layout.row(node, j); row >= 0) rows.inner.push_back(row);
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const assembly::ElementMap& map = assembled.elements[e];
    if (is_on(system.elements()[e], rows.moving))
      rows.inner.insert(rows.inner.end(), map.rows.begin() + map.end_columns, map.rows.end());
  }
  return rows;
}

OwnSystem own_system(const model::Body& body, const assembly::Assembled& assembled, const BodyRows& rows) {
  const numerics::DynamicMatrices& all = assembled.matrices;
  std::vector<Eigen::Index> both = rows.body;
  both.insert(both.end(), rows.inner.begin(), rows.inner.end());
  assert(std::set(both.begin(), both.end()).size() == both.size() && "no coordinate is both of the body and inner");
  OwnSystem own;
  own.matrices.A = all.A(both, both);
  own.matrices.B = all.B(both, both);
  own.matrices.K = all.K(both, both);
  own.matrices.symmetric = all.symmetric;
  const spatial::Matrix6 at_centre = spatial::rigid_motion(body.mass.centre);
  spatial::Matrix6 mass = body.mass.mass * spatial::Matrix6::Identity();
  mass.bottomRightCorner<3, 3>() = body.mass.inertia_about_centre;
  const Eigen::MatrixXd motion = at_centre(Eigen::all, rows.coordinates), momentum = mass * motion;
  for (std::size_t j = 0; j < 6; ++j) {
    const auto row = to_index(j);
    own.energy[j] = motion.row(row).transpose() * momentum.row(row);
  }
  return own;
}

OwnModes own_modes(const OwnSystem& own) {
  const numerics::MassiveSystem massive = numerics::massive_system(own.matrices);
  const numerics::GeneralizedModes raw = numerics::generalized_modes(massive.K, massive.A, own.matrices.symmetric);
  return {raw.lambda, raw.norm, massive.recovery * raw.shapes};
}

namespace {

using spatial::Matrix6;
using spatial::Vector6;

/// K_bb − K_bi K_ii⁻¹ K_ib, as 6×6, zero for constrained coordinates.
Matrix6 stiffness_at_rest(const Eigen::MatrixXd& stiffness, const BodyRows& rows) {
  Eigen::MatrixXd free = stiffness(rows.body, rows.body);
  if (!rows.inner.empty()) {
    const Eigen::MatrixXd inner = stiffness(rows.inner, rows.inner), across = stiffness(rows.inner, rows.body);
    free -= Eigen::MatrixXd(stiffness(rows.body, rows.inner)) * numerics::lu_solution(inner, across);
  }
  Matrix6 six = Matrix6::Zero();
  six(rows.coordinates, rows.coordinates) = free;
  return six;
}

elements::StiffnessProperties properties_at_pole(const Matrix6& stiffness) {
  elements::Matrix12 moved_end = elements::Matrix12::Zero();
  moved_end.bottomRightCorner<6, 6>() = stiffness;
  return elements::stiffness_properties(moved_end);
}

double distance_to_line(const Eigen::Vector3d& from, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  return (from - point).cross(direction).norm();
}

RollAxes roll_axes(const model::Body& body, const Matrix6& stiffness, const Eigen::Vector3d& torque) {
  constexpr double parallel = 1e-6;  // sine of the angle below which two lines count as parallel
  RollAxes result;
  result.torque = torque.normalized();
  result.torque_roll_axis = numerics::lu_solution(body.mass.inertia_about_centre, result.torque).normalized();
  Vector6 moment = Vector6::Zero();
  moment.tail<3>() = result.torque;
  const Vector6 motion = numerics::lu_solution(stiffness, moment);
  result.elastic_roll_axis = spatial::screw({motion.head<3>(), motion.tail<3>()}, body_size(body), body.mass.centre);
  result.torsional_stiffness = 1 / result.torque.dot(motion.tail<3>());
  const spatial::Screw& elastic = result.elastic_roll_axis;
  const Eigen::Vector3d across = result.torque_roll_axis.cross(elastic.direction);
  result.angle = std::atan2(across.norm(), std::abs(result.torque_roll_axis.dot(elastic.direction)));
  result.distance_at_centre = distance_to_line(body.mass.centre, elastic.point, elastic.direction);
  result.shortest_distance = across.norm() > parallel
      ? std::abs((elastic.point - body.mass.centre).dot(across)) / across.norm()
      : result.distance_at_centre;
  return result;
}

BodyMode body_mode(const model::Body& body, const BodyRows& rows, const Eigen::VectorXd& shape, double lambda,
                   double norm) {
  Vector6 at_pole = Vector6::Zero();
  at_pole(rows.coordinates) = shape.head(to_index(rows.coordinates.size()));
  const Vector6 at_centre = spatial::rigid_motion(body.mass.centre) * at_pole;
  assert(std::abs(norm) == 1 && to_index(rows.coordinates.size()) <= shape.size());
  Vector6 momentum;
  momentum << body.mass.mass * at_centre.head<3>(), body.mass.inertia_about_centre * at_centre.tail<3>();
  BodyMode mode;
  if (lambda >= 0) mode.angular_frequency = std::sqrt(lambda);
  mode.kinetic_energy_share = at_centre.cwiseProduct(momentum) / norm;
  mode.in_elements = 1 - mode.kinetic_energy_share.sum();
  mode.kinetic_energy_share.maxCoeff(&mode.purest);
  return mode;
}

std::vector<BodyMode> body_modes(const model::Body& body, const BodyRows& rows, const OwnModes& own) {
  std::vector<BodyMode> modes;
  for (Eigen::Index i = 0; i < own.lambda.size(); ++i)
    modes.push_back(body_mode(body, rows, own.shapes.col(i), own.lambda(i), own.norm(i)));
  return modes;
}

void note_elements(const model::System& system, const std::vector<bool>& moving, std::vector<std::string>& notes) {
  for (const model::Element& element : system.elements()) {
    if (!is_on(element, moving)) continue;
    if (element.n.body && element.k.body && moving[*element.n.body] != moving[*element.k.body]) {
      const std::size_t other = moving[*element.n.body] ? *element.k.body : *element.n.body;
      notes.push_back(
          fmt::format("\"{}\" acts as if \"{}\" were the ground", element.name, system.bodies()[other].name));
    }
    if (element.n.foundation || element.k.foundation)
      notes.push_back(fmt::format("\"{}\" acts as if its foundation were rigid", element.name));
    if (elements::is_frequency_dependent(element.law) ||
        std::holds_alternative<elements::Viscoelastic>(element.law.damping))
      notes.push_back(fmt::format("\"{}\" enters with its static stiffness; in vibration it is stiffer", element.name));
    if (!element.symmetric)
      notes.push_back(
          fmt::format("\"{}\" is unsymmetric: centre and axes are those of the symmetric part", element.name));
  }
}

}  // namespace

BodySuspension body_suspension(const model::System& system, const assembly::Assembled& assembled, std::size_t index,
                               const std::vector<Eigen::Vector3d>& torques) {
  constexpr double unheld = 1e-10;  // of the scaled stiffness: below this, some motion is unrestrained
  for (const Eigen::Vector3d& torque : torques)
    if (!(torque.norm() > 0) || !torque.allFinite())
      throw foundation::InvalidInput("body_suspension: the torque has no direction");
  const model::Body& body = system.bodies().at(index);
  const BodyRows rows = rows_of(system, assembled, index);
  BodySuspension result;
  result.body = index;
  result.stiffness = stiffness_at_rest(assembled.matrices.K, rows);
  result.modes = body_modes(body, rows, own_modes(own_system(body, assembled, rows)));
  note_elements(system, rows.moving, result.notes);
  if (rows.body.size() < 6) {
    result.notes.push_back(fmt::format(
        "\"{}\" is constrained by `free`, so its elements alone define no elastic centre and no roll axes", body.name));
    return result;
  }
  result.elastic = properties_at_pole(result.stiffness);
  result.centre_distance = (result.elastic->elastic_centre - body.mass.centre).norm();
  if (!(result.elastic->softest_combination > unheld))
    result.notes.push_back("its elements leave some motion free or unstable: no roll axes under a constant moment");
  else
    for (const Eigen::Vector3d& torque : torques) result.roll_axes.push_back(roll_axes(body, result.stiffness, torque));
  return result;
}

std::vector<FrequencySeparation> frequency_separation(const Modes& modes, const std::vector<double>& excitations) {
  std::vector<FrequencySeparation> result;
  for (const Mode& mode : modes.list) {
    const double omega = mode.angular_frequency.value_or(0);
    if (!(omega > 0)) continue;
    if (!result.empty()) result.back().ratio_to_next = omega / result.back().angular_frequency;
    assert((result.empty() || omega >= result.back().angular_frequency) && "modes ascend");
    FrequencySeparation& row = result.emplace_back();
    row.mode = mode.number;
    row.angular_frequency = omega;
    for (const double excitation : excitations) row.excitation_ratio.push_back(excitation / omega);
  }
  return result;
}

}  // namespace trivet::modal
