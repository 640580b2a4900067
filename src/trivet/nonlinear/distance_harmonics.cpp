// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/distance_harmonics.h"

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/fourier_products.h"
#include "trivet/numerics/periodic/gauss_nodes.h"
#include "trivet/numerics/periodic/level_crossings.h"

namespace trivet::nonlinear {

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
  VectorXd square(values_.rows());
  for (Index n = 0; n < values_.rows(); ++n) {
    const Vector3d here = (values_.row(n).head(course.rows()) * course).transpose();
    square(n) = std::pow(law_.distance(here), 2);
  }
  VectorXd coefficients = 2.0 / static_cast<double>(values_.rows()) * (values_.transpose() * square);
  coefficients(0) /= 2;
  std::vector<double> levels;
  for (const double kink : law_.kinks()) levels.push_back(kink * kink);
  return numerics::level_crossings(coefficients, levels, values_);
}

/// Nodes of the integrals over a period: even samples, or Gauss's between corners. Weights add up to 2.
void DistanceHarmonics::each_node(const MatrixXd& course, double omega, const Visit& visit) const {
  const MatrixXd rate = omega * numerics::phase_derivatives(course);
  const Index count = course.rows();
  const auto at_row = [&](const RowVectorXd& row, double weight) {
    visit(row, weight, law_.at((row.head(count) * course).transpose(), (row.head(count) * rate).transpose()));
  };
  const std::vector<double> corners = this->corners(course);
  if (corners.empty()) {
    const double weight = 2.0 / static_cast<double>(values_.rows());
    for (Index n = 0; n < values_.rows(); ++n) at_row(values_.row(n), weight);
    return;
  }
  const double longest = two_pi / static_cast<double>(4 * std::max<Index>(harmonics_, 2));
  for (std::size_t i = 0; i < corners.size(); ++i)
    numerics::each_gauss_node(corners[i], i + 1 < corners.size() ? corners[i + 1] : corners.front() + two_pi, longest,
                              [&](double phase, double length) {
                                at_row(numerics::fourier_row(2 * harmonics_, phase), length / (two_pi / 2));
                              });
}

MatrixXd DistanceHarmonics::force_at(const MatrixXd& course, double omega) const {
  MatrixXd sum = MatrixXd::Zero(course.rows(), 3);
  each_node(course, omega, [&](const RowVectorXd& row, double weight, const elements::SpatialForce& force) {
    sum.noalias() += weight * row.head(course.rows()).transpose() * force.force.transpose();
  });
  sum.row(0) /= 2;
  return sum;
}

DistanceHarmonics::Spectra DistanceHarmonics::tangents_at(const MatrixXd& course, double omega) const {
  Spectra sum;
  for (auto* square : {&sum.by_deflection, &sum.by_rate})
    for (auto& row : *square)
      for (VectorXd& entry : row) entry = VectorXd::Zero(values_.cols());
  each_node(course, omega, [&](const RowVectorXd& row, double weight, const elements::SpatialForce& force) {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        sum.by_deflection[a][b] += weight * force.by_deflection(to_index(a), to_index(b)) * row.transpose();
        if (law_.has_dampers()) sum.by_rate[a][b] += weight * force.by_rate(to_index(a), to_index(b)) * row.transpose();
      }
  });
  return sum;
}

DistanceHarmonics::Found DistanceHarmonics::at(const MatrixXd& course, double omega) const {
  Found found{force_at(course, omega), MatrixXd::Zero(course.rows(), 3), {}};
  const Spectra spectra = tangents_at(course, omega);
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
  const RowVectorXd row = numerics::fourier_row((course.rows() - 1) / 2, phase);
  return law_.at((row * course).transpose(), (row * omega * numerics::phase_derivatives(course)).transpose());
}

}  // namespace trivet::nonlinear
