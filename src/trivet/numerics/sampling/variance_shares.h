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

  /// By Jansen's estimators in each replicate [Jansen1999], with Student's intervals of their means:
  /// first = 1 − ⟨(f(b) − f(ab))²⟩/⟨(f(a) − f(b))²⟩, total = ⟨(f(a) − f(ab))²⟩/2V, V the variance of f(a) and f(b).
  /// @returns  per dimension; empty if the standard deviation is within nine digits of the value in a replicate, or one
  /// has fewer than two pairs
  [[nodiscard]] std::vector<VarianceShare> shares(double confidence) const;
  /// Of all replicates.
  [[nodiscard]] std::size_t fewest_pairs() const { return std::ranges::min(sums_, {}, &Sums::pairs).pairs; }

 private:
  struct Sums {
    std::size_t pairs = 0;
    double sum = 0, squares = 0;   ///< of all f(a) − reference and f(b) − reference
    Eigen::VectorXd first, total;  ///< of squared differences; total: last f(a) − f(b)
  };
  std::vector<Sums> sums_;
  std::optional<double> reference_;  ///< a value of the function, against cancellation
};

}  // namespace trivet::numerics
