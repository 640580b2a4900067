// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/law_harmonics.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/fourier_products.h"
#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::two_pi;

/// A quartic force of harmonics up to H has harmonics up to 4H, which samples must not fold onto those up to H.
Index sample_count(Index harmonics) {
  constexpr Index fewest = 16, per_harmonic = 6;
  Index count = fewest;
  while (count < per_harmonic * harmonics + 2) count *= 2;
  return count;
}

}  // namespace

LawHarmonics::LawHarmonics(LawAbout law, Index harmonics) : law_(std::move(law)), harmonics_(harmonics) {
  const Index samples = sample_count(harmonics);
  values_.resize(samples, numerics::coefficient_count(2 * harmonics));
  for (Index n = 0; n < samples; ++n)
    values_.row(n) =
        numerics::fourier_row(2 * harmonics, two_pi * static_cast<double>(n) / static_cast<double>(samples));
}

LawCourse LawHarmonics::course(const VectorXd& deflection, double omega) const {
  return {law_, deflection, omega, values_.leftCols(deflection.size())};
}

ForceHarmonics LawHarmonics::at(const VectorXd& deflection, double omega) const {
  Spectra found = spectra(deflection, omega, true);
  ForceHarmonics result{std::move(found.force), numerics::product_matrix(found.by_deflection, harmonics_),
                        VectorXd::Zero(deflection.size())};
  if (found.by_memory.size() > 0) result.tangent += found.by_memory;
  if (law_.has_dampers()) {
    const Eigen::MatrixXd on_rate = numerics::product_matrix(found.by_rate, harmonics_);
    result.tangent += omega * numerics::on_motion(on_rate);
    result.by_omega = on_rate * numerics::phase_derivative(deflection);
  }
  return result;
}

LawHarmonics::TangentHarmonics LawHarmonics::tangents_at(const VectorXd& deflection, double omega) const {
  Spectra found = spectra(deflection, omega, true);
  return {std::move(found.by_deflection), std::move(found.by_rate)};
}

VectorXd LawHarmonics::force_at(const VectorXd& deflection, double omega) const {
  return spectra(deflection, omega, false).force;
}

LawHarmonics::Spectra LawHarmonics::spectra(const VectorXd& deflection, double omega, bool with_tangent) const {
  const Index twice = with_tangent ? numerics::coefficient_count(2 * harmonics_) : 0;
  Spectra sum{with_tangent,
              VectorXd::Zero(deflection.size()),
              VectorXd::Zero(twice),
              VectorXd::Zero(law_.has_dampers() ? twice : 0),
              {}};
  const LawCourse along = course(deflection, omega);
  if (along.corners().empty()) add_sampled(deflection, omega, sum);
  else add_between_corners(along, sum);
  for (const HystereticLoop& loop : along.loops()) add_loop(along, loop, sum);
  sum.force(0) /= 2;
  if (sum.by_memory.size() > 0) sum.by_memory.row(0) /= 2;
  return sum;
}

void LawHarmonics::add_sampled(const VectorXd& deflection, double omega, Spectra& sum) const {
  const Index count = deflection.size(), samples = values_.rows();
  const bool damped = law_.has_dampers();
  const VectorXd course = values_.leftCols(count) * deflection;
  const VectorXd rate = damped ? VectorXd(values_.leftCols(count) * (omega * numerics::phase_derivative(deflection)))
                               : VectorXd::Zero(samples);
  VectorXd force(samples), by_deflection(samples), by_rate(samples);
  for (Index n = 0; n < samples; ++n) {
    const LawAbout::Force found = law_.without_memory(course(n), rate(n));
    force(n) = found.force;
    by_deflection(n) = found.by_deviation;
    by_rate(n) = found.by_rate;
  }
  const double weight = 2.0 / static_cast<double>(samples);
  sum.force.noalias() += weight * values_.leftCols(count).transpose() * force;
  if (!sum.with_tangent) return;
  sum.by_deflection.noalias() += weight * values_.transpose() * by_deflection;
  if (damped) sum.by_rate.noalias() += weight * values_.transpose() * by_rate;
}

double LawHarmonics::longest_piece() const { return two_pi / static_cast<double>(2 * std::max<Index>(harmonics_, 2)); }

void LawHarmonics::add_between_corners(const LawCourse& course, Spectra& sum) const {
  const Index count = sum.force.size(), reach = sum.with_tangent ? 2 * harmonics_ : harmonics_;
  const std::vector<double>& corners = course.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double from = corners[i], to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + two_pi;
    const LawAbout::Force there = course.at((from + to) / 2);
    if (there.force == 0 && there.by_deviation == 0 && there.by_rate == 0) continue;  // an open gap
    numerics::each_gauss_node(from, to, longest_piece(), [&](double phase, double length) {
      const Eigen::RowVectorXd row = numerics::fourier_row(reach, phase);
      const LawAbout::Force found = course.at(phase);
      const double weight = length / (two_pi / 2);
      sum.force += (weight * found.force) * row.head(count).transpose();
      if (!sum.with_tangent) return;
      sum.by_deflection += (weight * found.by_deviation) * row.transpose();
      if (law_.has_dampers()) sum.by_rate += (weight * found.by_rate) * row.transpose();
    });
  }
}

void LawHarmonics::add_loop(const LawCourse& course, const HystereticLoop& loop, Spectra& sum) const {
  const Index count = sum.force.size(), reach = sum.with_tangent ? 2 * harmonics_ : harmonics_;
  if (sum.with_tangent && sum.by_memory.size() == 0) sum.by_memory = Eigen::MatrixXd::Zero(count, count);
  for (const HystereticLoop::Branch& branch : loop.branches()) {
    VectorXd by_travel = VectorXd::Zero(count), by_start = VectorXd::Zero(count);
    const auto add = [&](double phase, double length) {
      const Eigen::RowVectorXd row = numerics::fourier_row(reach, phase);
      const elements::ForceOnTravel found = loop.at(branch, course.deflection_at(phase));
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

}  // namespace trivet::nonlinear
