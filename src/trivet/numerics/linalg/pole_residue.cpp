// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/pole_residue.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/numerics/linalg/quadratic_roots.h"

namespace trivet::numerics {
namespace {

using foundation::epsilon;
using Rows = std::vector<Eigen::Index>;

PoleResidueForm empty_form(Eigen::Index n, Eigen::Index right_sides) {
  PoleResidueForm form;
  form.free_motion = form.static_part = Eigen::MatrixXcd::Zero(n, right_sides);
  return form;
}

/// (s − state)⁻¹ from the eigenvectors. Their inverse separates equal poles; products with left eigenvectors would not.
void add_poles(const StateForm& form, PoleResidueForm& result) {
  const GeneralEigen eigen = eigen_of_states(form);
  result.poles = eigen.values;
  result.participation = PivotedLu<Complex>(eigen.vectors).solve(form.input);
  result.shapes = form.output * eigen.vectors;
  assert(result.shapes.cols() == result.poles.size() && result.participation.rows() == result.poles.size());
}

bool is_diagonal(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& available) {
  if (matrix.size() == 0) return true;
  const double round_off = 64 * static_cast<double>(matrix.rows()) * epsilon;
  Eigen::MatrixXd off = matrix;
  off.diagonal().setZero();
  return (off.array().abs() <= round_off * available.array()).all();
}

/// η̈ + b η̇ + (ω² + i loss) η = p for each mode separately.
PoleResidueForm decoupled(const Eigen::MatrixXd& phi, const Eigen::VectorXd& lambda, const Eigen::VectorXd& b,
                          const Eigen::VectorXd& loss, const Eigen::MatrixXcd& right_sides) {
  const Eigen::MatrixXcd modal = phi.transpose() * right_sides;
  PoleResidueForm result = empty_form(phi.rows(), right_sides.cols());
  const Eigen::Index n = lambda.size();
  assert(b.size() == n && loss.size() == n && (lambda.array() >= 0).all() && "one quadratic equation for each mode");
  const auto resting = [&](Eigen::Index i) { return lambda(i) == 0 && b(i) == 0 && loss(i) == 0; };
  Eigen::Index moving = 0;
  for (Eigen::Index i = 0; i < n; ++i) moving += resting(i) ? 0 : 1;
  result.poles.resize(2 * moving);
  result.shapes.resize(phi.rows(), 2 * moving);
  result.participation.resize(2 * moving, right_sides.cols());
  for (Eigen::Index i = 0, k = 0; i < n; ++i) {
    if (resting(i)) {
      result.free_motion += phi.col(i) * modal.row(i);
      continue;
    }
    const Complex product(lambda(i), loss(i)), root = std::sqrt(0.25 * b(i) * b(i) - product);
    Complex one, two;
    if (root.real() == 0) {
      one = -0.5 * b(i) + root, two = -0.5 * b(i) - root;  // a conjugate pair
    } else {  // the larger first, the other from the product: no cancellation
      one = -0.5 * b(i) - root, two = product / one;
    }
    for (const Complex& pole : {one, two}) {
      result.poles(k) = pole;
      result.shapes.col(k) = phi.col(i).cast<Complex>();
      result.participation.row(k++) = modal.row(i) / (pole == one ? one - two : two - one);
    }
  }
  return result;
}

/// States (w η, η̇) of the undamped modes, except rigid-body modes without damping; w = ω, for ω = 0 the lowest ω > 0.
PoleResidueForm in_modes(const DynamicMatrices& m, const GeneralizedModes& modes, const Eigen::MatrixXcd& right_sides) {
  const Eigen::MatrixXd& phi = modes.shapes;
  Eigen::MatrixXd damping = phi.transpose() * m.B * phi;
  const Eigen::MatrixXd available = phi.cwiseAbs().transpose() * m.B.cwiseAbs() * phi.cwiseAbs();
  damping =
      (damping.array().abs() <= 64 * static_cast<double>(m.size()) * epsilon * available.array()).select(0.0, damping);
  const Eigen::Index n = modes.lambda.size();
  const Eigen::MatrixXd loss =
      m.lossy() ? Eigen::MatrixXd(phi.transpose() * m.K_loss * phi) : Eigen::MatrixXd::Zero(n, n);
  const Eigen::MatrixXd available_loss =
      m.lossy() ? Eigen::MatrixXd(phi.cwiseAbs().transpose() * m.K_loss.cwiseAbs() * phi.cwiseAbs()) : loss;
  if (is_diagonal(damping, available) && is_diagonal(loss, available_loss))
    return decoupled(phi, modes.lambda, damping.diagonal(), loss.diagonal(), right_sides);

  Rows moving;
  double slowest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (modes.lambda(i) > 0) slowest = std::min(slowest, std::sqrt(modes.lambda(i)));
    if (modes.lambda(i) > 0 || !damping.row(i).isZero(0)) moving.push_back(i);
  }
  const auto count = to_index(moving.size());
  if (!std::isfinite(slowest)) slowest = damping.cwiseAbs().maxCoeff();
  assert(n == m.size() && (modes.lambda.array() >= 0).all() && "the modes are a complete basis");
  const Eigen::VectorXd omega = modes.lambda(moving).cwiseSqrt();
  const Eigen::VectorXd weight = (omega.array() > 0).select(omega.array(), slowest);
  StateForm form;
  form.real = !m.lossy();
  form.state = Eigen::MatrixXcd::Zero(2 * count, 2 * count);
  form.state.topRightCorner(count, count).diagonal() = weight.cast<Complex>();
  form.state.bottomLeftCorner(count, count).diagonal() = -omega.cwiseAbs2().cwiseQuotient(weight).cast<Complex>();
  if (m.lossy())
    form.state.bottomLeftCorner(count, count) -=
        Complex(0, 1) * (loss(moving, moving) * weight.cwiseInverse().asDiagonal()).cast<Complex>();
  form.state.bottomRightCorner(count, count) = -damping(moving, moving).cast<Complex>();
  const Eigen::MatrixXd shapes = phi(Eigen::all, moving);
  form.input = Eigen::MatrixXcd::Zero(2 * count, right_sides.cols());
  form.input.bottomRows(count) = shapes.transpose() * right_sides;
  form.output = Eigen::MatrixXcd::Zero(m.size(), 2 * count);
  form.output.leftCols(count) = (shapes * weight.cwiseInverse().asDiagonal()).cast<Complex>();
  PoleResidueForm result = empty_form(m.size(), right_sides.cols());
  add_poles(form, result);
  for (const Eigen::Index i : rows_without(n, moving))
    result.free_motion += phi.col(i) * (phi.col(i).transpose() * right_sides);
  return result;
}

PoleResidueForm in_states(const DynamicMatrices& m, const Eigen::MatrixXcd& right_sides) {
  const StateForm form = state_form(m, right_sides);
  if (!form.state.allFinite() || !form.input.allFinite())
    throw foundation::NotComputable("a coordinate without mass is not supported by stiffness or damping");
  PoleResidueForm result = empty_form(m.size(), right_sides.cols());
  add_poles(form, result);
  return result;
}

Rows held_by_stiffness_only(const DynamicMatrices& m) {
  Rows rows;
  for (Eigen::Index i = 0; i < m.size(); ++i)
    if (m.A.row(i).isZero(0) && m.A.col(i).isZero(0) && m.B.row(i).isZero(0) && m.B.col(i).isZero(0)) rows.push_back(i);
  return rows;
}

/// Static condensation of the coordinates with stiffness only: q_z = K_zz⁻¹ (h_z − K_zp q_p).
PoleResidueForm condensed(const DynamicMatrices& m, const Rows& z, const Eigen::MatrixXcd& h) {
  const Rows p = rows_without(m.size(), z);
  const Eigen::MatrixXcd K = m.complex_stiffness(), held = K(z, z);
  const PivotedLu<Complex> lu(held);
  const Eigen::MatrixXcd follow = -lu.solve(Eigen::MatrixXcd(K(z, p))),
                         at_once = lu.solve(Eigen::MatrixXcd(h(z, Eigen::all)));
  if (!follow.allFinite() || !at_once.allFinite())
    throw foundation::NotComputable("a coordinate without mass is not supported by stiffness or damping");
  const Eigen::MatrixXcd rest = K(p, p) + K(p, z) * follow;
  const DynamicMatrices reduced{m.A(p, p), m.B(p, p), rest.real(),
                                m.lossy() ? Eigen::MatrixXd(rest.imag()) : Eigen::MatrixXd(), m.symmetric};
  const PoleResidueForm inner = pole_residue_form(reduced, h(p, Eigen::all) - K(p, z) * at_once);
  PoleResidueForm result = empty_form(m.size(), h.cols());
  result.poles = inner.poles;
  result.participation = inner.participation;
  result.shapes.resize(m.size(), inner.poles.size());
  result.shapes(p, Eigen::all) = inner.shapes;
  result.shapes(z, Eigen::all) = follow * inner.shapes;
  result.free_motion(p, Eigen::all) = inner.free_motion;
  result.free_motion(z, Eigen::all) = follow * inner.free_motion;
  result.static_part(p, Eigen::all) = inner.static_part;
  result.static_part(z, Eigen::all) = at_once + follow * inner.static_part;
  return result;
}

}  // namespace

PoleResidueForm pole_residue_form(const DynamicMatrices& m, const Eigen::MatrixXcd& right_sides) {
  if (right_sides.cols() == 0) {  // only poles and shapes are requested: products without columns are avoided
    PoleResidueForm form = pole_residue_form(m, Eigen::MatrixXcd::Zero(m.size(), 1));
    form.participation.resize(form.poles.size(), 0);
    form.free_motion.resize(m.size(), 0);
    form.static_part.resize(m.size(), 0);
    return form;
  }
  if (const PartedSystem parted = parted_system(m); parted.any) {
    PoleResidueForm form = pole_residue_form(parted.matrices, parted.basis.transpose() * right_sides);
    for (Eigen::MatrixXcd* rows : {&form.shapes, &form.free_motion, &form.static_part})
      *rows = (parted.basis * *rows).eval();
    return form;
  }
  const Rows held = held_by_stiffness_only(m);
  if (!held.empty() && to_index(held.size()) < m.size()) return condensed(m, held, right_sides);
  if (to_index(massive_rows(m.A).size()) == m.size()) {
    const GeneralizedModes modes = generalized_modes(m.K, m.A, m.symmetric);
    if (modes.route == ModeRoute::definite_mass && modes.lambda.size() == m.size() && modes.lambda.minCoeff() >= 0)
      return in_modes(m, modes, right_sides);
  }
  return in_states(m, right_sides);
}

}  // namespace trivet::numerics
