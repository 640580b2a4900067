// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace trivet::response {

/// Least and largest value of a vibration over all time.
struct RangeInTime {
  double least = 0, largest = 0;
  bool is_bound = false;  ///< an upper bound: orders that take part have no common period

  [[nodiscard]] double peak() const { return largest >= -least ? largest : -least; }  ///< zero-to-peak
  [[nodiscard]] double span() const { return largest - least; }                       ///< peak-to-peak
};

/// Orders of a shaft together in time: y(t) = Re Σ_k y_k e^{ikΩt}, whatever Ω.
class OrdersInTime {
 public:
  /// @param orders  k > 0. Two have a common period if their ratio is that of whole numbers up to 2000, to 1e-9.
  explicit OrdersInTime(const std::vector<double>& orders);

  /// The range of y to 1e-11 of Σ|y_k|. Orders with a common period are searched over it. Those without one come as
  /// near as one likes to any combination of phases, if no multiples of them are equal sums: the ranges add, which is
  /// an upper bound in any case. Infinite if an amplitude is.
  /// @param amplitudes  y_k in the order of the constructor
  [[nodiscard]] RangeInTime range(const Eigen::VectorXcd& amplitudes) const;

 private:
  /// Orders with a common period: k = multiple × the frequency of the period.
  struct Periodic {
    std::vector<Eigen::Index> places;
    std::vector<double> multiples;
  };
  /// The orders of both groups; none if they have no common period.
  static std::optional<Periodic> together(const Periodic& one, const Periodic& other,
                                          const std::vector<double>& orders);
  std::vector<Periodic> periodic_;
};

}  // namespace trivet::response
