// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/geometric_stiffness.h"

#include <vector>

namespace trivet::assembly {
namespace {

Eigen::Matrix3d second_order(const Eigen::Vector3d& lever, const Eigen::Vector3d& force) {
  return 0.5 * (lever * force.transpose() + force * lever.transpose()) - lever.dot(force) * Eigen::Matrix3d::Identity();
}

void add_rotations(const Layout& layout, std::size_t body, const Eigen::Matrix3d& block, Eigen::MatrixXd& stiffness) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Eigen::Index row = layout.row(body, 3 + i), column = layout.row(body, 3 + j);
      if (row >= 0 && column >= 0) stiffness(row, column) += block(i, j);
    }
}

}  // namespace

Eigen::MatrixXd geometric_stiffness(const model::System& system, const Layout& layout) {
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(layout.size(), layout.size());
  std::vector<bool> preloaded(system.bodies().size(), false);
  for (const model::Element& element : system.elements()) {
    if (!element.law.preload) continue;
    int first = 0;
    for (const model::End* end : {&element.n, &element.k}) {
      const Eigen::Vector3d force = end->axes * element.law.preload->segment<3>(first);
      if (end->body) {
        add_rotations(layout, *end->body, second_order(end->at, force), stiffness);
        preloaded[*end->body] = true;
      }
      first += 6;
    }
  }
  // For forces that do not balance the result would depend on the pole: a weight that no preload carries is excluded.
  if (const auto& gravity = system.description().gravity)
    for (std::size_t b = 0; b < system.bodies().size(); ++b) {
      if (!preloaded[b]) continue;
      const model::Body& body = system.bodies()[b];
      const Eigen::Vector3d weight = body.mass.mass * (body.pose.rotation.transpose() * *gravity);
      add_rotations(layout, b, -second_order(body.mass.centre, weight), stiffness);
    }
  return stiffness;
}

}  // namespace trivet::assembly
