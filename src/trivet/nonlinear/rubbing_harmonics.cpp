// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rubbing_harmonics.h"

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;
using Of = RubbingLoop::Of;

RubbingHarmonics rubbing_harmonics(const RubbingLoop& loop, const MatrixXd& course, double omega, bool with_tangent) {
  const Index count = course.rows(), points = to_index(loop.points().size());
  const double own = loop.law().own_stiffness();
  RubbingHarmonics found{-own * course.rightCols<2>(), MatrixXd::Zero(count, 2)};
  MatrixXd rows(points, count), integral(count, points);
  Eigen::RowVectorXd row;
  for (Index i = 0; i < points; ++i) {
    const RubbingLoop::Point& point = loop.points()[to_size(i)];
    numerics::set_fourier_row((count - 1) / 2, point.phase, row);
    rows.row(i) = row;
    integral.col(i) = point.weight / (two_pi / 2) * row.transpose();
    integral(0, i) /= 2;
    found.force += integral.col(i) * point.force.transpose();
  }
  if (!with_tangent) return found;
  MatrixXd slopes = MatrixXd::Zero(points, count);  // of the rows by the phase
  for (Index k = 1; 2 * k < count; ++k) {
    slopes.col(2 * k - 1) = -static_cast<double>(k) * rows.col(2 * k);
    slopes.col(2 * k) = static_cast<double>(k) * rows.col(2 * k - 1);
  }
  VectorXd by_deflection(points), by_rate(points);
  for (Index i = 0; i < points; ++i) {
    by_deflection(i) = loop.points()[to_size(i)].limit.by_deflection;
    by_rate(i) = loop.points()[to_size(i)].limit.by_rate;
  }
  // The last column: by the frequency, which changes the rate.
  MatrixXd limits(points, count + 1);
  limits.leftCols(count) = by_deflection.asDiagonal() * rows + omega * by_rate.asDiagonal() * slopes;
  limits.col(count) = by_rate.cwiseProduct(slopes * course.col(0));
  const std::array<RubbingLoop::Forces<double>, 3> variations = {loop.variation<double>(Of::limit, limits),
                                                                 loop.variation<double>(Of::first_across, rows),
                                                                 loop.variation<double>(Of::second_across, rows)};
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 3; ++b) found.tangent[a][b] = integral * variations[b][a].leftCols(count);
    found.tangent[a][a + 1].diagonal().array() -= own;
    found.by_omega.col(to_index(a)) = integral * variations[0][a].col(count);
  }
  return found;
}

RubbingVariation rubbing_variation(const RubbingLoop& loop, double omega, double mu, Index harmonics) {
  const Index count = 2 * harmonics + 1, points = to_index(loop.points().size());
  MatrixXcd waves(points, count), limits(points, count), integral(count, points);
  for (Index i = 0; i < points; ++i) {
    const RubbingLoop::Point& point = loop.points()[to_size(i)];
    for (Index k = 0; k < count; ++k) {
      const double order = mu + static_cast<double>(k - harmonics);
      const Complex wave = std::polar(1.0, order * point.phase);
      waves(i, k) = wave;
      limits(i, k) = (point.limit.by_deflection + Complex(0, order * omega) * point.limit.by_rate) * wave;
      integral(k, i) = point.weight / two_pi * std::conj(wave);
    }
  }
  const Complex turned = std::polar(1.0, two_pi * mu);
  const std::array<RubbingLoop::Forces<Complex>, 3> variations = {
      loop.variation<Complex>(Of::limit, limits, turned), loop.variation<Complex>(Of::first_across, waves, turned),
      loop.variation<Complex>(Of::second_across, waves, turned)};
  RubbingVariation found;
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 3; ++b) found[a][b] = integral * variations[b][a];
    found[a][a + 1].diagonal().array() -= loop.law().own_stiffness();
  }
  return found;
}

}  // namespace trivet::nonlinear
