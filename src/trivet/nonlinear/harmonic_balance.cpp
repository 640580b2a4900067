// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/harmonic_balance.h"

#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

HarmonicBalance::HarmonicBalance(const CondensedMachine& machine, const std::vector<Deflection>& deflections,
                                 Index harmonics)
    : machine_(machine),
      harmonics_(harmonics),
      sizes_(deflections, machine.static_receptance()),
      laws_(deflections, harmonics, harmonics),
      wider_(deflections, 3 * harmonics, harmonics) {}

namespace {

/// Means of forces that are round-off of their harmonics are zero. Where hardly anything brings a mean back, as of
/// fluid that circulates within the play of a decoupler, round-off would decide on it.
void remove_round_off_of_means(MatrixXd& force) {
  constexpr double round_off = 1e-14;
  for (Index j = 0; j < force.cols(); ++j)
    if (std::abs(force(0, j)) <= round_off * force.col(j).tail(force.rows() - 1).lpNorm<Eigen::Infinity>())
      force(0, j) = 0;
}

}  // namespace

Index HarmonicBalance::coefficients() const { return numerics::coefficient_count(harmonics_); }

VectorXd HarmonicBalance::linear_motion(const Driving& driving) const {
  VectorXd unknowns = VectorXd::Zero(size());
  for (std::size_t e = 0; e < machine_.excited().size(); ++e) {
    const Index k = machine_.excited()[e];
    const Eigen::VectorXcd motion =
        driving.factor * machine_.linear_motion(e, static_cast<double>(k) * driving.omega).motion;
    for (Index j = 0; j < motion.size(); ++j) {
      unknowns(j * coefficients() + 2 * k - 1) = motion(j).real();
      unknowns(j * coefficients() + 2 * k) = -motion(j).imag();
    }
  }
  return unknowns;
}

void HarmonicBalance::evaluate(const VectorXd& unknowns, const Driving& driving, Parameter parameter,
                               numerics::Equations& equations) const {
  const double omega = driving.omega;
  const Index C = coefficients(), m = machine_.size();
  equations.value = unknowns;
  equations.by_unknowns.setZero(size(), size());  // setIdentity would test every entry
  equations.by_unknowns.diagonal().setOnes();
  equations.by_parameter.setZero(size());
  CoupledForces forces = laws_.at(unknowns.reshaped(C, m), omega);
  remove_round_off_of_means(forces.force);
  // Coefficients a, b of a harmonic are the amplitude a − i b: the receptance g_r + i g_i turns them into
  // g_r a + g_i b and g_r b − g_i a. Coefficients × entries of the receptance:
  MatrixXd direct(C, m * m), crossed(C, m * m), direct_slope(C, m * m), crossed_slope(C, m * m);
  direct.row(0) = machine_.static_receptance().reshaped().transpose();
  crossed.row(0).setZero();
  direct_slope.row(0).setZero();
  crossed_slope.row(0).setZero();
  Receptance linear;
  for (Index k = 1; k <= harmonics_; ++k) {
    machine_.set_receptance(static_cast<double>(k) * omega, linear);
    const auto set = [&](const Eigen::MatrixXcd& entries, double factor, MatrixXd& on_own, MatrixXd& on_other) {
      const MatrixXd real = factor * entries.real(), imaginary = factor * entries.imag();
      on_own.row(2 * k - 1) = on_own.row(2 * k) = real.reshaped().transpose();
      on_other.row(2 * k - 1) = imaginary.reshaped().transpose();
      on_other.row(2 * k) = -on_other.row(2 * k - 1);
    };
    set(linear.receptance, 1, direct, crossed);
    set(linear.slope, static_cast<double>(k), direct_slope, crossed_slope);
  }
  VectorXd exchanged = VectorXd::Zero(C);  // sines and cosines
  const auto exchange = [&](const auto& course) {
    for (Index k = 1; k <= harmonics_; ++k) {
      exchanged(2 * k - 1) = course(2 * k);
      exchanged(2 * k) = course(2 * k - 1);
    }
  };
  const auto add = [&](const MatrixXd& on_own, const MatrixXd& on_other, Index entry, const auto& course, auto&& to) {
    to += on_own.col(entry).cwiseProduct(course) + on_other.col(entry).cwiseProduct(exchanged);
  };
  for (Index j = 0; j < m; ++j) {
    exchange(forces.force.col(j));
    for (Index i = 0; i < m; ++i) {
      add(direct, crossed, j * m + i, forces.force.col(j), equations.value.segment(i * C, C));
      add(direct_slope, crossed_slope, j * m + i, forces.force.col(j), equations.by_parameter.segment(i * C, C));
    }
    exchange(forces.by_omega.col(j));
    for (Index i = 0; i < m; ++i)
      add(direct, crossed, j * m + i, forces.by_omega.col(j), equations.by_parameter.segment(i * C, C));
  }
  for (const CoupledForces::Tangent& tangent : forces.tangents)
    for (Index c = 0; c < C; ++c) {
      exchange(tangent.matrix.col(c));
      for (Index i = 0; i < m; ++i)
        add(direct, crossed, tangent.of * m + i, tangent.matrix.col(c),
            equations.by_unknowns.col(tangent.by * C + c).segment(i * C, C));
    }
  if (parameter == Parameter::load_factor) equations.by_parameter.setZero();
  for (std::size_t e = 0; e < machine_.excited().size(); ++e) {
    const Index k = machine_.excited()[e];
    const auto order = static_cast<double>(k);
    const LinearMotion motion = machine_.linear_motion(e, order * omega);
    for (Index i = 0; i < m; ++i) {
      const std::complex<double> value = driving.factor * motion.motion(i),
                                 slope = parameter == Parameter::load_factor ? motion.motion(i)
                                                                             : order * driving.factor * motion.slope(i);
      equations.value(i * C + 2 * k - 1) -= value.real();
      equations.value(i * C + 2 * k) += value.imag();
      equations.by_parameter(i * C + 2 * k - 1) -= slope.real();
      equations.by_parameter(i * C + 2 * k) += slope.imag();
    }
  }
}

VectorXd HarmonicBalance::largest(const VectorXd& unknowns) const {
  return unknowns.reshaped(coefficients(), machine_.size()).cwiseAbs().colwise().maxCoeff().transpose();
}

VectorXd HarmonicBalance::largest_harmonics(const VectorXd& unknowns) const {
  return unknowns.reshaped(coefficients(), machine_.size())
      .bottomRows(coefficients() - 1)
      .cwiseAbs()
      .colwise()
      .maxCoeff()
      .transpose();
}

bool HarmonicBalance::are_same(const VectorXd& one, const VectorXd& other, double share) const {
  const VectorXd sizes = sizes_.largest_of_kind(largest(one).cwiseMax(largest(other)));
  const auto scaled = [&](const VectorXd& motion) {
    return (motion.reshaped(coefficients(), machine_.size()) * sizes.cwiseInverse().asDiagonal()).norm();
  };
  return scaled(one - other) <= share * std::max(scaled(one), scaled(other));
}

MatrixXd HarmonicBalance::forces(const VectorXd& unknowns, double omega) const {
  MatrixXd found = laws_.forces(unknowns.reshaped(coefficients(), machine_.size()), omega);
  remove_round_off_of_means(found);
  return found;
}

double HarmonicBalance::left_out(const VectorXd& unknowns, double omega) const {
  MatrixXd padded = MatrixXd::Zero(numerics::coefficient_count(3 * harmonics_), machine_.size());
  padded.topRows(coefficients()) = unknowns.reshaped(coefficients(), machine_.size());
  const MatrixXd forces = wider_.forces(padded, omega);
  if (!forces.allFinite()) return foundation::infinity;  // a loop that does not close
  return added(forces, harmonics_, unknowns, omega);
}

/// Largest shares of the deflections that the forces of the harmonics above one cause, added up.
double HarmonicBalance::added(const MatrixXd& forces, Index above, const VectorXd& unknowns, double omega) const {
  const VectorXd sizes = sizes_.largest_of_kind(largest(unknowns));
  double sum = 0;
  Eigen::VectorXcd force(forces.cols());
  Eigen::MatrixXcd receptance;
  for (Index k = above + 1; 2 * k < forces.rows(); ++k) {
    for (Index j = 0; j < forces.cols(); ++j) force(j) = {forces(2 * k - 1, j), -forces(2 * k, j)};
    machine_.set_receptance(static_cast<double>(k) * omega, receptance);
    sum += (receptance * force).cwiseAbs().cwiseQuotient(sizes).maxCoeff();
  }
  return sum;
}

double HarmonicBalance::held_share(const VectorXd& unknowns, double omega) const {
  const double known = machine_.known_to() / omega;
  if (!(known < static_cast<double>(harmonics_))) return 0;
  return added(forces(unknowns, omega), static_cast<Index>(known), unknowns, omega);
}

}  // namespace trivet::nonlinear
