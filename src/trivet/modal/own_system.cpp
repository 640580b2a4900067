// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/own_system.h"

#include <cassert>
#include <set>

#include "trivet/foundation/index.h"
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

}  // namespace trivet::modal
