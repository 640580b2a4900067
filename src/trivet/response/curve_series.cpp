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

/// s^power Σ coefficients_k τᵏ with s = radius τ at infinity; power 0 elsewhere.
struct Laurent {
  Series coefficients;
  int power = 0;
};

/// The same with `by` fewer powers of s in front.
Laurent lowered(const Laurent& y, int by, const numerics::Panel& panel) {
  Laurent result{Series::Zero(y.coefficients.size()), y.power - by};
  const Eigen::Index kept = y.coefficients.size() - by;
  if (kept > 0) result.coefficients.tail(kept) = std::pow(panel.radius, by) * y.coefficients.head(kept);
  return result;
}

/// Its first coefficient is 0: one more power of s in front.
Laurent without_first(const Laurent& y, const numerics::Panel& panel) {
  Laurent result{Series::Zero(y.coefficients.size()), y.power + 1};
  result.coefficients.head(y.coefficients.size() - 1) = y.coefficients.tail(y.coefficients.size() - 1) / panel.radius;
  return result;
}

Laurent sum(const Laurent& a, const Laurent& b, const numerics::Panel& panel) {
  const int power = std::min(a.power, b.power);
  const Laurent x = lowered(a, a.power - power, panel), y = lowered(b, b.power - power, panel);
  return {x.coefficients + y.coefficients, power};
}

/// (on_displacement + iω on_velocity − ω² on_acceleration)ᵀ of some coordinates.
Laurent weighted(const Eigen::VectorXcd& on_displacement, const Eigen::VectorXd& on_velocity, const Eigen::VectorXd& on_acceleration,
                 const numerics::Panel& panel, const numerics::SeriesAtInfinity& of) {
  const Complex i(0, 1);
  Laurent y{on_displacement.transpose() * of.coefficients, of.power};
  if (!on_velocity.isZero(0)) {
    const Series rate = i * (on_velocity.transpose().cast<Complex>() * of.coefficients);
    if (panel.at_infinity) y = sum(y, {rate, of.power - 1}, panel);
    else y.coefficients += times_linear(rate, panel.centre, panel.radius);
  }
  if (!on_acceleration.isZero(0)) {
    const Series inertia = -(on_acceleration.transpose().cast<Complex>() * of.coefficients);
    if (panel.at_infinity) y = sum(y, {inertia, of.power - 2}, panel);
    else y.coefficients += times_linear(times_linear(inertia, panel.centre, panel.radius), panel.centre, panel.radius);
  }
  return y;
}

std::vector<double> squared_modulus(const Series& y) {
  std::vector<double> square(static_cast<std::size_t>(y.size()), 0.0);
  for (Eigen::Index k = 0; k < y.size(); ++k)
    for (Eigen::Index j = 0; j <= k; ++j)
      square[static_cast<std::size_t>(k)] += y(j).real() * y(k - j).real() + y(j).imag() * y(k - j).imag();
  return square;
}

}  // namespace

CoordinateSeries coordinate_series(const numerics::DynamicMatrices& matrices, const numerics::Load& right_side,
                                   const numerics::Load& ground_motion, const numerics::Panel& panel) {
  const bool rests = ground_motion.vanishes();
  if (panel.at_infinity)
    return {numerics::response_series_at_infinity(matrices, right_side, panel.radius, series_order),
            rests ? numerics::SeriesAtInfinity{} : numerics::load_series_at_infinity(ground_motion, panel.radius, series_order)};
  return {{numerics::response_series(matrices, right_side, panel.centre, panel.radius, series_order), 0},
          {rests ? Eigen::MatrixXcd() : numerics::load_series(ground_motion, panel.centre, panel.radius, series_order), 0}};
}

CurveSeries curve_series(const assembly::Channel& channel, const numerics::Panel& panel, const CoordinateSeries& coordinates) {
  Laurent y = weighted(channel.on_displacement, channel.on_velocity, channel.on_acceleration, panel, coordinates.free);
  if (!channel.ground.empty() && coordinates.ground.coefficients.size() > 0) {
    const assembly::GroundTerms& g = channel.ground;
    y = sum(y, weighted(g.on_displacement, g.on_velocity, g.on_acceleration, panel, coordinates.ground), panel);
  }
  const Complex i(0, 1);
  if (panel.at_infinity) {
    y.power -= channel.derivative;
    while (!y.coefficients.isZero(0) && y.coefficients(0) == Complex(0)) y = without_first(y, panel);
    return {squared_modulus(y.coefficients), y.power};
  }
  for (int d = 0; d < channel.derivative; ++d) y.coefficients = times_linear(y.coefficients, i * panel.centre, i * panel.radius);
  return {squared_modulus(y.coefficients), 0};
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

double angular_frequency(const numerics::Panel& panel, double tau) {
  return panel.at_infinity ? 1 / (panel.radius * tau) : panel.centre + panel.radius * tau;
}

double amplitude(const CurveSeries& series, const numerics::Panel& panel, double tau) {
  const double square = std::max(numerics::polynomial_value(series.square, tau), 0.0);
  if (!panel.at_infinity) return std::sqrt(square);
  return std::sqrt(square) * std::pow(panel.radius * tau, series.power);
}

}  // namespace trivet::response
