// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/distance_laws.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/fourier_products.h"
#include "trivet/numerics/periodic/gauss_nodes.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace trivet::nonlinear {

using Eigen::Vector3d;

DistanceAbout::DistanceAbout(elements::DistanceForce law, const Vector3d& at_rest)
    : law_(std::move(law)),
      at_rest_(at_rest),
      there_(elements::force_in_motion(law_, at_rest, Vector3d::Zero())),
      kinks_(elements::kink_distances(law_)),
      has_dampers_(std::ranges::any_of(law_.laws, [](const elements::ScalarLaw& one) {
        const auto* elastic = std::get_if<elements::ElasticForce>(&one);
        return !elastic || elements::is_damped(*elastic);
      })) {}

DistanceAbout::DistanceAbout(elements::DistanceForce law, const Vector3d& at_rest, const Eigen::Matrix3d& stiffness)
    : DistanceAbout(std::move(law), at_rest) {
  there_.by_deflection = stiffness;
}

elements::SpatialForce DistanceAbout::at(const Vector3d& deviation, const Vector3d& rate) const {
  elements::SpatialForce found = elements::force_in_motion(law_, at_rest_ + deviation, rate);
  found.force -= there_.force + there_.by_deflection * deviation + there_.by_rate * rate;
  found.by_deflection -= there_.by_deflection;
  found.by_rate -= there_.by_rate;
  return found;
}

double DistanceAbout::energy(const Vector3d& deviation) const {
  return elements::elastic_energy(law_, at_rest_ + deviation) - elements::elastic_energy(law_, at_rest_) -
      there_.force.dot(deviation) - deviation.dot(there_.by_deflection * deviation) / 2;
}

std::pair<double, double> DistanceAbout::range() const {
  std::pair<double, double> common = elements::range(elements::PolynomialForce{});
  for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(law_.laws)) {
    const auto [low, high] = elements::range(law);
    common = {std::max(common.first, low + law_.length), std::min(common.second, high + law_.length)};
  }
  return common;
}

double DistanceAbout::extent() const {
  constexpr double of_distance = 0.1;
  const double distance = law_.distance(at_rest_);
  double found = of_distance * distance;
  for (const double kink : kinks_) found = std::max(found, std::abs(kink - distance));
  return found;
}

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using foundation::two_pi;

namespace {

/// The direction of a line is no polynomial of the deflections: more samples than a cube needs.
Index samples_of_directions(Index harmonics) {
  constexpr Index fewest = 64, per_harmonic = 10;
  Index count = fewest;
  while (count < per_harmonic * harmonics) count *= 2;
  return count;
}

}  // namespace

DistanceHarmonics::DistanceHarmonics(DistanceAbout law, Index harmonics) : law_(std::move(law)), harmonics_(harmonics) {
  const Index samples = samples_of_directions(harmonics);
  values_.resize(samples, numerics::coefficient_count(2 * harmonics));
  for (Index n = 0; n < samples; ++n)
    values_.row(n) =
        numerics::fourier_row(2 * harmonics, two_pi * static_cast<double>(n) / static_cast<double>(samples));
}

std::vector<double> DistanceHarmonics::corners(const MatrixXd& course) const {
  if (law_.kinks().empty()) return {};
  // The square of the distance has twice the harmonics, exactly.
  const MatrixXd deviations = values_.leftCols(course.rows()) * course;
  VectorXd square(values_.rows());
  for (Index n = 0; n < values_.rows(); ++n) square(n) = std::pow(law_.distance(deviations.row(n).transpose()), 2);
  VectorXd coefficients = 2.0 / static_cast<double>(values_.rows()) * (values_.transpose() * square);
  coefficients(0) /= 2;
  std::vector<double> levels;
  for (const double kink : law_.kinks()) levels.push_back(kink * kink);
  return numerics::level_crossings(coefficients, levels, values_);
}

/// Nodes of the integrals over a period: even samples, or Gauss's between corners. Weights add up to 2.
DistanceHarmonics::Nodes DistanceHarmonics::nodes(const MatrixXd& course) const {
  const std::vector<double> corners = this->corners(course);
  if (corners.empty()) return {{}, VectorXd::Constant(values_.rows(), 2.0 / static_cast<double>(values_.rows()))};
  const double longest = two_pi / static_cast<double>(4 * std::max<Index>(harmonics_, 2));
  std::vector<double> phases, weights;
  for (std::size_t i = 0; i < corners.size(); ++i)
    numerics::each_gauss_node(corners[i], i + 1 < corners.size() ? corners[i + 1] : corners.front() + two_pi, longest,
                              [&](double phase, double length) {
                                phases.push_back(phase);
                                weights.push_back(length / (two_pi / 2));
                              });
  Nodes found{MatrixXd(to_index(phases.size()), values_.cols()),
              Eigen::Map<const VectorXd>(weights.data(), to_index(weights.size()))};
  assert(std::abs(found.weights.sum() - 2) < 1e-9 && "stretches between corners add up to a period");
  for (std::size_t n = 0; n < phases.size(); ++n)
    found.between_corners.row(to_index(n)) = numerics::fourier_row(2 * harmonics_, phases[n]);
  return found;
}

DistanceHarmonics::Sums DistanceHarmonics::sums(const MatrixXd& course, double omega, bool with_tangents) const {
  const Nodes nodes = this->nodes(course);
  const MatrixXd& rows = nodes.between_corners.size() > 0 ? nodes.between_corners : values_;
  assert(nodes.weights.size() == rows.rows() && course.rows() <= rows.cols());
  const Index count = rows.rows(), C = course.rows();
  const bool damped = law_.has_dampers();
  const MatrixXd deviations = rows.leftCols(C) * course,
                 rates = damped ? MatrixXd(rows.leftCols(C) * (omega * numerics::phase_derivatives(course)))
                                : MatrixXd::Zero(count, 3);
  MatrixXd force(count, 3), by_deflection(with_tangents ? count : 0, 9),
      by_rate(with_tangents && damped ? count : 0, 9);
  for (Index n = 0; n < count; ++n) {
    const elements::SpatialForce there = law_.at(deviations.row(n).transpose(), rates.row(n).transpose());
    const double weight = nodes.weights(n);
    force.row(n) = weight * there.force.transpose();
    if (!with_tangents) continue;
    by_deflection.row(n) = weight * there.by_deflection.reshaped().transpose();
    if (damped) by_rate.row(n) = weight * there.by_rate.reshaped().transpose();
  }
  Sums found{rows.leftCols(C).transpose() * force, {}, {}};
  found.force.row(0) /= 2;
  if (!with_tangents) return found;
  found.by_deflection = rows.transpose() * by_deflection;
  if (damped) found.by_rate = rows.transpose() * by_rate;
  return found;
}

MatrixXd DistanceHarmonics::force_at(const MatrixXd& course, double omega) const {
  return sums(course, omega, false).force;
}

DistanceHarmonics::Spectra DistanceHarmonics::spectra_of(const Sums& sums) {
  Spectra found;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      const Index entry = to_index(a + 3 * b);
      found.by_deflection[a][b] = sums.by_deflection.col(entry);
      if (sums.by_rate.size() > 0) found.by_rate[a][b] = sums.by_rate.col(entry);
      else found.by_rate[a][b] = VectorXd::Zero(sums.by_deflection.rows());
    }
  return found;
}

DistanceHarmonics::Spectra DistanceHarmonics::tangents_at(const MatrixXd& course, double omega) const {
  return spectra_of(sums(course, omega, true));
}

DistanceHarmonics::Found DistanceHarmonics::at(const MatrixXd& course, double omega) const {
  const Sums all = sums(course, omega, true);
  Found found{all.force, MatrixXd::Zero(course.rows(), 3), {}};
  const Spectra spectra = spectra_of(all);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      found.tangent[a][b] = numerics::product_matrix(spectra.by_deflection[a][b], harmonics_);
      if (!law_.has_dampers()) continue;
      const MatrixXd on_rate = numerics::product_matrix(spectra.by_rate[a][b], harmonics_);
      found.tangent[a][b] += omega * numerics::on_motion(on_rate);
      found.by_omega.col(to_index(a)) += on_rate * numerics::phase_derivative(course.col(to_index(b)));
    }
  return found;
}

elements::SpatialForce DistanceHarmonics::at_phase(const MatrixXd& course, double omega, double phase) const {
  return at_row(course, omega, numerics::fourier_row((course.rows() - 1) / 2, phase));
}

elements::SpatialForce DistanceHarmonics::at_row(const MatrixXd& course, double omega, const RowVectorXd& row) const {
  const Vector3d rate =
      law_.has_dampers() ? Vector3d((row * omega * numerics::phase_derivatives(course)).transpose()) : Vector3d::Zero();
  return law_.at((row * course).transpose(), rate);
}

}  // namespace trivet::nonlinear
