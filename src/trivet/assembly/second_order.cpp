// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/second_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "trivet/assembly/coordinates.h"
#include "trivet/assembly/loads.h"
#include "trivet/elements/distance_force.h"
#include "trivet/foundation/index.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

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
    assert(part < parent_.size() && "bodies, then foundations");
    while (parent_[part] != part) part = parent_[part];
    return part;
  }
  [[nodiscard]] std::optional<std::size_t> place(const model::End& end) const {
    if (end.body) return end.body;
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

/// @param turned  what forces at rest add to the elements, of those that follow them; otherwise zero
std::vector<EndForces> end_forces(const model::System& system, const Assembled& first, const VectorXd& rest,
                                  const std::vector<elements::Matrix12>& turned) {
  assert(turned.size() == system.elements().size() && rest.size() == first.layout.size());
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
    if (!turned[e].isZero(0)) all[e].in_all += turned[e] * map.coordinates(rest).head<12>();
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

/// The parts of a machine whose forces at rest are those of statics, under its load.
class LoadedParts {
 public:
  LoadedParts(const model::System& system, const Assembled& first)
      : system_(system),
        first_(first),
        parts_(system),
        of_statics_(parts_of_statics(system, first, parts_)),
        swings_(system.bodies().size(), Eigen::Vector3d::Zero()),
        turned_(system.elements().size(), elements::Matrix12::Zero()) {
    const VectorXd load = static_load(system, first);
    rest_ = coordinates_at_rest(first.matrices, load);
    const std::vector<bool> moves = unbalanced(system, first, parts_, load, rest_);
    // Machines with laws are where their own search for rest has brought them.
    const bool has_laws = std::ranges::any_of(system.elements(), model::has_laws);
    std::vector<std::size_t> settled;
    for (std::size_t b = 0; b < moves.size(); ++b) {
      const std::size_t root = parts_.root(b);
      if (!of_statics_[b] || std::ranges::find(settled, root) != settled.end()) continue;
      settled.push_back(root);
      if (!moves[b] && (has_laws || !is_hung(root, load))) continue;
      const Settled found = settle(root, load);
      if (found == Settled::near) hangs_aside_ = true;
      else if (found == Settled::far || moves[b]) leave_out(root);
    }
  }

  [[nodiscard]] const VectorXd& rest() const { return rest_; }

  /// What these forces at rest add to K.
  [[nodiscard]] Eigen::MatrixXd added(const SecondOrder& found) const {
    assert(found.of_elements.size() == first_.elements.size());
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
    const std::vector<EndForces> forces = end_forces(system_, first_, rest, turned_);
    Levers levers(system_, first_.layout);
    SecondOrder result;
    result.without_rest = without_rest_;
    result.hangs_aside = hangs_aside_;
    result.of_elements.assign(forces.size(), elements::Matrix12::Zero());
    for (std::size_t e = 0; e < forces.size(); ++e) {
      const model::Element& element = system_.elements()[e];
      if (!is_of_statics(element.n) && !is_of_statics(element.k)) continue;
      for (const auto& [end, first] : {std::pair{&element.n, 0}, {&element.k, 6}})
        if (end->body)
          levers.add(*end->body, end->at, as_hung(*end->body, end->axes * forces[e].in_all.segment<3>(first)));
      // The law between points of the ground is in axes of the ground; a residual under rigid motion is a load at rest.
      if (model::couples_ground_points(element) || element.allow_residual) continue;
      const model::Span span = model::span(system_.bodies(), element.n, element.k);
      result.of_elements[e] = elements::stiffness_of_force_at_rest(
          element.law, not_in_tangent(element, forces[e].of_law), span.arm, span.n_from_k);
    }
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      if (of_statics_[b]) levers.add(b, system_.bodies()[b].mass.centre, as_hung(b, -weight_of(b)));
    for (const model::ConstantForce& force : system_.description().constant_forces)
      if (of_statics_[force.body]) levers.add(force.body, force.at, as_hung(force.body, -force.wrench.force));
    levers.add_preloads([&](std::size_t body) { return !of_statics_[body]; });
    result.of_levers = levers.stiffness();
    return result;
  }

 private:
  [[nodiscard]] bool is_of_statics(const model::End& end) const {
    const auto part = parts_.place(end);
    return part && of_statics_[*part];
  }

  /// Body frame.
  [[nodiscard]] Eigen::Vector3d weight_of(std::size_t b) const {
    const model::Body& body = system_.bodies()[b];
    return body.mass.mass * (body.pose.rotation.transpose() * *system_.description().gravity);
  }

  /// A force on a body, drawn in its frame, as it meets the body that has swung to its position of rest.
  [[nodiscard]] Eigen::Vector3d as_hung(std::size_t b, const Eigen::Vector3d& force) const {
    const double sine = swings_[b].norm();  // a force that acts along its lever turns it by the sine of the angle
    assert(sine >= 0 && "positions of rest are finite, however far from the drawing they are");
    if (sine == 0) return force;
    return Eigen::AngleAxisd(-std::asin(std::min(1.0, sine)), swings_[b] / sine) * force;
  }

  [[nodiscard]] bool is_of(std::size_t root, const model::Element& element) const {
    const auto n = parts_.place(element.n), k = parts_.place(element.k);
    return (n && parts_.root(*n) == root) || (k && parts_.root(*k) == root);
  }

  /// Coordinates of a part: those of its bodies and inside its elements.
  [[nodiscard]] std::vector<Eigen::Index> rows_of(std::size_t root) const {
    std::set<Eigen::Index> rows;
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      for (int j = 0; parts_.root(b) == root && j < 6; ++j)
        if (const Eigen::Index row = first_.layout.row(b, j); row >= 0) rows.insert(row);
    for (std::size_t e = 0; e < system_.elements().size(); ++e)
      if (is_of(root, system_.elements()[e]))
        rows.insert(first_.elements[e].rows.begin(), first_.elements[e].rows.end());
    return {rows.begin(), rows.end()};
  }

  /// Turn of the bodies of a part, and of its elements across their length, over what is near the drawing: frequencies
  /// about such a position of rest are right to about two percent.
  [[nodiscard]] double turn(std::size_t root, const VectorXd& motion) const {
    constexpr double near_of_bodies = 0.3, near_of_elements = 0.1;  // [rad]
    double largest = 0;
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      if (parts_.root(b) == root)
        largest = std::max(largest, first_.layout.of_body(b, motion).template tail<3>().norm() / near_of_bodies);
    for (std::size_t e = 0; e < system_.elements().size(); ++e) {
      const model::Element& element = system_.elements()[e];
      const model::Span span = model::span(system_.bodies(), element.n, element.k);
      const double length = span.arm.norm();
      if (!is_of(root, element) || !(length > 0)) continue;
      const VectorXd ends = first_.elements[e].coordinates(motion);
      const Eigen::Vector3d apart = span.n_from_k * ends.segment<3>(6) - ends.segment<3>(0),
                            along = span.n_from_k * span.arm / length;
      largest = std::max(largest, (apart - along * along.dot(apart)).norm() / (near_of_elements * length));
    }
    return largest;
  }

  /// Is the part far from the drawing by K₀ alone, and drawn back by its weight more than by K₀?
  [[nodiscard]] bool is_hung(std::size_t root, const VectorXd& load) const {
    const double alone = turn(root, rest_);
    if (alone <= 1) return false;
    const std::vector<Eigen::Index> rows = rows_of(root);
    const std::optional<VectorXd> drawn_back = position(rows, second_order(rest_), load);
    if (!drawn_back) return false;
    VectorXd motion = rest_;
    motion(rows) = *drawn_back;
    return turn(root, motion) < alone / 2;
  }

  enum class Settled { near, far, nowhere };

  /// Finds the forces of a part that K₀ does not hold, or hardly, where its weight draws it to: K(q) q = Q. They are as
  /// before if it has no such position, or one far from the drawing.
  Settled settle(std::size_t root, const VectorXd& load) {
    const VectorXd before = rest_;
    const std::vector<Eigen::Index> rows = rows_of(root);
    const auto give_up = [&](Settled why) {
      rest_ = before;
      for (std::size_t b = 0; b < swings_.size(); ++b)
        if (parts_.root(b) == root) swings_[b].setZero();
      for (std::size_t e = 0; e < turned_.size(); ++e)
        if (is_of(root, system_.elements()[e])) turned_[e].setZero();
      return why;
    };
    constexpr int most = 60;
    constexpr double converged = 1e-13;
    for (int step = 0; step < most; ++step) {
      const SecondOrder found = second_order(rest_);
      const std::optional<VectorXd> next = position(rows, found, load);
      if (!next) return give_up(Settled::nowhere);
      const VectorXd change = *next - rest_(rows);
      rest_(rows) = *next;
      for (std::size_t b = 0; b < swings_.size(); ++b)
        if (parts_.root(b) == root) swings_[b] = first_.layout.of_body(b, rest_).template tail<3>();
      for (std::size_t e = 0; e < turned_.size(); ++e)
        if (is_of(root, system_.elements()[e])) turned_[e] = found.of_elements[e];
      if (change.norm() > converged * next->norm()) continue;
      return turn(root, rest_) <= 1 ? Settled::near : give_up(Settled::far);
    }
    return give_up(Settled::far);
  }

  /// Coordinates of a part on its stiffness with these forces at rest; none if nothing draws it back.
  [[nodiscard]] std::optional<VectorXd> position(const std::vector<Eigen::Index>& rows, const SecondOrder& found,
                                                 const VectorXd& load) const {
    constexpr double held = 1e-12;    // of the stiffest direction
    constexpr double nothing = 1e-6;  // of the load
    const VectorXd scale = numerics::unit_scale(first_.matrices)(rows);
    const Eigen::MatrixXd whole = (first_.matrices.K + added(found))(rows, rows);
    const Eigen::MatrixXd stiffness = scale.asDiagonal() * (0.5 * (whole + whole.transpose())) * scale.asDiagonal();
    const auto modes = numerics::symmetric_eigen(stiffness);
    const VectorXd along = modes.vectors.transpose() * (scale.asDiagonal() * load(rows));
    VectorXd result = VectorXd::Zero(along.size());
    for (Eigen::Index i = 0; i < along.size(); ++i)
      if (modes.values(i) > held * modes.values.cwiseAbs().maxCoeff())
        result += along(i) / modes.values(i) * modes.vectors.col(i);
      else if (std::abs(along(i)) > nothing * along.norm()) return std::nullopt;
    return VectorXd(scale.asDiagonal() * result);
  }

  void leave_out(std::size_t root) {
    for (std::size_t b = 0; b < of_statics_.size() && b < system_.bodies().size(); ++b)
      if (parts_.root(b) == root && of_statics_[b]) {
        without_rest_.push_back(b);
        of_statics_[b] = false;
      }
  }

  const model::System& system_;
  const Assembled& first_;
  JoinedParts parts_;
  std::vector<bool> of_statics_;
  std::vector<std::size_t> without_rest_;
  std::vector<Eigen::Vector3d> swings_;     ///< per body, its frame
  std::vector<elements::Matrix12> turned_;  ///< per element, of parts that have settled
  bool hangs_aside_ = false;
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
  assert(to_index(per_coordinate.size()) == rest.size() && "the forms are linear in every coordinate at rest");
  Eigen::MatrixXd sum = constant;
  for (Eigen::Index k = 0; k < rest.size(); ++k) sum += rest(k) * per_coordinate[k];
  return sum;
}

}  // namespace trivet::assembly
