// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/balance/harmonic_balance.h"

#include <cassert>
#include <cmath>
#include <complex>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/fourier_products.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

DeflectionScales sizes_of(const CondensedMachine& machine, const std::vector<Deflection>& deflections) {
  const MatrixXd& spread = machine.basis().spread;
  return {deflections, spread.transpose() * machine.static_receptance() * spread};
}

/// Forces on all deflections as those on the independent ones, by virtual work.
CoupledForces on_independent(CoupledForces all, const DeflectionBasis& basis) {
  if (basis.has_all()) return all;
  const MatrixXd& spread = basis.spread;
  CoupledForces found{all.force * spread.transpose(), all.by_omega * spread.transpose(), {}};
  const Index r = basis.size(), C = all.force.rows();
  std::vector<MatrixXd> sums(static_cast<std::size_t>(r * r));
  for (const CoupledForces::Tangent& tangent : all.tangents)
    for (Index by = 0; by < r; ++by)
      for (Index of = 0; of < r; ++of) {
        const double share = spread(of, tangent.of) * spread(by, tangent.by);
        if (share == 0) continue;
        MatrixXd& sum = sums[static_cast<std::size_t>(of * r + by)];
        if (sum.size() == 0) sum.setZero(C, C);
        sum += share * tangent.matrix;
      }
  for (Index of = 0; of < r; ++of)
    for (Index by = 0; by < r; ++by)
      if (MatrixXd& sum = sums[static_cast<std::size_t>(of * r + by)]; sum.size() > 0)
        found.tangents.push_back({of, by, std::move(sum)});
  return found;
}

}  // namespace

HarmonicBalance::HarmonicBalance(const CondensedMachine& machine, const std::vector<Deflection>& deflections,
                                 Index harmonics)
    : machine_(machine),
      harmonics_(harmonics),
      laws_(deflections, sizes_of(machine, deflections), harmonics, harmonics),
      wider_(deflections, laws_.sizes(), 3 * harmonics, harmonics) {}

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
    assert(k >= 1 && k <= harmonics_ && "the excitation is within the harmonics");
    const Eigen::VectorXcd motion =
        driving.factor * machine_.linear_motion(e, static_cast<double>(k) * driving.omega).motion;
    for (Index j = 0; j < motion.size(); ++j) {
      unknowns(j * coefficients() + 2 * k - 1) = motion(j).real();
      unknowns(j * coefficients() + 2 * k) = -motion(j).imag();
    }
  }
  return unknowns;
}

namespace {

/// Receptances at the harmonics of a frequency, and their derivatives by it.
struct ReceptancesAndSlopes {
  numerics::HarmonicReceptance receptances, slopes;
};

ReceptancesAndSlopes receptances_at(const CondensedMachine& machine, Index harmonics, double omega) {
  const Index C = numerics::coefficient_count(harmonics), entries = machine.size() * machine.size();
  ReceptancesAndSlopes found{{MatrixXd(C, entries), MatrixXd(C, entries)},
                             {MatrixXd(C, entries), MatrixXd(C, entries)}};
  found.receptances.on_own.row(0) = machine.static_receptance().reshaped().transpose();
  found.receptances.on_other.row(0).setZero();
  found.slopes.on_own.row(0).setZero();
  found.slopes.on_other.row(0).setZero();
  Receptance linear;
  for (Index k = 1; k <= harmonics; ++k) {
    machine.set_receptance(static_cast<double>(k) * omega, linear);
    const auto set = [&](const Eigen::MatrixXcd& values, double factor, numerics::HarmonicReceptance& of) {
      for (Index entry = 0; entry < entries; ++entry) {
        const std::complex<double> value = factor * values.data()[entry];
        of.on_own(2 * k - 1, entry) = of.on_own(2 * k, entry) = value.real();
        of.on_other(2 * k - 1, entry) = value.imag();
        of.on_other(2 * k, entry) = -value.imag();
      }
    };
    set(linear.receptance, 1, found.receptances);
    set(linear.slope, static_cast<double>(k), found.slopes);
  }
  return found;
}

}  // namespace

void HarmonicBalance::evaluate(const VectorXd& unknowns, const Driving& driving, Parameter parameter,
                               numerics::Equations& equations) const {
  const double omega = driving.omega;
  const Index C = coefficients(), m = machine_.size();
  assert(unknowns.size() == C * m);
  const bool with_derivatives = !equations.value_only;
  equations.value = unknowns;
  CoupledForces of_deflections;
  if (with_derivatives) {
    equations.by_unknowns.setZero(size(), size());  // setIdentity would test every entry
    equations.by_unknowns.diagonal().setOnes();
    equations.by_parameter.setZero(size());
    of_deflections = laws_.at(motion(unknowns), omega);
  } else {
    of_deflections.force = laws_.forces(motion(unknowns), omega);
    of_deflections.by_omega = MatrixXd::Zero(of_deflections.force.rows(), of_deflections.force.cols());
  }
  remove_round_off_of_means(of_deflections.force);
  const CoupledForces forces = on_independent(std::move(of_deflections), machine_.basis());
  const auto [receptances, slopes] = receptances_at(machine_, harmonics_, omega);
  for (Index j = 0; j < m; ++j) {
    numerics::add_responses(receptances, j * m, m, forces.force.col(j), equations.value);
    if (!with_derivatives) continue;
    numerics::add_responses(slopes, j * m, m, forces.force.col(j), equations.by_parameter);
    numerics::add_responses(receptances, j * m, m, forces.by_omega.col(j), equations.by_parameter);
  }
  for (const CoupledForces::Tangent& tangent : forces.tangents)
    if (!tangent.matrix.isZero(0))  // else a stop that the motion does not touch
      numerics::add_responses(receptances, tangent.of * m, m, tangent.matrix,
                              equations.by_unknowns.middleCols(tangent.by * C, C));
  if (with_derivatives && parameter == Parameter::load_factor) equations.by_parameter.setZero();
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
      if (!with_derivatives) continue;
      equations.by_parameter(i * C + 2 * k - 1) -= slope.real();
      equations.by_parameter(i * C + 2 * k) += slope.imag();
    }
  }
}

MatrixXd HarmonicBalance::motion(const VectorXd& unknowns) const {
  const auto independent = unknowns.reshaped(coefficients(), machine_.size());
  if (machine_.basis().has_all()) return independent;
  return independent * machine_.basis().spread;
}

VectorXd HarmonicBalance::unknowns_of(const MatrixXd& motion) const {
  return motion(Eigen::all, machine_.basis().independent).reshaped();
}

namespace {

VectorXd largest_in_columns(const Eigen::Ref<const MatrixXd>& motion) {
  return motion.cwiseAbs().colwise().maxCoeff().transpose();
}

/// 1/sizes, or 0 of a kind that cannot move.
VectorXd inverse(const VectorXd& sizes) {
  return sizes.unaryExpr([](double size) { return size > 0 ? 1 / size : 0; });
}

}  // namespace

VectorXd HarmonicBalance::of_independent(const VectorXd& amplitudes) const {
  return laws_.sizes().largest_of_kind(amplitudes)(machine_.basis().independent);
}

VectorXd HarmonicBalance::largest(const VectorXd& unknowns) const {
  return of_independent(largest_in_columns(motion(unknowns)));
}

VectorXd HarmonicBalance::largest_means(const VectorXd& unknowns) const {
  return of_independent(largest_in_columns(motion(unknowns).topRows<1>()));
}

VectorXd HarmonicBalance::largest_harmonics(const VectorXd& unknowns) const {
  return of_independent(largest_in_columns(motion(unknowns).bottomRows(coefficients() - 1)));
}

bool HarmonicBalance::are_same(const VectorXd& one, const VectorXd& other, double share) const {
  const MatrixXd first = motion(one), second = motion(other);
  const VectorXd sizes = laws_.sizes().largest_of_kind(largest_in_columns(first).cwiseMax(largest_in_columns(second)));
  const auto scaled = [&](const MatrixXd& motion) { return (motion * inverse(sizes).asDiagonal()).norm(); };
  return scaled(first - second) <= share * std::max(scaled(first), scaled(second));
}

MatrixXd HarmonicBalance::forces(const VectorXd& unknowns, double omega) const {
  MatrixXd found = laws_.forces(motion(unknowns), omega);
  remove_round_off_of_means(found);
  return found;
}

double HarmonicBalance::left_out(const VectorXd& unknowns, double omega) const {
  const MatrixXd course = motion(unknowns);
  MatrixXd padded = MatrixXd::Zero(numerics::coefficient_count(3 * harmonics_), course.cols());
  padded.topRows(coefficients()) = course;
  const MatrixXd forces = wider_.forces(padded, omega);
  if (!forces.allFinite()) return foundation::infinity;  // a loop that does not close
  return added(forces, harmonics_, unknowns, omega);
}

/// Largest shares of the deflections that the forces of the harmonics above one cause, added up.
double HarmonicBalance::added(const MatrixXd& of_all, Index above, const VectorXd& unknowns, double omega) const {
  const MatrixXd& spread = machine_.basis().spread;
  const VectorXd per_size = inverse(laws_.sizes().largest_of_kind(largest_in_columns(motion(unknowns))));
  const MatrixXd forces = of_all * spread.transpose();
  double sum = 0;
  Eigen::VectorXcd force(forces.cols());
  Eigen::MatrixXcd receptance;
  for (Index k = above + 1; 2 * k < forces.rows(); ++k) {
    for (Index j = 0; j < forces.cols(); ++j) force(j) = {forces(2 * k - 1, j), -forces(2 * k, j)};
    machine_.set_receptance(static_cast<double>(k) * omega, receptance);
    const Eigen::VectorXcd added = spread.transpose() * (receptance * force);
    sum += added.cwiseAbs().cwiseProduct(per_size).maxCoeff();
  }
  return sum;
}

double HarmonicBalance::held_share(const VectorXd& unknowns, double omega) const {
  const double known = machine_.known_to() / omega;
  if (!(known < static_cast<double>(harmonics_))) return 0;
  return added(forces(unknowns, omega), static_cast<Index>(known), unknowns, omega);
}

}  // namespace trivet::nonlinear
