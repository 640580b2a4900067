// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/modes/free_motion.h"

#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/modes.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<ModeAtRest> modes_at_rest(const model::System& system, const assembly::Assembled& assembled,
                                      const MatrixXd& holding) {
  std::vector<ModeAtRest> found;
  const modal::Modes all = modal::modes(system, assembled);
  MatrixXd still(assembled.matrices.size(), 0);
  for (const modal::Mode& mode : all.list) {
    if (mode.eigenvalue_squared != 0) continue;
    still.conservativeResize(Eigen::NoChange, still.cols() + 1);
    still.rightCols<1>() = mode.coordinates / std::sqrt(std::abs(mode.modal_mass));
  }
  if (still.cols() > 0) {
    const auto eigen = numerics::symmetric_eigen(MatrixXd(still.transpose() * holding * still));
    constexpr double round_off = 1e-12;  // of rigid-body modes
    const double least = round_off * holding.diagonal().cwiseAbs().maxCoeff() * still.squaredNorm();
    for (Index i = 0; i < eigen.values.size(); ++i)
      if (eigen.values(i) > least) found.push_back({0, still * eigen.vectors.col(i)});
  }
  for (const modal::Mode& mode : all.list)
    if (mode.angular_frequency && *mode.angular_frequency > 0)
      found.push_back({*mode.angular_frequency, mode.coordinates});
  return found;
}

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Coordinates × deflections.
MatrixXd columns(const std::vector<Deflection>& deflections, Index coordinates) {
  MatrixXd found(coordinates, to_index(deflections.size()));
  for (std::size_t j = 0; j < deflections.size(); ++j) found.col(to_index(j)) = deflections[j].on_coordinates;
  return found;
}

}  // namespace

FreeMotion::FreeMotion(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections, bool damped,
                       Index harmonics, const MatrixXd& holding)
    : A_(assembled.matrices.A),
      B_(assembled.matrices.B),
      K_(assembled.matrices.K),
      K_loss_(assembled.matrices.K_loss),
      damped_(damped),
      harmonics_(harmonics),
      across_(columns(deflections, A_.rows())),
      sizes_(deflections, across_.transpose() * numerics::PivotedLu<double>(holding).solve(across_)),
      laws_(deflections, sizes_, harmonics, harmonics),
      wider_(deflections, sizes_, 3 * harmonics, harmonics) {}

Index FreeMotion::place(Index coefficient) const {
  const Index n = coordinates();
  if (damped_) return n * coefficient;
  return coefficient == 0 ? 0 : coefficient % 2 == 1 ? n * (coefficient + 1) / 2 : -1;
}

MatrixXd FreeMotion::motion(const VectorXd& unknowns) const {
  MatrixXd found = MatrixXd::Zero(numerics::coefficient_count(harmonics_), coordinates());
  for (Index c = 0; c < found.rows(); ++c)
    if (place(c) >= 0) found.row(c) = unknowns.segment(place(c), coordinates()).transpose();
  return found;
}
void FreeMotion::set_mode(const VectorXd& shape, double ratio_scale) {
  phase_ = shape;
  ratio_scale_ = ratio_scale;
}

void FreeMotion::evaluate(const VectorXd& unknowns, double omega, numerics::Equations& equations) const {
  const Index n = coordinates(), count = numerics::coefficient_count(harmonics_);
  const double ratio = damping_ratio(unknowns);
  equations.value = VectorXd::Zero(size());
  equations.by_unknowns = MatrixXd::Zero(size(), size());
  equations.by_parameter = VectorXd::Zero(size());
  for (Index c = 0; c < count; ++c) {
    const Index row = place(c);
    if (row < 0) continue;
    const Index harmonic = (c + 1) / 2;
    const auto k = static_cast<double>(harmonic);
    const MatrixXd stiffness = K_ - k * k * omega * omega * A_;
    const auto q = unknowns.segment(row, n);
    equations.value.segment(row, n) += stiffness * q;
    equations.by_unknowns.block(row, row, n, n) += stiffness;
    equations.by_parameter.segment(row, n) -= 2 * k * k * omega * (A_ * q);
    if (!damped_ || c == 0) continue;
    const bool is_cosine = c % 2 == 1;
    const Index other = place(is_cosine ? c + 1 : c - 1);
    const double sign = is_cosine ? 1 : -1;
    const VectorXd beside = unknowns.segment(other, n);
    MatrixXd damping = sign * k * omega * (B_ - 2 * ratio * omega * A_);
    if (K_loss_.size() > 0) damping += sign * K_loss_;
    equations.value.segment(row, n) += damping * beside;
    equations.by_unknowns.block(row, other, n, n) += damping;
    equations.by_unknowns.col(size() - 1).segment(row, n) -=
        sign * 2 * k * omega * omega / ratio_scale_ * (A_ * beside);
    equations.by_parameter.segment(row, n) += sign * k * ((B_ - 4 * ratio * omega * A_) * beside);
  }
  add_forces(unknowns, omega, equations);
  if (damped_) {  // the phase: the rate of the first harmonic, weighted by its cosines, is zero at phase 0
    const VectorXd weights = A_ * phase_;
    equations.value(size() - 1) = weights.dot(unknowns.segment(place(2), n));
    equations.by_unknowns.row(size() - 1).segment(place(2), n) = weights.transpose();
  }
}

void FreeMotion::add_forces(const VectorXd& unknowns, double omega, numerics::Equations& equations) const {
  const CoupledForces forces = laws_.at(deflections(unknowns), omega);
  const Index n = coordinates();
  for (Index c = 0; c < forces.force.rows(); ++c) {
    if (place(c) < 0) continue;
    equations.value.segment(place(c), n) += across_ * forces.force.row(c).transpose();
    equations.by_parameter.segment(place(c), n) += across_ * forces.by_omega.row(c).transpose();
  }
  for (const CoupledForces::Tangent& tangent : forces.tangents) {
    const MatrixXd outer = across_.col(tangent.of) * across_.col(tangent.by).transpose();
    for (Index c = 0; c < tangent.matrix.rows(); ++c)
      for (Index d = 0; d < tangent.matrix.cols(); ++d)
        if (place(c) >= 0 && place(d) >= 0)
          equations.by_unknowns.block(place(c), place(d), n, n) += tangent.matrix(c, d) * outer;
  }
}

double FreeMotion::left_out(const VectorXd& unknowns, double omega) const {
  const MatrixXd course = deflections(unknowns);
  MatrixXd padded = MatrixXd::Zero(numerics::coefficient_count(3 * harmonics_), course.cols());
  padded.topRows(course.rows()) = course;
  const MatrixXd forces = wider_.forces(padded, omega);
  if (!forces.allFinite()) return foundation::infinity;  // a loop that does not close
  const VectorXd sizes = sizes_.largest_of_kind(course.cwiseAbs().colwise().maxCoeff().transpose());
  double sum = 0;
  for (Index k = harmonics_ + 1; k <= 3 * harmonics_; ++k) {
    const double frequency = static_cast<double>(k) * omega;
    const MatrixXd right = across_ * forces.middleRows(2 * k - 1, 2).transpose();
    if (right.isZero(0)) continue;
    sum += (across_.transpose() * numerics::PivotedLu<double>(K_ - frequency * frequency * A_).solve(right))
               .rowwise()
               .norm()
               .cwiseQuotient(sizes)
               .maxCoeff();
  }
  return sum;
}

}  // namespace trivet::nonlinear
