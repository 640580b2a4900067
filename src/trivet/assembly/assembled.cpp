// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/assembled.h"

#include <algorithm>
#include <cmath>

#include "trivet/assembly/geometric_stiffness.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/elements/law.h"
#include "trivet/numerics/generalized_modes.h"
#include "trivet/numerics/massless.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

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

ElementMap map_of(const Layout& layout, std::size_t index, const model::Element& element) {
  ElementMap map;
  map.matrices = elements::matrices(element.law);
  const Eigen::Index internal = map.matrices.stiffness.rows() - 12;
  map.ends.resize(12 + internal, 0);
  add_end(layout, element.n, 0, map);
  add_end(layout, element.k, 6, map);
  map.end_columns = map.ends.cols();
  map.ends.conservativeResize(Eigen::NoChange, map.end_columns + internal);
  map.ends.rightCols(internal).setZero();
  map.ends.bottomRightCorner(internal, internal).setIdentity();
  for (Eigen::Index i = 0; i < internal; ++i) map.rows.push_back(layout.internal_row(index) + i);
  if (elements::is_frequency_dependent(element.law))
    map.dynamic_stiffness = [law = element.law, name = element.name](std::complex<double> omega, double near) -> elements::Matrix12c {
      try {
        return elements::dynamic_stiffness(law, omega, near);
      } catch (const foundation::NotComputable& reason) {
        throw foundation::NotComputable("element \"" + name + "\": " + reason.what());
      }
    };
  if (const auto& given = element.law.frequency_dependence) {
    map.defined_from = given->from;
    map.defined_to = given->to;
    map.knots = given->knots;
  }
  return map;
}

void scatter(const ElementMap& map, const Eigen::MatrixXd& matrix, double factor, Eigen::MatrixXd& global) {
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

/// Rayleigh and modal damping act on the coordinates with mass, with the stiffness that those without mass leave them at rest.
void add_system_damping(const model::SystemDamping& damping, numerics::DynamicMatrices& m) {
  if (std::holds_alternative<std::monostate>(damping)) return;
  const numerics::MassiveSystem massive = numerics::massive_system(m);
  const std::vector<Eigen::Index> rows = numerics::massive_rows(m.A);
  if (const auto* rayleigh = std::get_if<model::RayleighDamping>(&damping))
    m.B(rows, rows) += rayleigh->mass * massive.A + rayleigh->stiffness * massive.K;
  if (const auto* given = std::get_if<model::ModalDamping>(&damping)) {
    const auto modes = numerics::generalized_modes(massive.K, massive.A, true);
    Eigen::VectorXd twice(modes.lambda.size());
    for (Eigen::Index i = 0; i < twice.size(); ++i) {
      const double ratio = given->ratios.size() == 1 ? given->ratios[0] : given->ratios[static_cast<std::size_t>(i)];
      twice(i) = 2 * ratio * std::sqrt(std::max(modes.lambda(i), 0.0));
    }
    const Eigen::MatrixXd a_phi = massive.A * modes.shapes;
    m.B(rows, rows) += a_phi * twice.asDiagonal() * a_phi.transpose();
  }
}

/// Sums bodies and the elements that `wanted` admits.
template <typename Wanted>
numerics::DynamicMatrices summed(const model::System& system, const Assembled& assembled, Eigen::Index n, const Wanted& wanted) {
  numerics::DynamicMatrices m;
  m.A = m.B = m.K = m.K_loss = Eigen::MatrixXd::Zero(n, n);
  bool lossy = false;
  for (std::size_t i = 0; i < system.bodies().size(); ++i) add_body(assembled.layout, i, system.bodies()[i], m.A);
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
    const ElementMap& map = assembled.elements[e];
    m.symmetric = m.symmetric && system.elements()[e].symmetric;
    if (!wanted(map)) continue;
    scatter(map, map.matrices.stiffness, 1, m.K);
    scatter(map, map.matrices.damping, 1, m.B);
    scatter(map, map.matrices.mass, 1, m.A);
    scatter(map, map.matrices.stiffness, map.matrices.loss_factor, m.K_loss);
    lossy = lossy || map.matrices.loss_factor > 0;
  }
  m.K += geometric_stiffness(system, assembled.layout).topLeftCorner(n, n);
  if (m.symmetric)
    for (Eigen::MatrixXd* matrix : {&m.A, &m.B, &m.K, &m.K_loss}) make_exactly_symmetric(*matrix);
  if (!lossy) m.K_loss.resize(0, 0);
  return m;
}

}  // namespace

Assembled assemble(const model::System& system) {
  std::vector<Eigen::Index> internal;
  std::vector<bool> last;
  for (const model::Element& element : system.elements()) {
    internal.push_back(elements::matrices(element.law).stiffness.rows() - 12);
    last.push_back(elements::is_frequency_dependent(element.law));
  }
  Assembled result{Layout(system.bodies(), internal, last), {}, {}, {}};
  for (std::size_t e = 0; e < system.elements().size(); ++e) result.elements.push_back(map_of(result.layout, e, system.elements()[e]));
  numerics::DynamicMatrices& m = result.matrices;
  m = summed(system, result, result.layout.size(), [](const ElementMap&) { return true; });
  const Eigen::MatrixXd without = m.B;
  add_system_damping(system.description().damping, m);
  if (m.symmetric) make_exactly_symmetric(m.B);
  if (std::find(last.begin(), last.end(), true) != last.end()) {
    const Eigen::Index n = result.layout.before_last();
    result.constant = summed(system, result, n, [](const ElementMap& map) { return !map.frequency_dependent(); });
    result.constant.B += (m.B - without).topLeftCorner(n, n);
  }
  return result;
}

Eigen::MatrixXcd Assembled::dynamic_stiffness(std::complex<double> omega, double near) const {
  const numerics::DynamicMatrices& m = frequency_dependent() ? constant : matrices;
  Eigen::MatrixXcd z = m.complex_stiffness() + std::complex<double>(0, 1) * omega * m.B - omega * omega * m.A;
  for (const ElementMap& map : elements) {
    if (!map.frequency_dependent()) continue;
    const Eigen::MatrixXcd ends = map.ends.topLeftCorner(12, map.end_columns);
    const Eigen::MatrixXcd local = ends.transpose() * map.dynamic_stiffness(omega, near) * ends;
    for (Eigen::Index i = 0; i < local.rows(); ++i)
      for (Eigen::Index j = 0; j < local.cols(); ++j) z(map.rows[static_cast<std::size_t>(i)], map.rows[static_cast<std::size_t>(j)]) += local(i, j);
  }
  return z;
}

}  // namespace trivet::assembly
