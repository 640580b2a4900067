// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/extremum.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/peaks/axis_panels.h"

namespace trivet::numerics {

std::vector<Extremum> alternating(std::vector<Extremum> all) {
  std::ranges::stable_sort(all, {}, &Extremum::angular_frequency);
  std::vector<Extremum> result;
  for (const Extremum& e : all) {
    if (result.empty() || result.back().maximum != e.maximum) result.push_back(e);
    else if ((e.amplitude > result.back().amplitude) == e.maximum) result.back() = e;
  }
  return result;
}

CurveHeights heights_of(const SearchedCurve& curve, double from, double to, bool start_is_scale) {
  CurveHeights heights;
  heights.highest_at = from;
  const auto add = [&](double amplitude, double omega) {
    const double height = std::isnan(amplitude) ? std::numeric_limits<double>::infinity() : amplitude;  // Z is singular
    heights.along.push_back(height);
    if (std::isfinite(height) && (start_is_scale || heights.along.size() > 1))
      heights.finite_top = std::max(heights.finite_top, height);
    if (height > heights.highest) heights.highest = height, heights.highest_at = omega;
  };
  add(curve.at_start, from);
  for (const Extremum& e : curve.extrema) add(e.amplitude, e.angular_frequency);
  add(curve.at_end, to);
  return heights;
}

namespace {

constexpr double near = 16 * gap_at_pole, far = 160 * gap_at_pole;

}  // namespace

std::array<double, 4> around_pole(double pole) {
  return {pole * (1 - far), pole * (1 - near), pole * (1 + near), pole * (1 + far)};
}

bool is_unbounded(const std::array<double, 4>& y) {
  return y[1] > 9 * y[0] && y[2] > 9 * y[3];
}  // a nearby pole gives 10

Extremum unbounded_at(double pole) {
  return {pole, std::numeric_limits<double>::infinity(), true, gap_at_pole * pole, 0};
}

std::optional<Extremum> bounded_at(double pole, const std::array<double, 4>& y) {
  if (!(y[1] > y[0]) || !(y[2] > y[3])) return std::nullopt;
  std::array<double, 4> f;
  std::ranges::transform(y, f.begin(), [](double amplitude) { return 1 / (amplitude * amplitude); });
  const double bend = (f[0] + f[3] - f[1] - f[2]) / (2 * (far * far - near * near));
  const double slope = (far * (f[3] - f[0]) + near * (f[2] - f[1])) / (2 * (far * far + near * near));
  const double middle = 0.25 * (f[0] + f[1] + f[2] + f[3]) - 0.5 * bend * (far * far + near * near);
  const double place = -0.5 * slope / bend, least = middle + 0.5 * slope * place;
  if (!(bend > 0) || !(least > 0) || !(std::abs(place) <= near)) return std::nullopt;
  return Extremum{pole * (1 + place), 1 / std::sqrt(least), true, near * pole, gap_at_pole * pole};
}

namespace {

Eigen::RowVectorXd possible(const CurveTerms& terms, const Eigen::MatrixXd& sizes, const Eigen::RowVectorXd& omega) {
  const auto reach = [&](const auto& on) -> Eigen::RowVectorXd {
    return on.head(sizes.rows()).cwiseAbs().transpose() * sizes;
  };
  return reach(terms.on_displacement) + reach(terms.on_velocity).cwiseProduct(omega) +
      reach(terms.on_acceleration).cwiseProduct(omega.cwiseAbs2());
}

}  // namespace

ObservedCurve observed_curve(const ObservedRow& row) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(row.on_displacement.size());
  return {{row.on_displacement.cast<std::complex<double>>(), row.on_velocity.size() > 0 ? row.on_velocity : none, none},
          {},
          row.derivative};
}

Eigen::RowVectorXcd weighted(const CurveTerms& terms, const Eigen::MatrixXcd& x, const Eigen::RowVectorXcd& omega) {
  const Eigen::Index n = x.rows();
  Eigen::RowVectorXcd y = terms.on_displacement.head(n).transpose() * x;
  if (!terms.on_velocity.head(n).isZero(0))
    y += Complex(0, 1) * (terms.on_velocity.head(n).transpose().cast<Complex>() * x).cwiseProduct(omega);
  if (!terms.on_acceleration.head(n).isZero(0))
    y -= (terms.on_acceleration.head(n).transpose().cast<Complex>() * x).cwiseProduct(omega.cwiseProduct(omega));
  return y;
}

Eigen::RowVectorXcd curve_values(const ObservedCurve& curve, const Eigen::MatrixXcd& q, const Eigen::MatrixXcd& given,
                                 const Eigen::RowVectorXcd& omega) {
  Eigen::RowVectorXcd y = weighted(curve.of_response, q, omega);
  if (!curve.of_given.empty() && given.size() > 0) y += weighted(curve.of_given, given, omega);
  for (Eigen::Index i = 0; i < y.size(); ++i)
    y(i) *= integer_power(std::complex<double>(0, 1) * omega(i), curve.derivative);
  return y;
}

Eigen::RowVectorXd possible_amplitudes(const ObservedCurve& curve, const Eigen::MatrixXd& q,
                                       const Eigen::MatrixXd& given, const Eigen::RowVectorXd& omega) {
  Eigen::RowVectorXd y = possible(curve.of_response, q, omega);
  if (!curve.of_given.empty() && given.size() > 0) y += possible(curve.of_given, given, omega);
  return y.cwiseProduct(omega.array().pow(curve.derivative).matrix());
}

}  // namespace trivet::numerics
