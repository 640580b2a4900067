// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/law_harmonics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/periodic/fourier_basis.h"

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

/// Derivatives of the force by the coefficients of the deflection, from the spectrum of the tangent: products of two
/// harmonics k and l are those of k + l and k − l.
Eigen::MatrixXd tangent_matrix(const VectorXd& spectrum, Index harmonics) {
  const auto c = [&](Index n) { return n == 0 ? spectrum(0) : spectrum(2 * std::abs(n) - 1); };
  const auto s = [&](Index n) { return n == 0 ? 0.0 : n > 0 ? spectrum(2 * n) : -spectrum(-2 * n); };
  Eigen::MatrixXd matrix(numerics::coefficient_count(harmonics), numerics::coefficient_count(harmonics));
  matrix(0, 0) = c(0) / 2;
  for (Index k = 1; k <= harmonics; ++k) {
    matrix(0, 2 * k - 1) = c(k) / 2;
    matrix(0, 2 * k) = s(k) / 2;
    matrix(2 * k - 1, 0) = c(k);
    matrix(2 * k, 0) = s(k);
    for (Index l = 1; l <= harmonics; ++l) {
      matrix(2 * k - 1, 2 * l - 1) = (c(k - l) + c(k + l)) / 2;
      matrix(2 * k, 2 * l - 1) = (s(k + l) + s(k - l)) / 2;
      matrix(2 * k - 1, 2 * l) = (s(k + l) - s(k - l)) / 2;
      matrix(2 * k, 2 * l) = (c(k - l) - c(k + l)) / 2;
    }
  }
  return matrix;
}

/// A zero of a trigonometric polynomial minus a level in a bracket, by Newton's method inside it.
double zero_between(const VectorXd& motion, const VectorXd& slope, double level, double low, double high) {
  const Index harmonics = (motion.size() - 1) / 2;
  const auto at = [&](double phase) { return numerics::motion_at(harmonics, phase, motion) - level; };
  double value_low = at(low), phase = (low + high) / 2;
  constexpr int most = 80;
  for (int i = 0; i < most && high - low > 1e-15 * two_pi; ++i) {
    const double value = at(phase);
    if (value == 0) return phase;
    if ((value < 0) == (value_low < 0)) {
      low = phase;
      value_low = value;
    } else {
      high = phase;
    }
    const double newton = phase - value / numerics::motion_at(harmonics, phase, slope);
    const double next = newton > low && newton < high ? newton : (low + high) / 2;
    if (std::abs(next - phase) < 1e-16 * two_pi) return next;
    phase = next;
  }
  return phase;
}

// Gauss's rule of 8 points on [−1, 1]: for pieces of up to one wave of the highest harmonic its error is below 1e-9.
constexpr std::array<double, 4> gauss_places = {0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                                                0.96028985649753623168};
constexpr std::array<double, 4> gauss_weights = {0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                                                 0.10122853629037625915};

}  // namespace

LawHarmonics::LawHarmonics(LawAbout law, Index harmonics)
    : law_(std::move(law)), kinks_(law_.kinks()), harmonics_(harmonics) {
  const Index samples = sample_count(harmonics);
  values_.resize(samples, numerics::coefficient_count(2 * harmonics));
  for (Index n = 0; n < samples; ++n)
    values_.row(n) =
        numerics::fourier_row(2 * harmonics, two_pi * static_cast<double>(n) / static_cast<double>(samples));
}

ForceHarmonics LawHarmonics::at(const VectorXd& deflection) const {
  Spectra found = spectra(deflection, true);
  return {std::move(found.force), tangent_matrix(found.tangent, harmonics_)};
}

VectorXd LawHarmonics::force_at(const VectorXd& deflection) const { return spectra(deflection, false).force; }

LawHarmonics::Spectra LawHarmonics::spectra(const VectorXd& deflection, bool with_tangent) const {
  Spectra sum{VectorXd::Zero(deflection.size()),
              VectorXd::Zero(with_tangent ? numerics::coefficient_count(2 * harmonics_) : 0)};
  const std::vector<double> phases = kink_phases(deflection);
  if (phases.empty()) add_sampled(deflection, with_tangent, sum);
  else add_between(phases, deflection, with_tangent, sum);
  sum.force(0) /= 2;
  return sum;
}

void LawHarmonics::add_sampled(const VectorXd& deflection, bool with_tangent, Spectra& sum) const {
  const Index count = deflection.size();
  const VectorXd course = values_.leftCols(count) * deflection;
  VectorXd force(course.size()), tangent(course.size());
  for (Index n = 0; n < course.size(); ++n) {
    const elements::ForceAndTangent found = law_.at(course(n));
    force(n) = found.force;
    tangent(n) = found.tangent;
  }
  const double weight = 2.0 / static_cast<double>(course.size());
  sum.force.noalias() += weight * values_.leftCols(count).transpose() * force;
  if (with_tangent) sum.tangent.noalias() += weight * values_.transpose() * tangent;
}

std::vector<double> LawHarmonics::kink_phases(const VectorXd& deflection) const {
  if (kinks_.empty()) return {};
  const VectorXd slope = numerics::phase_derivative(deflection);
  const VectorXd course = values_.leftCols(deflection.size()) * deflection,
                 rate = values_.leftCols(deflection.size()) * slope;
  const VectorXd curvature = numerics::phase_derivative(slope);
  const Index samples = course.size();
  const double step = two_pi / static_cast<double>(samples);
  std::vector<std::pair<double, double>> places;  // phase and deflection: samples, and extrema between them
  for (Index n = 0; n < samples; ++n) {
    const double phase = step * static_cast<double>(n);
    places.emplace_back(phase, course(n));
    const double next = rate((n + 1) % samples);
    if ((rate(n) < 0) == (next < 0)) continue;
    const double extremum = zero_between(slope, curvature, 0, phase, phase + step);
    places.emplace_back(extremum, numerics::motion_at(harmonics_, extremum, deflection));
  }
  places.emplace_back(two_pi, course(0));
  std::vector<double> phases;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    for (const double kink : kinks_)
      if ((places[i].second < kink) != (places[i + 1].second < kink))
        phases.push_back(zero_between(deflection, slope, kink, places[i].first, places[i + 1].first));
  std::sort(phases.begin(), phases.end());
  return phases;
}

void LawHarmonics::add_between(const std::vector<double>& phases, const VectorXd& deflection, bool with_tangent,
                               Spectra& sum) const {
  const double longest = two_pi / static_cast<double>(2 * std::max<Index>(harmonics_, 2));
  const Index count = deflection.size(), reach = with_tangent ? 2 * harmonics_ : harmonics_;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double from = phases[i], to = i + 1 < phases.size() ? phases[i + 1] : phases.front() + two_pi;
    const double inside = numerics::motion_at(harmonics_, (from + to) / 2, deflection);
    const elements::ForceAndTangent there = law_.at(inside);
    if (there.force == 0 && there.tangent == 0) continue;  // an open gap
    const auto pieces = static_cast<Index>(std::ceil((to - from) / longest));
    const double half = (to - from) / static_cast<double>(2 * pieces);
    for (Index p = 0; p < pieces; ++p)
      for (std::size_t g = 0; g < gauss_places.size(); ++g)
        for (const double side : {-1.0, 1.0}) {
          const double phase = from + half * (static_cast<double>(2 * p + 1) + side * gauss_places[g]);
          const Eigen::RowVectorXd row = numerics::fourier_row(reach, phase);
          const elements::ForceAndTangent found = law_.at(row.head(count).dot(deflection));
          const double weight = gauss_weights[g] * half / (two_pi / 2);
          sum.force += (weight * found.force) * row.head(count).transpose();
          if (with_tangent) sum.tangent += (weight * found.tangent) * row.transpose();
        }
  }
}

}  // namespace trivet::nonlinear
