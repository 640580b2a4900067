// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/curve_series.h"

#include <cmath>
#include <complex>

#include "trivet/numerics/sign_changes.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
using Series = Eigen::RowVectorXcd;

/// Series times (a + bτ).
Series times_linear(const Series& s, Complex a, Complex b) {
  Series result = a * s;
  result.tail(s.size() - 1) += b * s.head(s.size() - 1);
  return result;
}

std::vector<double> squared_modulus(const Series& y) {
  std::vector<double> square(static_cast<std::size_t>(y.size()), 0.0);
  for (Eigen::Index k = 0; k < y.size(); ++k)
    for (Eigen::Index j = 0; j <= k; ++j)
      square[static_cast<std::size_t>(k)] += y(j).real() * y(k - j).real() + y(j).imag() * y(k - j).imag();
  return square;
}

}  // namespace

CurveSeries curve_series(const assembly::Channel& channel, const Panel& panel, const Eigen::MatrixXcd& q) {
  const Complex i(0, 1);
  const bool viscous = channel.on_velocity.cwiseAbs().maxCoeff() > 0;
  Series y = channel.on_displacement.transpose() * q;
  const Series rate = viscous ? Series(channel.on_velocity.transpose().cast<Complex>() * q) : Series();
  const bool inert = !channel.on_acceleration.isZero(0);
  const Series force_of_mass = inert ? Series(channel.on_acceleration.transpose().cast<Complex>() * q) : Series();
  if (panel.at_infinity) {
    // y = (i/s)^derivative (c0 + (i/s) c1 − c2/s²) s² p(s); the powers of s are kept apart, so that the series stays regular.
    if (viscous || inert) y = times_linear(y, 0, panel.radius);
    if (viscous) y += i * rate;
    if (inert) y = (times_linear(y, 0, panel.radius) - force_of_mass).eval();
    return {squared_modulus(y), (inert ? 0 : viscous ? 1 : 2) - channel.derivative};
  }
  if (viscous) y += times_linear(rate, i * panel.centre, i * panel.radius);
  if (inert) y -= times_linear(times_linear(force_of_mass, panel.centre, panel.radius), panel.centre, panel.radius);
  for (int d = 0; d < channel.derivative; ++d) y = times_linear(y, i * panel.centre, i * panel.radius);
  return {squared_modulus(y), 0};
}

std::vector<double> slope(const CurveSeries& series) {
  const std::vector<double>& f = series.square;
  std::vector<double> g;
  if (series.power == 0) {
    for (std::size_t k = 1; k < f.size(); ++k) g.push_back(static_cast<double>(k) * f[k]);
  } else {
    for (std::size_t k = 0; k < f.size(); ++k) g.push_back((2.0 * series.power + static_cast<double>(k)) * f[k]);
  }
  return g;
}

double angular_frequency(const Panel& panel, double tau) {
  return panel.at_infinity ? 1 / (panel.radius * tau) : panel.centre + panel.radius * tau;
}

double amplitude(const CurveSeries& series, const Panel& panel, double tau) {
  const double square = std::max(numerics::polynomial_value(series.square, tau), 0.0);
  if (!panel.at_infinity) return std::sqrt(square);
  return std::sqrt(square) * std::pow(panel.radius * tau, series.power);
}

}  // namespace trivet::response
