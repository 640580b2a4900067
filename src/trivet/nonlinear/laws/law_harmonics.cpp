// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_harmonics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/nonlinear/laws/bristle_loop.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/fourier_products.h"
#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::two_pi;

/// Samples must not fold the highest harmonics of the force onto those wanted, nor those of the tangent onto twice as
/// many. A polynomial of degree d has d times the harmonics of the motion, its tangent d − 1 times as many; others are
/// sampled by powers of two, six times as often as the highest harmonic wanted.
Index sample_count(std::optional<int> degree, Index of_motion, Index wanted) {
  constexpr Index fewest = 16;
  if (degree)
    return std::max(fewest, std::max(*degree * of_motion + wanted, (*degree - 1) * of_motion + 2 * wanted) + 1);
  Index count = fewest;
  while (count < 6 * wanted + 2) count *= 2;
  return count;
}

/// Phases from corner to corner; the whole period without any.
std::vector<std::pair<double, double>> pieces(const LawOverPeriod& course) {
  const std::vector<double>& corners = course.corners();
  if (corners.empty()) return {{0, two_pi}};
  std::vector<std::pair<double, double>> found;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) found.emplace_back(corners[i], corners[i + 1]);
  found.emplace_back(corners.back(), corners.front() + two_pi);
  return found;
}

}  // namespace

LawHarmonics::LawHarmonics(DeviationLaw law, Index harmonics, std::optional<Index> of_motion)
    : law_(std::move(law)), harmonics_(harmonics), of_motion_(of_motion.value_or(harmonics)) {
  const auto set_rows = [](Index count, Index of, Eigen::MatrixXd& rows) {
    rows.resize(count, numerics::coefficient_count(of));
    for (Index n = 0; n < count; ++n)
      rows.row(n) = numerics::fourier_row(of, two_pi * static_cast<double>(n) / static_cast<double>(count));
  };
  if (!law_.smooth().is_empty() || !law_.others().is_empty())
    set_rows(sample_count(law_.degree(), of_motion_, harmonics), 2 * harmonics, values_);
  if (!law_.kinks().empty() || !law_.rate_kinks().empty() || !law_.hysteretic().empty() || !law_.bristles().empty())
    set_rows(sample_count(std::nullopt, of_motion_, of_motion_), of_motion_, of_course_);
}

LawOverPeriod LawHarmonics::course(const VectorXd& deflection, double omega, double round_off) const {
  return {law_, deflection, of_motion_, omega, of_course_, round_off};
}

ForceHarmonics LawHarmonics::at(const VectorXd& deflection, double omega, double round_off) const {
  Spectra found = spectra(deflection, omega, round_off, true);
  ForceHarmonics result{std::move(found.force), numerics::product_matrix(found.by_deflection, harmonics_),
                        found.by_omega};
  if (found.by_memory.size() > 0) result.tangent += found.by_memory;
  if (law_.has_dampers()) {
    const Eigen::MatrixXd on_rate = numerics::product_matrix(found.by_rate, harmonics_);
    result.tangent += omega * numerics::on_motion(on_rate);
    result.by_omega += on_rate * numerics::phase_derivative(deflection);
  }
  return result;
}

LawHarmonics::TangentHarmonics LawHarmonics::tangents_at(const VectorXd& deflection, double omega,
                                                         double round_off) const {
  Spectra found = spectra(deflection, omega, round_off, true);
  return {std::move(found.by_deflection), std::move(found.by_rate)};
}

VectorXd LawHarmonics::force_at(const VectorXd& deflection, double omega, double round_off) const {
  return spectra(deflection, omega, round_off, false).force;
}

LawHarmonics::Spectra LawHarmonics::spectra(const VectorXd& deflection, double omega, double round_off,
                                            bool with_tangent) const {
  const Index twice = with_tangent ? numerics::coefficient_count(2 * harmonics_) : 0;
  assert(deflection.size() == numerics::coefficient_count(harmonics_));
  Spectra sum{with_tangent,
              VectorXd::Zero(deflection.size()),
              VectorXd::Zero(twice),
              VectorXd::Zero(law_.has_dampers() ? twice : 0),
              VectorXd::Zero(deflection.size()),
              {}};
  const LawOverPeriod along = course(deflection, omega, round_off);
  add_line(along, deflection, omega, sum);
  if (!law_.smooth().is_empty()) add_sampled(law_.smooth(), deflection, omega, sum);
  if (!law_.quadratic().is_empty()) add_quadratic(along, deflection, omega, sum);
  if (!law_.others().is_empty()) {
    if (along.corners().empty()) add_sampled(law_.others(), deflection, omega, sum);
    else add_between_corners(along, sum);
  }
  for (const HystereticLoop& loop : along.loops()) {
    add_loop(along, loop, sum);
    if (with_tangent) add_jumps(deflection, omega, loop, sum);
  }
  if (!along.bristles().empty()) add_bristles(along, deflection, omega, sum);
  if (!law_.of_amplitude().empty()) add_of_amplitude(along, deflection, sum);
  sum.force(0) /= 2;
  sum.by_omega(0) /= 2;
  if (sum.by_memory.size() > 0) sum.by_memory.row(0) /= 2;
  return sum;
}

void LawHarmonics::add_line(const LawOverPeriod& course, const VectorXd& deflection, double omega, Spectra& sum) const {
  DeviationLaw::Line line = law_.line();
  line.stiffness += course.resting_stiffness();
  sum.force += line.stiffness * deflection;
  if (law_.has_dampers()) sum.force += line.damping * omega * numerics::phase_derivative(deflection);
  sum.force(0) = 2 * (sum.force(0) + line.constant);
  if (!sum.with_tangent) return;
  sum.by_deflection(0) += 2 * line.stiffness;
  if (law_.has_dampers()) sum.by_rate(0) += 2 * line.damping;
}

void LawHarmonics::add_sampled(const DeviationLaw::Parts& parts, const VectorXd& deflection, double omega,
                               Spectra& sum) const {
  const Index count = deflection.size(), samples = values_.rows();
  const bool damped = law_.has_dampers();
  assert(samples > 2 * of_motion_ && "samples do not fold the motion itself");
  const VectorXd motion = deflection.head(numerics::coefficient_count(of_motion_)),
                 deflections = (values_.leftCols(motion.size()) * motion).array() + law_.state();
  const VectorXd rates = damped
      ? VectorXd(values_.leftCols(motion.size()) * (omega * numerics::phase_derivative(motion)))
      : VectorXd::Zero(samples);
  const elements::ForcesInMotion found = parts.at(deflections, rates);
  const double weight = 2.0 / static_cast<double>(samples);
  sum.force.noalias() += weight * values_.leftCols(count).transpose() * found.force;
  if (!sum.with_tangent) return;
  sum.by_deflection.noalias() += weight * values_.transpose() * found.by_deflection;
  if (damped) sum.by_rate.noalias() += weight * values_.transpose() * found.by_rate;
}

/// On each piece f = c + g x + d v + m x v + p v²/2, with constants that are functions of the phase over the whole
/// period: products of their spectra and those of x and v.
void LawHarmonics::add_quadratic(const LawOverPeriod& course, const VectorXd& deflection, double omega,
                                 Spectra& sum) const {
  const Index twice = 2 * harmonics_, thrice = 3 * harmonics_;
  const auto zero = [](Index harmonics) { return VectorXd::Zero(numerics::coefficient_count(harmonics)).eval(); };
  VectorXd constant = zero(harmonics_), stiffness = zero(twice), damping, mixed, by_rate_squared;
  const auto add = [&](double from, double to, double value, Index harmonics, VectorXd& spectrum) {
    if (value == 0) return;
    if (spectrum.size() == 0) spectrum = zero(harmonics);
    numerics::add_stretch(from, to, value, spectrum);
  };
  for (const auto& [from, to] : pieces(course)) {
    const double middle = (from + to) / 2, x = course.deflection_at(middle),
                 v = course.is_damped() ? course.rate_at(middle) : 0;
    const DeviationLaw::Force there = law_.quadratic().at(law_.state() + x, v);
    if (there.force == 0 && there.by_deviation == 0 && there.by_rate == 0) continue;  // an open gap
    const auto [m, p] = law_.quadratic().curvature(law_.state() + x, v);
    const double g = there.by_deviation - m * v, d = there.by_rate - m * x - p * v;
    numerics::add_stretch(from, to, there.force - g * x - d * v - m * x * v - p * v * v / 2, constant);
    numerics::add_stretch(from, to, g, stiffness);
    add(from, to, d, twice, damping);
    add(from, to, m, thrice, mixed);
    add(from, to, p, thrice, by_rate_squared);
  }
  VectorXd by_deflection = zero(twice), by_rate = zero(twice);  // their share of second degree
  const VectorXd rate = course.is_damped() ? VectorXd(omega * numerics::phase_derivative(deflection)) : VectorXd();
  if (mixed.size() > 0) {
    by_deflection += numerics::product(mixed, rate, twice);
    by_rate += numerics::product(mixed, deflection, twice);
  }
  if (by_rate_squared.size() > 0) by_rate += numerics::product(by_rate_squared, rate, twice);
  if (damping.size() == 0) damping = zero(twice);
  sum.force += constant + numerics::product(stiffness + by_deflection / 2, deflection, harmonics_);
  if (course.is_damped()) sum.force += numerics::product(damping + by_rate / 2, rate, harmonics_);
  if (!sum.with_tangent) return;
  sum.by_deflection += stiffness + by_deflection;
  if (law_.has_dampers()) sum.by_rate += damping + by_rate;
}

double LawHarmonics::longest_piece() const { return two_pi / static_cast<double>(2 * std::max<Index>(harmonics_, 2)); }

void LawHarmonics::add_between_corners(const LawOverPeriod& course, Spectra& sum) const {
  const Index count = sum.force.size(), reach = sum.with_tangent ? 2 * harmonics_ : harmonics_;
  Eigen::RowVectorXd row;
  for (const auto& [from, to] : pieces(course)) {
    const auto at = [&](const auto& place) {
      return law_.others().at(law_.state() + course.deflection_at(place),
                              course.is_damped() ? course.rate_at(place) : 0);
    };
    const DeviationLaw::Force there = at((from + to) / 2);
    if (there.force == 0 && there.by_deviation == 0 && there.by_rate == 0) continue;  // an open gap
    numerics::each_gauss_node(from, to, longest_piece(), [&](double phase, double length) {
      numerics::set_fourier_row(reach, phase, row);
      const DeviationLaw::Force found = at(row);
      const double weight = length / (two_pi / 2);
      sum.force += (weight * found.force) * row.head(count).transpose();
      if (!sum.with_tangent) return;
      sum.by_deflection += (weight * found.by_deviation) * row.transpose();
      if (law_.has_dampers()) sum.by_rate += (weight * found.by_rate) * row.transpose();
    });
  }
}

void LawHarmonics::add_loop(const LawOverPeriod& course, const HystereticLoop& loop, Spectra& sum) const {
  const Index count = sum.force.size(), reach = sum.with_tangent ? 2 * harmonics_ : harmonics_;
  if (sum.with_tangent && sum.by_memory.size() == 0) sum.by_memory = Eigen::MatrixXd::Zero(count, count);
  Eigen::RowVectorXd row;
  for (const HystereticLoop::Branch& branch : loop.branches()) {
    VectorXd by_travel = VectorXd::Zero(count), by_start = VectorXd::Zero(count);
    const auto add = [&](double phase, double length) {
      numerics::set_fourier_row(reach, phase, row);
      const elements::ForceOnTravel found = loop.at(branch, course.deflection_at(row));
      const double weight = length / (two_pi / 2);
      sum.force += (weight * found.force) * row.head(count).transpose();
      if (!sum.with_tangent) return;
      sum.by_deflection += (weight * found.by_travel) * row.transpose();
      by_travel += (weight * found.by_travel) * row.head(count).transpose();
      by_start += (weight * found.by_start) * row.head(count).transpose();
    };
    const double middle = branch.kink.value_or(branch.to);
    numerics::each_gauss_node(branch.from, middle, longest_piece(), add);
    if (branch.kink) numerics::each_gauss_node(middle, branch.to, longest_piece(), add);
    if (sum.with_tangent)
      sum.by_memory +=
          by_start * branch.force_slopes.transpose() - by_travel * numerics::fourier_row(harmonics_, branch.from);
  }
}

/// Where the force jumps by J at a phase, and that moves by dφ, the force is that before the jump for dφ longer.
void LawHarmonics::add_jumps(const VectorXd& deflection, double omega, const HystereticLoop& loop, Spectra& sum) const {
  for (const HystereticLoop::Jump& jump : loop.jumps(deflection)) {
    const HystereticLoop::Branch& branch = loop.branches()[jump.branch];
    assert(jump.branch < loop.branches().size());
    const Eigen::RowVectorXd here = numerics::fourier_row(harmonics_, jump.phase);
    Eigen::RowVectorXd moved = jump.by_deflection * (here - numerics::fourier_row(harmonics_, branch.from)) +
        jump.by_start * branch.force_slopes.transpose();
    for (Index k = 1; k <= harmonics_; ++k) {
      moved(2 * k - 1) -= jump.by_slope * static_cast<double>(k) * here(2 * k);
      moved(2 * k) += jump.by_slope * static_cast<double>(k) * here(2 * k - 1);
    }
    const VectorXd later = jump.force / (two_pi / 2) * here.transpose();
    sum.by_memory -= later * moved;
    if (jump.by_log_omega != 0) sum.by_omega -= jump.by_log_omega / omega * later;
  }
}

void LawHarmonics::add_bristles(const LawOverPeriod& course, const VectorXd& deflection, double omega,
                                Spectra& sum) const {
  for (const BristleLoop& loop : course.bristles()) {
    const BristleHarmonics found = bristle_harmonics(loop, deflection, omega, sum.with_tangent);
    sum.force += found.force;
    if (!sum.with_tangent) continue;
    if (sum.by_memory.size() == 0) sum.by_memory = Eigen::MatrixXd::Zero(deflection.size(), deflection.size());
    sum.by_memory += found.tangent;
    sum.by_omega += found.by_omega;
  }
}

/// Each harmonic times k' + i k'' at the amplitude of the whole motion; the mean times k'.
void LawHarmonics::add_of_amplitude(const LawOverPeriod& course, const VectorXd& deflection, Spectra& sum) const {
  const Index count = deflection.size();
  const elements::StiffnessOfAmplitude& there = course.of_amplitude();
  assert(course.ahead().size() == count && "a quarter of a period ahead are as many harmonics");
  VectorXd force = there.storage * deflection + there.loss * course.ahead();
  force(0) *= 2;
  sum.force += force;
  if (!sum.with_tangent) return;
  if (sum.by_memory.size() == 0) sum.by_memory = Eigen::MatrixXd::Zero(count, count);
  sum.by_memory.diagonal().array() += there.storage;
  sum.by_memory(0, 0) += there.storage;
  for (Index k = 1; k <= harmonics_; ++k) {
    sum.by_memory(2 * k - 1, 2 * k) += there.loss;
    sum.by_memory(2 * k, 2 * k - 1) -= there.loss;
  }
  if (!(course.amplitude() > 0)) return;
  VectorXd by_amplitude = there.storage_slope * deflection + there.loss_slope * course.ahead();
  by_amplitude(0) *= 2;
  Eigen::RowVectorXd amplitude_slopes = deflection.transpose() / course.amplitude();
  amplitude_slopes(0) = 0;
  sum.by_memory += by_amplitude * amplitude_slopes;
}

}  // namespace trivet::nonlinear
