// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "trivet/numerics/sampling/intervals.h"

namespace trivet::numerics {

/// Shares of the variance of a number that come from one of the independent numbers on which it depends.
struct VarianceShare {
  ConfidenceInterval first;  ///< from this number alone
  ConfidenceInterval total;  ///< with all that it does together with others
};

/// Values of a function at pairs of independent points a, b, and with single coordinates exchanged, in replicates.
class PairedValues {
 public:
  PairedValues(std::size_t dimensions, std::size_t replicates);

  /// @param exchanged  per dimension: at a with this coordinate of b
  void add(std::size_t replicate, double at_a, double at_b, const Eigen::VectorXd& exchanged);

  /// Ratios of sums over the pairs of all replicates, as in Jansen's estimators [Jansen1999]:
  /// first = 1 − Σ(f(b) − f(ab))²/Σ(f(a) − f(b))², total = Σ(f(a) − f(ab))²/(2V·pairs), V the variance of f(a) and
  /// f(b). Estimate and Student's interval are those of the jackknife over the replicates: a mean of the ratios of
  /// single replicates is biased by 1/pairs of one replicate, this one by 1/pairs² of all.
  /// @returns  per dimension; empty if the standard deviation is within nine digits of the value without one of the
  /// replicates, or one has fewer than two pairs
  [[nodiscard]] std::vector<VarianceShare> shares(double confidence) const;
  /// Of a replicate.
  [[nodiscard]] std::size_t fewest_pairs() const { return std::ranges::min(sums_, {}, &Sums::pairs).pairs; }

 private:
  struct Sums {
    std::size_t pairs = 0;
    double sum = 0, squares = 0;   ///< of all f(a) − reference and f(b) − reference
    Eigen::VectorXd first, total;  ///< of squared differences; total: last f(a) − f(b)
  };
  /// Of all replicates, or without one.
  [[nodiscard]] Sums all_but(std::optional<std::size_t> left_out) const;
  /// Of f(a) and f(b); 0 if it is not known from the digits of the values.
  [[nodiscard]] double variance(const Sums& of) const;

  std::vector<Sums> sums_;
  std::optional<double> reference_;  ///< a value of the function, against cancellation
};

}  // namespace trivet::numerics
