// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trivet::numerics {

/// How a number is distributed.
enum class DistributionShape {
  uniform,     ///< within `spread` on both sides of the mean
  triangular,  ///< the same, with a peak at the mean
  normal,      ///< with the standard deviation `spread`
  lognormal,   ///< the same: mean and standard deviation are those of the number, not of its logarithm; mean > 0
  measured     ///< as often as in a list
};

struct Distribution {
  DistributionShape shape = DistributionShape::uniform;
  double mean = 0;                          ///< before truncation
  double spread = 0;                        ///< > 0; half width or standard deviation
  std::optional<double> truncated_at = {};  ///< normal, lognormal: only numbers within this distance of the mean occur
  std::vector<double> measured = {};        ///< ascending
};

/// The number that a share of all does not exceed: uniform shares give numbers of the distribution.
/// @param share  in the open interval (0, 1)
[[nodiscard]] double quantile(const Distribution& distribution, double share);

/// The least and the largest number that occur; infinite where there is none. The numbers of a lognormal distribution
/// have no least one unless it is truncated above 0.
[[nodiscard]] std::pair<double, double> ends(const Distribution& distribution);

/// The share of numbers below or at a value.
[[nodiscard]] double share_up_to(const Distribution& distribution, double value);

/// Shares with a Gaussian copula from independent ones: both become normal numbers, and linear combinations of these
/// have the wanted correlations. What is wanted is the correlation of these normal numbers.
class GaussianCopula {
 public:
  struct Correlation {
    std::size_t a = 0, b = 0;
    double value = 0;  ///< between −1 and 1, both excluded
  };
  /// @param correlations  of different pairs; those not named are 0
  GaussianCopula(std::size_t dimensions, const std::vector<Correlation>& correlations);

  /// If no numbers can have all these correlations: the first that makes it impossible, with those before it and 0 for
  /// all others. Else none.
  [[nodiscard]] const std::optional<std::size_t>& impossible() const { return impossible_; }

  /// Replaces independent shares by correlated ones. @pre !impossible()
  void correlate(Eigen::Ref<Eigen::VectorXd> shares) const;

 private:
  std::vector<Eigen::Index> correlated_;  ///< the dimensions with correlations
  Eigen::MatrixXd lower_;                 ///< L with L Lᵀ = correlations
  std::optional<std::size_t> impossible_;
};

}  // namespace trivet::numerics
