// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/second_order.h"

#include <cassert>

#include "trivet/elements/distance_force.h"

namespace trivet::assembly {

Levers::Levers(const model::System& system, const Layout& layout)
    : system_(system), layout_(layout), stiffness_(Eigen::MatrixXd::Zero(layout.size(), layout.size())) {}

void Levers::add(std::size_t body, const Eigen::Vector3d& at, const Eigen::Vector3d& force) {
  const Eigen::Matrix3d block = elements::stiffness_of_lever(at, force);
  assert((block.isApprox(block.transpose()) || !block.allFinite()) && "½(aFᵀ + Faᵀ) − (a·F) I is symmetric");
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Eigen::Index row = layout_.row(body, 3 + i), column = layout_.row(body, 3 + j);
      if (row >= 0 && column >= 0) stiffness_(row, column) += block(i, j);
    }
}

void Levers::add_weight(std::size_t body) {
  const auto& gravity = system_.description().gravity;
  if (!gravity) return;
  const model::Body& own = system_.bodies()[body];
  const Eigen::Vector3d weight = own.mass.mass * (own.pose.rotation.transpose() * *gravity);
  add(body, own.mass.centre, -weight);
}

void Levers::add_preloads_of(std::size_t body) {
  bool preloaded = false;
  for (const model::Element& element : system_.elements()) {
    if (!element.law.preload) continue;
    int first = 0;
    for (const model::End* end : {&element.n, &element.k}) {
      if (end->body == body) {
        add(body, end->at, end->axes * element.law.preload->segment<3>(first));
        preloaded = true;
      }
      first += 6;
    }
  }
  // For forces that do not balance the result would depend on the pole: a weight that no preload carries is excluded.
  if (preloaded) add_weight(body);
}

Eigen::MatrixXd geometric_stiffness(const model::System& system, const Layout& layout) {
  Levers levers(system, layout);
  levers.add_preloads([](std::size_t) { return true; });
  return levers.stiffness();
}

}  // namespace trivet::assembly
