// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/response_series.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/numerics/peaks/extremum.h"
#include "trivet/numerics/peaks/peak_count.h"

namespace trivet::numerics {
namespace {

using Complex = std::complex<double>;
using Series = Eigen::RowVectorXcd;

/// Terms kept of every Taylor series: 0.4³⁶ ≈ 5e-15.
constexpr int series_order = 36;
/// Panels are searched slightly beyond their ends, so that no extremum on a seam is lost; duplicates merge afterwards.
constexpr double overlap = 1e-6;
/// An extremum below this share of the first panel's radius is at ω = 0.
constexpr double at_rest = 1e-7;

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

/// The same series with the leading power of s lowered by `by`.
Laurent lowered(const Laurent& y, int by, const Panel& panel) {
  Laurent result{Series::Zero(y.coefficients.size()), y.power - by};
  const Eigen::Index kept = y.coefficients.size() - by;
  if (kept > 0) result.coefficients.tail(kept) = std::pow(panel.radius, by) * y.coefficients.head(kept);
  return result;
}

/// The same series without its first coefficient, which is 0: the leading power of s rises by one.
Laurent without_first(const Laurent& y, const Panel& panel) {
  Laurent result{Series::Zero(y.coefficients.size()), y.power + 1};
  result.coefficients.head(y.coefficients.size() - 1) = y.coefficients.tail(y.coefficients.size() - 1) / panel.radius;
  return result;
}

Laurent sum(const Laurent& a, const Laurent& b, const Panel& panel) {
  const int power = std::min(a.power, b.power);
  const Laurent x = lowered(a, a.power - power, panel), y = lowered(b, b.power - power, panel);
  return {x.coefficients + y.coefficients, power};
}

/// Series of `terms` applied to the series of the coordinates.
Laurent weighted_series(const CurveTerms& terms, const Panel& panel, const SeriesAtInfinity& of) {
  const Complex i(0, 1);
  Laurent y{terms.on_displacement.transpose() * of.coefficients, of.power};
  if (!terms.on_velocity.isZero(0)) {
    const Series rate = i * (terms.on_velocity.transpose().cast<Complex>() * of.coefficients);
    if (panel.at_infinity) y = sum(y, {rate, of.power - 1}, panel);
    else y.coefficients += times_linear(rate, panel.centre, panel.radius);
  }
  if (!terms.on_acceleration.isZero(0)) {
    const Series inertia = -(terms.on_acceleration.transpose().cast<Complex>() * of.coefficients);
    if (panel.at_infinity) y = sum(y, {inertia, of.power - 2}, panel);
    else y.coefficients += times_linear(times_linear(inertia, panel.centre, panel.radius), panel.centre, panel.radius);
  }
  return y;
}

/// Coefficients of d|y|²/dτ; at infinity, of a polynomial with its sign for τ > 0.
std::vector<double> slope(const CurveSeries& series) {
  std::vector<double> g;
  for (std::size_t k = series.power == 0 ? 1 : 0; k < series.square.size(); ++k)
    g.push_back((2.0 * series.power + static_cast<double>(k)) * series.square[k]);
  return g;
}

}  // namespace

CoordinateSeries coordinate_series(const ResponseSeries& response, const Load& given, const Panel& panel) {
  const bool rests = given.vanishes();
  if (panel.at_infinity)
    return {response.at_infinity(panel.radius, series_order),
            rests ? SeriesAtInfinity{} : load_series_at_infinity(given, panel.radius, series_order)};
  return {{response.about(panel.centre, panel.radius, series_order), 0},
          {rests ? Eigen::MatrixXcd() : load_series(given, panel.centre, panel.radius, series_order), 0}};
}

CurveSeries squared_modulus(const Eigen::RowVectorXcd& y, int power) {
  const auto count = to_size(y.size());
  CurveSeries result{std::vector<double>(count, 0.0), power};
  const Eigen::RowVectorXd re = y.real(), im = y.imag();
  const double *a = re.data(), *b = im.data();
  double* square = result.square.data();
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t k = 0; k + j < count; ++k) square[j + k] += a[j] * a[k] + b[j] * b[k];
  return result;
}

CurveSeries curve_series(const ObservedCurve& curve, const Panel& panel, const CoordinateSeries& coordinates) {
  Laurent y = weighted_series(curve.of_response, panel, coordinates.response);
  if (!curve.of_given.empty() && coordinates.given.coefficients.size() > 0)
    y = sum(y, weighted_series(curve.of_given, panel, coordinates.given), panel);
  const Complex i(0, 1);
  if (panel.at_infinity) {
    y.power -= curve.derivative;
    while (!y.coefficients.isZero(0) && y.coefficients(0) == Complex(0)) y = without_first(y, panel);
    return squared_modulus(y.coefficients, y.power);
  }
  for (int d = 0; d < curve.derivative; ++d)
    y.coefficients = times_linear(y.coefficients, i * panel.centre, i * panel.radius);
  return squared_modulus(y.coefficients);
}

double size_of(const CurveSeries& series) {
  double largest = 0;
  for (const double s : series.square) largest = std::max(largest, std::abs(s));
  return std::sqrt(largest);
}

double amplitude(const CurveSeries& series, const Panel& panel, double tau) {
  const double root = std::sqrt(std::max(polynomial_value(series.square, tau), 0.0));
  return panel.at_infinity ? root * std::pow(panel.radius * tau, series.power) : root;
}

double limit_at_infinity(const CurveSeries& series, const Panel& panel) {
  const double negligible = std::pow(vanishing_share * size_of(series), 2);
  const auto leading = std::ranges::find_if(series.square, [&](double s) { return s > negligible; });
  const auto power = std::ptrdiff_t{2} * series.power + (leading - series.square.begin());  // of 1/ω in |y|²
  if (leading == series.square.end() || power > 0) return 0;
  return power < 0 ? std::numeric_limits<double>::infinity()
                   : std::sqrt(*leading) * std::pow(panel.radius, series.power);
}

double rise_of_square(const CurveSeries& series, const Panel& panel, double tau) {
  return polynomial_value(slope(series), tau) / panel.radius;
}

void add_extrema(const CurveSeries& series, const Panel& panel, double from, double to,
                 std::vector<Extremum>& extrema) {
  std::vector<SignChange> changes = sign_changes(slope(series), panel.at_infinity ? 0 : -1 - overlap, 1 + overlap);
  if (panel.at_infinity) std::ranges::reverse(changes);
  for (const SignChange& change : changes) {
    if (panel.at_infinity && !(change.at > 0)) continue;
    const double omega = panel.at_infinity ? 1 / (panel.radius * change.at) : panel.centre + panel.radius * change.at;
    // Without damping |y|² is even about ω = 0: the extremum at rest is not a peak, and round-off may shift it from 0.
    if (!panel.at_infinity && !(omega > at_rest * panel.radius)) continue;
    if (!(omega > from && omega < to)) continue;
    // A maximum remains one if the axis is reversed.
    const double step = panel.at_infinity ? omega : panel.radius;
    extrema.push_back({omega, amplitude(series, panel, change.at), change.falling, step, step * change.uncertainty});
  }
}

}  // namespace trivet::numerics
