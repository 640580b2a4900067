// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/law.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {

namespace {

using Matrix6x12 = Eigen::Matrix<double, 6, 12>;

/// Motion of the K side relative to the N side, both rigidly extended to the point at the fraction `centre` of the arm.
Matrix6x12 relative_motion(const Eigen::Vector3d& arm, double centre) {
  Matrix6x12 e;
  e << -spatial::rigid_motion(centre * arm), spatial::rigid_motion((centre - 1) * arm);
  return e;
}

}  // namespace

Matrix12 stiffness(const Law& law) {
  Matrix12 sum = law.scale * law.nominal_stiffness;
  if (law.nonlinear) sum += law.nonlinear->tangent;
  if (law.inner) sum += stiffness_of_inner_parts(law, 0).real();
  return sum;
}

namespace {

Matrix12 linear_damping(const Law& law) {
  if (const auto* proportional = std::get_if<ProportionalDamping>(&law.damping))
    return proportional->factor * (proportional->of_nominal ? 1.0 : law.scale) * law.nominal_stiffness;
  if (const auto* given = std::get_if<DampingMatrix>(&law.damping)) return given->matrix;
  if (const auto* relaxing = std::get_if<Viscoelastic>(&law.damping))
    if (const auto* viscous = std::get_if<KelvinVoigt>(relaxing))
      return viscous->time * law.scale * law.nominal_stiffness;
  return Matrix12::Zero();
}

}  // namespace

Matrix12 viscous_damping(const Law& law) {
  const Matrix12 linear = linear_damping(law);
  return law.nonlinear ? Matrix12(linear + law.nonlinear->damping) : linear;
}

double loss_factor(const Law& law) {
  const auto* loss = std::get_if<LossFactor>(&law.damping);
  return loss ? loss->value : 0;
}

Eigen::Matrix<double, 3, 12> difference_rows(const Eigen::Matrix3d& n_from_k) {
  Eigen::Matrix<double, 3, 12> rows = Eigen::Matrix<double, 3, 12>::Zero();
  rows.leftCols<3>() = -n_from_k.transpose();
  rows.middleCols<3>(6).setIdentity();
  return rows;
}

Matrix12 from_moved_end(const Matrix6& moved_end, const Eigen::Vector3d& arm) {
  const Matrix6x12 e = relative_motion(arm, 1);
  return e.transpose() * moved_end * e;
}

Matrix12 constants_at_point(const Vector6& constants, const Eigen::Vector3d& arm, double centre) {
  const Matrix6x12 e = relative_motion(arm, centre);
  return e.transpose() * constants.asDiagonal() * e;
}

Matrix12 constant_along_line(double constant, const Eigen::Vector3d& axis, const Eigen::Vector3d& arm, double centre) {
  const Eigen::Matrix<double, 1, 12> stretch = axis.transpose() * relative_motion(arm, centre).topRows<3>();
  return constant * stretch.transpose() * stretch;
}

Eigen::Matrix<double, 1, 12> deflection_row(int axis, const Eigen::Vector3d& arm, const Eigen::Matrix3d& n_from_k,
                                            double centre) {
  Eigen::Matrix<double, 1, 12> row = relative_motion(arm, centre).row(axis);
  row.head<6>() = (row.head<6>() * spatial::both_blocks(n_from_k).transpose()).eval();
  return row;
}

Matrix12 in_end_axes(const Matrix12& in_axes_of_k, const Eigen::Matrix3d& n_from_k) {
  Matrix12 turn = Matrix12::Identity();
  turn.topLeftCorner<6, 6>() = spatial::both_blocks(n_from_k);
  return turn * in_axes_of_k * turn.transpose();
}

Eigen::Matrix<double, 12, 6> rigid_motions(const Eigen::Vector3d& arm, const Eigen::Matrix3d& n_from_k) {
  Eigen::Matrix<double, 12, 6> g;
  g << spatial::both_blocks(n_from_k) * spatial::rigid_motion(-arm), Matrix6::Identity();
  return g;
}

namespace {

using Complex = std::complex<double>;

/// A fractional law is approximated over this many decades to either side of its relaxation.
constexpr double imitated_decades = 4;

/// K = L S Lᵀ with rank(K) columns, S = ±1: strains that store energy in an element with stiffness K.
struct Strains {
  Eigen::MatrixXd shape;
  Eigen::VectorXd sign;
};

Strains strains(const Eigen::MatrixXd& stiffness) {
  constexpr double round_off = 1e-13;
  const Eigen::VectorXd scale =
      stiffness.diagonal().unaryExpr([](double k) { return k == 0 ? 1.0 : std::sqrt(std::abs(k)); });
  const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * stiffness * scale.cwiseInverse().asDiagonal();
  const numerics::SymmetricEigen<Eigen::MatrixXd> eigen =
      numerics::symmetric_eigen(Eigen::MatrixXd(0.5 * (scaled + scaled.transpose())));
  const double largest = eigen.values.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < stiffness.rows(); ++i)
    if (std::abs(eigen.values(i)) > round_off * largest) kept.push_back(i);
  const Eigen::VectorXd values = eigen.values(kept);
  const Eigen::MatrixXd vectors = eigen.vectors(Eigen::all, kept);
  return {scale.asDiagonal() * vectors * values.cwiseAbs().cwiseSqrt().asDiagonal(), values.cwiseSign()};
}

/// Adds one Maxwell branch with `ratio` times the stiffness L S Lᵀ and the relaxation time `time`: g(z − Lᵀd) + gτ ż =
/// 0.
void add_branch(const Strains& strain, double ratio, double time, Matrices& m) {
  const Eigen::Index old = m.stiffness.rows(), rank = strain.sign.size(), first = strain.shape.rows();
  for (Eigen::MatrixXd* matrix : {&m.stiffness, &m.damping, &m.mass}) {
    matrix->conservativeResize(old + rank, old + rank);
    matrix->rightCols(rank).setZero();
    matrix->bottomRows(rank).setZero();
  }
  const Eigen::MatrixXd signed_shape = ratio * strain.shape * strain.sign.asDiagonal();
  m.stiffness.topLeftCorner(first, first) += signed_shape * strain.shape.transpose();
  m.stiffness.block(0, old, first, rank) = -signed_shape;
  m.stiffness.block(old, 0, rank, first) = -signed_shape.transpose();
  m.stiffness.bottomRightCorner(rank, rank) = ratio * Eigen::MatrixXd(strain.sign.asDiagonal());
  m.damping.bottomRightCorner(rank, rank) = ratio * time * Eigen::MatrixXd(strain.sign.asDiagonal());
}

/// Stiffness, damping and mass of the inner parts with the tangents of their laws.
InnerParts tangents_of_inner_parts(const Law& law) {
  InnerParts parts = *law.inner;
  if (!law.nonlinear || law.nonlinear->inner_tangent.size() == 0) return parts;
  parts.stiffness.diagonal().tail(parts.count()) += law.nonlinear->inner_tangent;
  parts.damping.diagonal().tail(parts.count()) += law.nonlinear->inner_damping;
  return parts;
}

/// Appends the inner parts, with the tangents of their laws.
void add_inner_parts(const Law& law, Matrices& m) {
  const InnerParts parts = tangents_of_inner_parts(law);
  const Eigen::Index old = m.stiffness.rows(), n = parts.count();
  std::vector<Eigen::Index> places;
  for (Eigen::Index i = 0; i < 12; ++i) places.push_back(i);
  for (Eigen::Index i = 0; i < n; ++i) places.push_back(old + i);
  const auto add = [&](const Eigen::MatrixXd& part, Eigen::MatrixXd& whole) {
    whole.conservativeResize(old + n, old + n);
    whole.rightCols(n).setZero();
    whole.bottomRows(n).setZero();
    whole(places, places) += part;
  };
  add(parts.stiffness, m.stiffness);
  add(parts.damping, m.damping);
  add(parts.mass, m.mass);
  add(Eigen::MatrixXd::Zero(12 + n, 12 + n), m.loss);
}

RationalForm rational(const Viscoelastic& law) {
  if (const auto* fractional = std::get_if<FractionalZener>(&law)) {
    const double reach = std::pow(10.0, imitated_decades);
    return rational_form(law, 1 / (fractional->time * reach), reach / fractional->time);
  }
  return rational_form(law, 1, 2);  // exact on any band
}

/// Complex factor on all moduli of the element: scale, loss factor, proportional damping and relaxation together.
Complex relative_stiffness(const Law& law, Complex omega) {
  const Complex i(0, 1);
  Complex factor = law.scale;
  if (const auto* relaxing = std::get_if<Viscoelastic>(&law.damping)) factor *= relative_modulus(*relaxing, omega);
  if (const auto* proportional = std::get_if<ProportionalDamping>(&law.damping))
    factor += i * omega * proportional->factor * (proportional->of_nominal ? 1.0 : law.scale);
  return factor * Complex(1, loss_factor(law));
}

/// −ω²M − ω⁴ Σ p pᵀ/(μω_k² − ω²): contribution of the element's own mass if every modulus is μ times the nominal one.
Matrix12c inertia_terms(const Inertia& inertia, Complex modulus, Complex omega) {
  const Complex square = omega * omega;
  Matrix12c terms = -square * inertia.mass.cast<Complex>();
  for (Eigen::Index k = 0; k < inertia.angular_frequencies.size(); ++k) {
    const double own = inertia.angular_frequencies(k);
    const Vector12 p = inertia.coupling.col(k);
    terms -= (square * square / (modulus * own * own - square)) * (p * p.transpose()).cast<Complex>();
  }
  return terms;
}

}  // namespace

bool is_frequency_dependent(const Law& law) {
  const auto* relaxing = std::get_if<Viscoelastic>(&law.damping);
  return law.frequency_dependence || (relaxing && std::holds_alternative<FractionalZener>(*relaxing));
}

Matrices matrices(const Law& law) {
  const Eigen::Index modes = law.inertia ? law.inertia->angular_frequencies.size() : 0;
  Matrices m;
  m.stiffness = m.damping = m.mass = Eigen::MatrixXd::Zero(12 + modes, 12 + modes);
  m.stiffness.topLeftCorner<12, 12>() = law.scale * law.nominal_stiffness;
  m.loss_factor = loss_factor(law);
  if (law.inertia) {
    m.stiffness.diagonal().tail(modes) = law.scale * law.inertia->angular_frequencies.cwiseAbs2();
    m.mass.topLeftCorner<12, 12>() = law.inertia->mass;
    m.mass.topRightCorner(12, modes) = law.inertia->coupling;
    m.mass.bottomLeftCorner(modes, 12) = law.inertia->coupling.transpose();
    m.mass.bottomRightCorner(modes, modes).setIdentity();
  }
  if (const auto* proportional = std::get_if<ProportionalDamping>(&law.damping))
    m.damping = proportional->factor * (proportional->of_nominal ? 1 / law.scale : 1.0) * m.stiffness;
  if (const auto* given = std::get_if<DampingMatrix>(&law.damping)) m.damping.topLeftCorner<12, 12>() = given->matrix;
  if (const auto* relaxing = std::get_if<Viscoelastic>(&law.damping)) {
    const RationalForm form = rational(*relaxing);
    const Eigen::MatrixXd relaxed = m.stiffness;
    m.damping = form.viscous_time * relaxed;
    const Strains strain = strains(relaxed);
    for (std::size_t i = 0; i < form.ratios.size(); ++i)
      if (form.ratios[i] > 0) add_branch(strain, form.ratios[i], form.times[i], m);
  }
  m.loss = m.loss_factor * m.stiffness;
  if (law.nonlinear) {
    m.stiffness.topLeftCorner<12, 12>() += law.nonlinear->tangent;
    m.damping.topLeftCorner<12, 12>() += law.nonlinear->damping;
  }
  if (law.inner) add_inner_parts(law, m);
  return m;
}

Matrix12c stiffness_of_inner_parts(const Law& law, Complex omega) {
  const InnerParts parts = tangents_of_inner_parts(law);
  const Eigen::MatrixXcd z = parts.stiffness + Complex(0, 1) * omega * parts.damping - omega * omega * parts.mass;
  const Eigen::Index n = parts.count();
  const Eigen::MatrixXcd inner = z.bottomRightCorner(n, n), coupling = z.bottomLeftCorner(n, 12);
  return z.topLeftCorner<12, 12>() - coupling.transpose() * numerics::PivotedLu<Complex>(inner).solve(coupling);
}

Matrix12c dynamic_stiffness(const Law& law, Complex omega, double near) {
  const Complex modulus = relative_stiffness(law, omega);
  Matrix12c result;
  if (law.frequency_dependence) {
    const FrequencyDependence& given = *law.frequency_dependence;
    const double slack = std::isfinite(given.to) ? 1e-9 * given.to : 0;
    if (near < given.from - slack || near > given.to + slack)
      throw foundation::NotComputable(fmt::format(
          "its table has no stiffness at {:.6g} Hz, only from {:.6g} to {:.6g} Hz; choose a band inside, or extend the "
          "table",
          near / (2 * std::numbers::pi), given.from / (2 * std::numbers::pi), given.to / (2 * std::numbers::pi)));
    result = given.elastic ? Matrix12c(modulus * given.stiffness(omega / std::sqrt(modulus), near))
                           : Matrix12c(law.scale * given.stiffness(omega, near));
  } else {
    result = modulus * law.nominal_stiffness.cast<Complex>();
    if (law.inertia) result += inertia_terms(*law.inertia, modulus, omega);
  }
  if (const auto* given = std::get_if<DampingMatrix>(&law.damping))
    result += Complex(0, 1) * omega * given->matrix.cast<Complex>();
  if (law.nonlinear)
    result += law.nonlinear->tangent.cast<Complex>() + Complex(0, 1) * omega * law.nonlinear->damping.cast<Complex>();
  if (law.inner) result += stiffness_of_inner_parts(law, omega);
  return result;
}

}  // namespace trivet::elements
