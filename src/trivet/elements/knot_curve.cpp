// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/knot_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::elements {

std::size_t interval(const std::vector<double>& grid, double x) {
  const auto above = std::upper_bound(grid.begin() + 1, grid.end() - 1, x);
  return to_size(above - grid.begin()) - 1;
}

double knot_slope(const std::vector<double>& x, const Eigen::Ref<const Eigen::VectorXd>& y, std::size_t i) {
  const auto secant = [&](std::size_t k) { return (y(to_index(k) + 1) - y(to_index(k))) / (x[k + 1] - x[k]); };
  const auto end_slope = [](double h0, double h1, double d0, double d1) {
    const double three_point = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (three_point * d0 <= 0) return 0.0;
    return d0 * d1 <= 0 && std::abs(three_point) > 3 * std::abs(d0) ? 3 * d0 : three_point;
  };
  const std::size_t last = x.size() - 1;
  if (last == 1) return secant(0);
  if (i == 0) return end_slope(x[1] - x[0], x[2] - x[1], secant(0), secant(1));
  if (i == last) return end_slope(x[last] - x[last - 1], x[last - 1] - x[last - 2], secant(last - 1), secant(last - 2));
  const double before = secant(i - 1), after = secant(i), h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i];
  if (before * after <= 0) return 0;
  return 3 * (h0 + h1) / ((2 * h1 + h0) / before + (h1 + 2 * h0) / after);
}

KnotCurve::KnotCurve(std::vector<double> x, const std::vector<double>& y, Interpolation interpolation)
    : interpolation_(interpolation),
      x_(std::move(x)),
      y_(Eigen::Map<const Eigen::VectorXd>(y.data(), to_index(y.size()))) {
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
    const double secant = (y_(to_index(i) + 1) - y_(to_index(i))) / (x_[i + 1] - x_[i]);
    below_.push_back(is_linear() ? secant : knot_slope(x_, y_, i));
    above_.push_back(is_linear() ? secant : knot_slope(x_, y_, i + 1));
  }
}

KnotCurve::KnotCurve(std::vector<double> x, const std::vector<double>& y, const std::vector<double>& slopes)
    : interpolation_(Interpolation::monotone_cubic),
      x_(std::move(x)),
      y_(Eigen::Map<const Eigen::VectorXd>(y.data(), to_index(y.size()))),
      below_(slopes.begin(), slopes.end() - 1),
      above_(slopes.begin() + 1, slopes.end()) {}

KnotCurve::ValueAndSlope KnotCurve::at(double x) const {
  if (x <= x_.front()) return {y_(0) + below_.front() * (x - x_.front()), below_.front()};
  if (x >= x_.back()) return {y_(y_.size() - 1) + above_.back() * (x - x_.back()), above_.back()};
  const std::size_t i = interval(x_, x);
  const double h = x_[i + 1] - x_[i], s = (x - x_[i]) / h, d0 = below_[i], d1 = above_[i], y0 = y_(to_index(i)),
               rise = y_(to_index(i) + 1) - y0;
  return {y0 + s * s * (3 - 2 * s) * rise + h * s * (1 - s) * ((1 - s) * d0 - s * d1),
          6 * s * (1 - s) * rise / h + (1 - s) * (1 - 3 * s) * d0 - s * (2 - 3 * s) * d1};
}

/// From the lower end of an interval to a share of it.
double KnotCurve::integral_in(std::size_t i, double s) const {
  const double h = x_[i + 1] - x_[i], y0 = y_(to_index(i)), rise = y_(to_index(i) + 1) - y0;
  const double s2 = s * s, s3 = s2 * s, s4 = s3 * s;
  return h *
      (y0 * s + rise * (s3 - s4 / 2) +
       h * (below_[i] * (s2 / 2 - 2 * s3 / 3 + s4 / 4) - above_[i] * (s3 / 3 - s4 / 4)));
}

double KnotCurve::integral(double x) const {
  if (x <= x_.front()) {
    const double u = x - x_.front();
    return u * (y_(0) + below_.front() * u / 2);
  }
  double sum = 0;
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
    if (x < x_[i + 1]) return sum + integral_in(i, (x - x_[i]) / (x_[i + 1] - x_[i]));
    sum += integral_in(i, 1);
  }
  const double u = x - x_.back();
  return sum + u * (y_(y_.size() - 1) + above_.back() * u / 2);
}

}  // namespace trivet::elements
