// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/model/checks.h"

namespace trivet::model {
namespace {

/// Imbalance of the forces at rest, as a share of the weight, that passes in silence.
constexpr double silent_imbalance = 0.02;

/// What the preloaded elements exert on a body at rest, in its axes; none if no element at it is preloaded.
std::optional<Eigen::Vector3d> carried(const Description& description, std::size_t body) {
  std::optional<Eigen::Vector3d> sum;
  for (const Element& element : description.elements) {
    if (!element.law.preload) continue;
    int first = 0;
    for (const End* end : {&element.n, &element.k}) {
      const Eigen::Vector3d on_body = -(end->axes * element.law.preload->segment<3>(first));
      if (end->body == body) sum = sum.value_or(Eigen::Vector3d::Zero()) + on_body;
      first += 6;
    }
  }
  return sum;
}

}  // namespace

void check_preloads(const Description& description, foundation::Problems& problems) {
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const Body& body = description.bodies[b];
    const auto sum = carried(description, b);
    if (!sum) continue;
    if (!description.gravity) {
      problems.warning("bodies." + body.name, fmt::format("its preloaded elements exert {:.6g} N on it", sum->norm()),
                       "at rest a body's preloads balance its weight, and both stiffen or soften its rotations", "give gravity = [0, 0, -9.80665]");
      continue;
    }
    const Eigen::Vector3d weight = body.mass.mass * (body.pose.rotation.transpose() * *description.gravity);
    const double left = (*sum + weight).norm();
    if (left > silent_imbalance * weight.norm())
      problems.warning("bodies." + body.name, fmt::format("preloads and weight leave {:.6g} N of its {:.6g} N", left, weight.norm()),
                       "at rest a body's preloads balance its weight", "set the preload of every element that carries it; what other elements carry has no geometric stiffness here");
  }
}

}  // namespace trivet::model
