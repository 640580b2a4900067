// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/checks.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

#include "trivet/model/point_mass.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::model {

namespace {

/// True if the mass matrix of the free coordinates is invertible; otherwise there is no equation of motion.
bool has_regular_mass(const Body& body) {
  const spatial::Matrix6 a = spatial::mass_matrix(body.mass);
  std::vector<int> rows;
  for (int j = 0; j < 6; ++j)
    if (body.free[j]) rows.push_back(j);
  if (rows.empty()) return true;  // no free coordinate: reported separately
  Eigen::MatrixXd block = a(rows, rows);
  for (Eigen::Index i = 0; i < block.rows(); ++i)
    if (block(i, i) == 0) return false;
  const Eigen::VectorXd d = block.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  block = (d.asDiagonal() * block * d.asDiagonal()).eval();
  return numerics::is_regular(block, 1e-13);
}

}  // namespace

void check_body(const Body& body, foundation::Problems& problems) {
  const std::string subject = path_of(body);
  const bool may_move = std::ranges::any_of(body.free, [](bool f) { return f; }) ||
      std::ranges::any_of(body.left_out, [](bool left) { return left; });
  if (!may_move)
    problems.error(subject + ".free", "no free coordinate",
                   body.is_node ? "a node must be able to move" : "a body must be able to move",
                   "name at least one of x, y, z, rx, ry, rz, or make it part of the ground");
  if (body.is_node || is_point_mass(body)) return;
  const bool turns = body.free[3] || body.free[4] || body.free[5];
  if (!body.has_inertia && turns)
    problems.error(subject, "no inertia", "a body that can turn needs its moments of inertia",
                   "give inertia = {about = \"center_of_mass\", xx = …, yy = …, zz = …}; xx = 0, yy = 0, zz = 0 is a "
                   "point mass");
  if (turns && body.has_inertia && body.mass.mass > 0 && body.mass.inertia_about_centre.isZero(0)) {
    problems.error(subject + ".center_of_mass",
                   fmt::format("[{:.6g}, {:.6g}, {:.6g}] m of a point mass", body.mass.centre.x(), body.mass.centre.y(),
                               body.mass.centre.z()),
                   "a body whose inertia is zero has its pole at its centre of mass",
                   "move `position` there and leave out center_of_mass, or give the inertia");
    return;
  }
  std::vector<spatial::ViolatedBound> violated;
  if (body.has_inertia) {
    violated = spatial::violated_bounds(body.mass);
  } else if (!(body.mass.mass > 0)) {
    violated.push_back({fmt::format("mass = {:.6g} kg", body.mass.mass), "a mass must be > 0"});
  }
  const bool regular = has_regular_mass(body);
  for (const auto& bound : violated) {
    const bool of_mass = bound.finding.starts_with("mass =");
    const std::string subject_of_bound = subject + (of_mass ? ".mass" : ".inertia");
    if (body.allow_unphysical && regular)
      problems.warning(subject_of_bound, bound.finding, bound.rule,
                       "no real body has these numbers (allow_unphysical is set): every result is doubtful");
    else
      problems.error(subject_of_bound, bound.finding, bound.rule,
                     of_mass       ? "give a positive mass"
                         : regular ? "correct the value, its sign or its point of reference; allow_unphysical = true "
                                     "computes anyway and marks every result"
                                   : "correct the value: with a singular mass matrix no motion can be computed, even "
                                     "with allow_unphysical");
  }
}

void check_loose_bodies(const Description& description, foundation::Problems& problems) {
  if (description.elements.empty()) return;
  std::vector<bool> held(description.bodies.size(), false);
  for (const Element& element : description.elements)
    for (const End* end : {&element.k, &element.n})
      if (end->body) held[*end->body] = true;
  for (std::size_t b = 0; b < held.size(); ++b)
    if (!held[b] && !description.bodies[b].is_node)
      problems.warning("bodies." + description.bodies[b].name, "no element ends on it",
                       "a body that nothing holds moves freely, with a rigid-body mode at 0 Hz for each coordinate",
                       "name it in `on` or `from` of an element; if it is meant to be free, change nothing");
}

namespace {

/// Imbalance of the forces at rest, as a share of the weight, up to which no warning is given.
constexpr double silent_imbalance = 0.02;

/// Wrench of the preloaded elements on a body at rest, body axes, about its centre of mass; empty if the body has no
/// preloaded element.
std::optional<spatial::Wrench> preload_wrench(const Description& description, std::size_t body) {
  std::optional<spatial::Wrench> sum;
  for (const Element& element : description.elements) {
    if (!element.law.preload) continue;
    int first = 0;
    for (const End* end : {&element.n, &element.k}) {
      if (end->body == body) {
        const Eigen::Vector3d force = -(end->axes * element.law.preload->segment<3>(first)),
                              moment = -(end->axes * element.law.preload->segment<3>(first + 3));
        sum = sum.value_or(spatial::Wrench{});
        sum->force += force;
        sum->moment += moment + (end->at - description.bodies[body].mass.centre).cross(force);
      }
      first += 6;
    }
  }
  return sum;
}

/// Warns if the preloads on a node, which has no weight, do not balance.
void check_node(const Body& node, const Eigen::Vector3d& sum, double largest, foundation::Problems& problems) {
  if (sum.norm() <= silent_imbalance * largest) return;
  problems.warning(path_of(node),
                   fmt::format("the sum of its preloads is ({:.6g}, {:.6g}, {:.6g}) N", sum.x(), sum.y(), sum.z()),
                   "at rest the preloads of the elements on a node balance each other: it has no weight",
                   "set the preload of every element that ends on it");
}

/// Largest force at rest of any element.
double largest_preload(const Description& description) {
  double largest = 0;
  for (const Element& element : description.elements)
    if (element.law.preload)
      for (const int first : {0, 6}) largest = std::max(largest, element.law.preload->segment<3>(first).norm());
  return largest;
}

}  // namespace

void check_preloads(const Description& description, foundation::Problems& problems) {
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const Body& body = description.bodies[b];
    const auto sum = preload_wrench(description, b);
    if (!sum) continue;
    if (body.is_node) {
      check_node(body, sum->force, largest_preload(description), problems);
      continue;
    }
    if (!description.gravity) {
      problems.warning(
          "bodies." + body.name,
          fmt::format("its preloaded elements exert ({:.6g}, {:.6g}, {:.6g}) N on it", sum->force.x(), sum->force.y(),
                      sum->force.z()),
          "at rest the preloads of a body balance its weight, and both contribute to its geometric stiffness",
          "give gravity, for instance [0, 0, -9.80665], and check that the preloads act against it (preload of an "
          "element is positive in compression)");
      continue;
    }
    const Eigen::Vector3d weight = body.mass.mass * (body.pose.rotation.transpose() * *description.gravity);
    // The moment is converted to a lever arm of the weight and compared with the size of the body.
    const double left = (sum->force + weight).norm(), tilting = sum->moment.norm();
    const double size =
        body.has_inertia ? std::sqrt(std::abs(body.mass.inertia_about_centre.trace()) / (2 * body.mass.mass)) : 0;
    if (left > silent_imbalance * weight.norm() ||
        (body.free[3] && body.free[4] && tilting > silent_imbalance * weight.norm() * size))
      problems.warning(
          "bodies." + body.name,
          fmt::format("the sum of its preloads is ({:.6g}, {:.6g}, {:.6g}) N, its weight ({:.6g}, {:.6g}, {:.6g}) N; a "
                      "moment of {:.4g} N m about its centre of mass remains",
                      sum->force.x(), sum->force.y(), sum->force.z(), weight.x(), weight.y(), weight.z(), tilting),
          "at rest the forces and moments of the preloads balance the weight of the body",
          "set the preload of every element that carries it; elements without a preload carry what is left");
  }
}

}  // namespace trivet::model
