// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>

namespace trivet::elements {

/// w with dw/ds = 1 − w^n from w(0) = 0, which tends to 1.
class Saturation {
 public:
  /// @param exponent  n ≥ 1
  explicit Saturation(double exponent);

  struct Reached {
    double value = 0, rate = 0;  ///< w and dw/ds
  };
  /// @param travel  s ≥ 0. Errors are below 1e-14, of the rate n times that.
  [[nodiscard]] Reached at(double travel) const;
  /// s at w in [0, 1); at 1 that at which w is 1 but for round-off.
  [[nodiscard]] double travel(double value) const;

  [[nodiscard]] double exponent() const { return n_; }

 private:
  [[nodiscard]] double series(double value, double power) const;
  [[nodiscard]] double near_limit(double missing) const;
  [[nodiscard]] double missing_at(double travel) const;

  /// Of a polynomial in x of [−1, 1].
  using Coefficients = std::array<double, 22>;
  double n_;
  Coefficients value_ = {}, rate_ = {};                 ///< for s ≤ 1: w/s and dw/ds over sⁿ
  Coefficients missing_ = {}, rate_over_missing_ = {};  ///< beyond: (1 − w)/e and (dw/ds)/e over e = e^{n (1 − s)}
};

/// The last eight exponents are kept, per thread.
[[nodiscard]] std::shared_ptr<const Saturation> saturation(double exponent);

}  // namespace trivet::elements
