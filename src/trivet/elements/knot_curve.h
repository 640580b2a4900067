// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::elements {

/// Interpolation between knots. The monotone cubic (Fritsch–Butland) has no overshoot.
enum class Interpolation { linear, monotone_cubic };

/// Interval i of a grid with x_i ≤ x ≤ x_{i+1}; the first or the last one outside.
[[nodiscard]] std::size_t interval(const std::vector<double>& grid, double x);

/// Slope of the monotone cubic at knot i: weighted harmonic mean of the secants, 0 at an extremum; at an end
/// three-point, limited. [Fritsch and Butland 1984]
[[nodiscard]] double knot_slope(const std::vector<double>& x, const Eigen::Ref<const Eigen::VectorXd>& y,
                                std::size_t i);

/// y over x through knots, straight on beyond the first and the last one.
class KnotCurve {
 public:
  KnotCurve() = default;
  /// @param x  two or more, ascending
  KnotCurve(std::vector<double> x, const std::vector<double>& y, Interpolation interpolation);
  /// Cubic with these slopes at the knots.
  KnotCurve(std::vector<double> x, const std::vector<double>& y, const std::vector<double>& slopes);

  struct ValueAndSlope {
    double value = 0, slope = 0;
  };
  [[nodiscard]] ValueAndSlope at(double x) const;
  /// ∫ y dx from the first knot.
  [[nodiscard]] double integral(double x) const;
  [[nodiscard]] bool is_linear() const { return interpolation_ == Interpolation::linear; }
  [[nodiscard]] const std::vector<double>& knots() const { return x_; }

 private:
  [[nodiscard]] double integral_in(std::size_t interval, double share) const;

  Interpolation interpolation_ = Interpolation::linear;
  std::vector<double> x_;
  Eigen::VectorXd y_;
  std::vector<double> below_, above_;  ///< slopes at the lower and the upper end of each interval
};

}  // namespace trivet::elements
