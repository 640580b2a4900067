// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/second_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "trivet/assembly/geometric_stiffness.h"
#include "trivet/assembly/loads.h"
#include "trivet/assembly/rest_coordinates.h"
#include "trivet/elements/force_at_rest.h"
#include "trivet/foundation/index.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"

namespace trivet::assembly {
namespace {

using Eigen::VectorXd;
using elements::Vector12;

/// Bodies and foundations that elements join, directly or through others.
class JoinedParts {
 public:
  explicit JoinedParts(const model::System& system)
      : bodies_(system.bodies().size()), parent_(bodies_ + system.description().foundations.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const model::Element& element : system.elements()) {
      const auto n = place(element.n), k = place(element.k);
      if (n && k) parent_[root(*n)] = root(*k);
    }
  }

  /// The same number for all that are joined.
  [[nodiscard]] std::size_t root(std::size_t part) const {
    while (parent_[part] != part) part = parent_[part];
    return part;
  }
  [[nodiscard]] std::optional<std::size_t> place(const model::End& end) const {
    if (end.body) return *end.body;
    if (end.foundation) return bodies_ + end.foundation->foundation;
    return std::nullopt;
  }
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

 private:
  std::size_t bodies_;
  std::vector<std::size_t> parent_;
};

/// Per part: do elements without a preload hold it, or none at all? Then its forces at rest are those of statics.
std::vector<bool> parts_of_statics(const model::System& system, const Assembled& first, const JoinedParts& parts) {
  std::vector<bool> preloaded(parts.size(), false), others(parts.size(), false);
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const bool holds = !first.elements[e].matrices.stiffness.topLeftCorner(12, 12).isZero(0);
    for (const model::End* end : {&element.n, &element.k})
      if (const auto part = parts.place(*end); part && !element.is_foundation) {
        if (element.law.preload) preloaded[parts.root(*part)] = true;
        else if (holds) others[parts.root(*part)] = true;
      }
  }
  std::vector<bool> result(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::size_t root = parts.root(part);
    result[part] = others[root] || !preloaded[root];
  }
  return result;
}

/// Forces that the bodies exert on the ends of an element at rest: of its law alone, and with the weight of its mass.
struct EndForces {
  Vector12 of_law = Vector12::Zero(), in_all = Vector12::Zero();
};

std::vector<EndForces> end_forces(const model::System& system, const Assembled& first, const VectorXd& rest) {
  const Eigen::Vector3d& gravity = *system.description().gravity;
  std::vector<EndForces> all(system.elements().size());
  for (std::size_t e = 0; e < all.size(); ++e) {
    const model::Element& element = system.elements()[e];
    const ElementMap& map = first.elements[e];
    all[e].of_law = map.matrices.stiffness.topRows<12>() * map.coordinates(rest);
    if (element.law.preload) all[e].of_law += *element.law.preload;
    if (element.law.nonlinear) all[e].of_law += element.law.nonlinear->offset;
    Vector12 fall = Vector12::Zero();
    fall.segment<3>(0) = model::end_in_ground(system.bodies(), element.n).rotation.transpose() * gravity;
    fall.segment<3>(6) = model::end_in_ground(system.bodies(), element.k).rotation.transpose() * gravity;
    all[e].in_all = all[e].of_law - map.matrices.mass.topLeftCorner<12, 12>() * fall;
  }
  return all;
}

/// Force and moment on end K whose turning the tangent of the element does not contain.
spatial::Vector6 not_in_tangent(const model::Element& element, const Vector12& of_law) {
  spatial::Vector6 rest = of_law.tail<6>();
  if (element.law.preload) rest -= element.law.preload->tail<6>();
  for (const model::DistancePart& part : element.distance_parts)
    if (!part.law.across)
      rest.head<3>() -= elements::force_in_motion(part.law, part.at_rest, Eigen::Vector3d::Zero()).force;
  return rest;
}

/// Bodies whose load the elements cannot balance.
std::vector<bool> unbalanced(const model::System& system, const Assembled& first, const JoinedParts& parts,
                             const VectorXd& load, const VectorXd& rest) {
  constexpr double balanced = 1e-6;
  const VectorXd scale = numerics::unit_scale(first.matrices),
                 left = scale.asDiagonal() * (load - first.matrices.K * rest), whole = scale.asDiagonal() * load;
  std::vector<double> of_left(parts.size(), 0), of_whole(parts.size(), 0);
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const std::size_t root = parts.root(b);
    of_left[root] += first.layout.of_body(b, left).squaredNorm();
    of_whole[root] += first.layout.of_body(b, whole).squaredNorm();
  }
  std::vector<bool> result(system.bodies().size());
  for (std::size_t b = 0; b < result.size(); ++b) {
    const std::size_t root = parts.root(b);
    result[b] = !(of_left[root] <= balanced * balanced * of_whole[root]);
  }
  return result;
}

/// Largest angle by which parts turn in a motion, and elements across their length [rad].
double largest_turn(const model::System& system, const Assembled& first, const VectorXd& motion) {
  double largest = 0;
  for (std::size_t b = 0; b < system.bodies().size(); ++b)
    largest = std::max(largest, first.layout.of_body(b, motion).tail<3>().norm());
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const model::Span span = model::span(system.bodies(), element.n, element.k);
    const double length = span.arm.norm();
    if (!(length > 0)) continue;
    const VectorXd ends = first.elements[e].coordinates(motion);
    const Eigen::Vector3d apart = span.n_from_k * ends.segment<3>(6) - ends.segment<3>(0),
                          along = span.n_from_k * span.arm / length;
    largest = std::max(largest, (apart - along * along.dot(apart)).norm() / length);
  }
  return largest;
}

/// The parts of a machine whose forces at rest are those of statics, under its load.
class LoadedParts {
 public:
  LoadedParts(const model::System& system, const Assembled& first)
      : system_(system), first_(first), parts_(system), of_statics_(parts_of_statics(system, first, parts_)) {
    const VectorXd load = static_load(system, first);
    rest_ = coordinates_at_rest(first.matrices, load).coordinates;
    const std::vector<bool> moves = unbalanced(system, first, parts_, load, rest_);
    std::vector<std::size_t> swinging;
    for (std::size_t b = 0; b < moves.size(); ++b)
      if (of_statics_[b] && moves[b]) swinging.push_back(b);
    if (swinging.empty() || hangs_beside(load - first.matrices.K * rest_)) return;
    for (const std::size_t b : swinging) of_statics_[b] = false;
    without_rest_ = swinging;
  }

  [[nodiscard]] const VectorXd& rest() const { return rest_; }

  /// What these forces at rest add to K.
  [[nodiscard]] Eigen::MatrixXd added(const SecondOrder& found) const {
    Eigen::MatrixXd sum = found.of_levers - first_.of_levers;
    for (std::size_t e = 0; e < found.of_elements.size(); ++e) {
      const ElementMap& map = first_.elements[e];
      const Eigen::MatrixXd ends = map.ends.topRows(12);
      sum(map.rows, map.rows) += ends.transpose() * found.of_elements[e] * ends;
    }
    return sum;
  }

  /// With the forces of these coordinates.
  [[nodiscard]] SecondOrder second_order(const VectorXd& rest) const {
    const std::vector<EndForces> forces = end_forces(system_, first_, rest);
    Levers levers(system_, first_.layout);
    SecondOrder result;
    result.without_rest = without_rest_;
    result.of_elements.assign(forces.size(), elements::Matrix12::Zero());
    for (std::size_t e = 0; e < forces.size(); ++e) {
      const model::Element& element = system_.elements()[e];
      if (!is_of_statics(element.n) && !is_of_statics(element.k)) continue;
      if (element.n.body) levers.add(*element.n.body, element.n.at, element.n.axes * forces[e].in_all.segment<3>(0));
      if (element.k.body) levers.add(*element.k.body, element.k.at, element.k.axes * forces[e].in_all.segment<3>(6));
      // The law between points of the ground is in axes of the ground; a residual under rigid motion is a load at rest.
      if (model::couples_ground_points(element) || element.allow_residual) continue;
      const model::Span span = model::span(system_.bodies(), element.n, element.k);
      result.of_elements[e] = elements::stiffness_of_force_at_rest(
          element.law, not_in_tangent(element, forces[e].of_law), span.arm, span.n_from_k);
    }
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      if (of_statics_[b]) levers.add_weight(b);
    for (const model::ConstantForce& force : system_.description().constant_forces)
      if (of_statics_[force.body]) levers.add(force.body, force.at, -force.wrench.force);
    levers.add_preloads([&](std::size_t body) { return !of_statics_[body]; });
    result.of_levers = levers.stiffness();
    return result;
  }

 private:
  [[nodiscard]] bool is_of_statics(const model::End& end) const {
    const auto part = parts_.place(end);
    return part && of_statics_[*part];
  }

  /// Does a load that no element balances move the machine aside by little, because its weight draws it back?
  [[nodiscard]] bool hangs_beside(const VectorXd& left) const {
    constexpr double held = 1e-12;    // of the stiffest direction
    constexpr double nothing = 1e-6;  // of the load
    constexpr double little = 0.3;    // [rad]: the frequency of a pendulum is then right to about a percent
    const VectorXd scale = numerics::unit_scale(first_.matrices);
    const Eigen::MatrixXd whole = first_.matrices.K + added(second_order(rest_));
    const Eigen::MatrixXd stiffness = scale.asDiagonal() * (0.5 * (whole + whole.transpose())) * scale.asDiagonal();
    const auto modes = numerics::symmetric_eigen(stiffness);
    const VectorXd along = modes.vectors.transpose() * (scale.asDiagonal() * left);
    VectorXd aside = VectorXd::Zero(left.size());
    for (Eigen::Index i = 0; i < aside.size(); ++i)
      if (modes.values(i) > held * modes.values.cwiseAbs().maxCoeff())
        aside += along(i) / modes.values(i) * modes.vectors.col(i);
      else if (std::abs(along(i)) > nothing * along.norm()) return false;  // nothing draws it back
    aside = scale.asDiagonal() * aside;
    return largest_turn(system_, first_, aside) <= little;
  }

  const model::System& system_;
  const Assembled& first_;
  JoinedParts parts_;
  std::vector<bool> of_statics_;
  std::vector<std::size_t> without_rest_;
  VectorXd rest_;
};

}  // namespace

bool has_second_order(const model::System& system) {
  const auto& gravity = system.description().gravity;
  return system.description().second_order && gravity && !gravity->isZero(0);
}

SecondOrder second_order(const model::System& system, const Assembled& first) {
  if (model::has_static_stiffness(system)) {
    const model::System softer = model::with_static_stiffness(system);
    return second_order(softer, assemble_first_order(softer));
  }
  const LoadedParts loaded(system, first);
  return loaded.second_order(loaded.rest());
}

SecondOrderForms second_order_forms(const model::System& system, const Assembled& first) {
  if (model::has_static_stiffness(system)) {
    const model::System softer = model::with_static_stiffness(system);
    return second_order_forms(softer, assemble_first_order(softer));
  }
  const LoadedParts loaded(system, first);
  const Eigen::Index n = first.layout.size();
  const auto at = [&](const VectorXd& rest) { return loaded.added(loaded.second_order(rest)); };
  SecondOrderForms forms{at(VectorXd::Zero(n)), {}};
  for (Eigen::Index k = 0; k < n; ++k) forms.per_coordinate.push_back(at(VectorXd::Unit(n, k)) - forms.constant);
  return forms;
}

Eigen::MatrixXd SecondOrderForms::at(const VectorXd& rest) const {
  Eigen::MatrixXd sum = constant;
  for (Eigen::Index k = 0; k < rest.size(); ++k) sum += rest(k) * per_coordinate[to_size(k)];
  return sum;
}

}  // namespace trivet::assembly
