// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/assembled.h"

#include "trivet/elements/law.h"
#include "trivet/numerics/generalized_modes.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

using spatial::Matrix12;
using spatial::Matrix6;

/// Adds the end's six displacements (rows from `first_row`) as they follow the coordinates of its body.
void add_end(const Layout& layout, const model::End& end, int first_row, ElementMap& map) {
  if (!end.body) return;
  const Matrix6 motion = spatial::both_blocks(end.axes).transpose() * spatial::rigid_motion(end.at);
  for (int j = 0; j < 6; ++j) {
    const Eigen::Index row = layout.row(*end.body, j);
    if (row < 0) continue;
    map.rows.push_back(row);
    map.ends.conservativeResize(Eigen::NoChange, map.ends.cols() + 1);
    map.ends.rightCols<1>().setZero();
    map.ends.rightCols<1>().segment<6>(first_row) = motion.col(j);
  }
}

void scatter(const ElementMap& map, const Matrix12& matrix, double factor, Eigen::MatrixXd& global) {
  const Eigen::MatrixXd local = map.ends.transpose() * matrix * map.ends;
  for (Eigen::Index i = 0; i < local.rows(); ++i)
    for (Eigen::Index j = 0; j < local.cols(); ++j)
      global(map.rows[static_cast<std::size_t>(i)], map.rows[static_cast<std::size_t>(j)]) += factor * local(i, j);
}

void add_body(const Layout& layout, std::size_t index, const model::Body& body, Eigen::MatrixXd& mass) {
  const Matrix6 a = spatial::mass_matrix(body.mass);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      if (layout.row(index, i) >= 0 && layout.row(index, j) >= 0) mass(layout.row(index, i), layout.row(index, j)) += a(i, j);
}

void make_exactly_symmetric(Eigen::MatrixXd& m) { m = (0.5 * (m + m.transpose())).eval(); }

Eigen::MatrixXd modal_damping(const numerics::DynamicMatrices& m, const model::ModalDamping& damping) {
  const auto modes = numerics::generalized_modes(m.K, m.A, true);
  Eigen::VectorXd twice(modes.lambda.size());
  for (Eigen::Index i = 0; i < twice.size(); ++i) {
    const double ratio = damping.ratios.size() == 1 ? damping.ratios[0] : damping.ratios[static_cast<std::size_t>(i)];
    twice(i) = 2 * ratio * std::sqrt(std::max(modes.lambda(i), 0.0));
  }
  const Eigen::MatrixXd a_phi = m.A * modes.shapes;
  return a_phi * twice.asDiagonal() * a_phi.transpose();
}

}  // namespace

Assembled assemble(const model::System& system) {
  Assembled result{Layout(system.bodies()), {}, {}};
  const Eigen::Index n = result.layout.size();
  numerics::DynamicMatrices& m = result.matrices;
  m.A = m.B = m.K = m.K_loss = Eigen::MatrixXd::Zero(n, n);
  bool lossy = false;
  for (std::size_t i = 0; i < system.bodies().size(); ++i) add_body(result.layout, i, system.bodies()[i], m.A);
  for (const model::Element& element : system.elements()) {
    ElementMap& map = result.elements.emplace_back();
    add_end(result.layout, element.n, 0, map);
    add_end(result.layout, element.k, 6, map);
    map.stiffness = elements::stiffness(element.law);
    map.damping = elements::viscous_damping(element.law);
    map.loss_factor = elements::loss_factor(element.law);
    scatter(map, map.stiffness, 1, m.K);
    scatter(map, map.damping, 1, m.B);
    scatter(map, map.stiffness, map.loss_factor, m.K_loss);
    lossy = lossy || map.loss_factor > 0;
    m.symmetric = m.symmetric && element.symmetric;
  }
  if (m.symmetric)
    for (Eigen::MatrixXd* matrix : {&m.A, &m.B, &m.K, &m.K_loss}) make_exactly_symmetric(*matrix);
  if (!lossy) m.K_loss.resize(0, 0);

  const model::SystemDamping& damping = system.description().damping;
  if (const auto* rayleigh = std::get_if<model::RayleighDamping>(&damping)) m.B += rayleigh->mass * m.A + rayleigh->stiffness * m.K;
  if (const auto* modal = std::get_if<model::ModalDamping>(&damping)) m.B += modal_damping(m, *modal);
  if (m.symmetric) make_exactly_symmetric(m.B);
  return result;
}

}  // namespace trivet::assembly
