// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "trivet/model/checks.h"

namespace trivet::model {
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
