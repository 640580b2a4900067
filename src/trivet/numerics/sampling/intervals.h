// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace trivet::numerics {

/// An estimate and the interval that contains the true value with a stated confidence.
struct ConfidenceInterval {
  double estimate = 0, from = 0, to = 0;
};

/// The share of successes among independent trials by Clopper and Pearson: the interval contains the true share with at
/// least the confidence, whatever the share is. Both ends leave out half of the rest each, also at 0 and 1.
/// @param confidence  in (0, 1)  @throws foundation::InvalidInput
[[nodiscard]] ConfidenceInterval share_of_trials(std::uint64_t successes, std::uint64_t trials, double confidence);

/// The lower bound of the share after trials without a failure, (1 − confidence)^(1/trials): a smaller share has such
/// trials with less than 1 − confidence. One minus it is the upper bound after trials without a success. It is a bound
/// of one side with the whole confidence, so it is higher than the end of the interval of both sides.
/// @param confidence  in (0, 1)  @throws foundation::InvalidInput
[[nodiscard]] double share_without_failures(std::uint64_t trials, double confidence);

/// The mean of independent replicates by Student's t. Its estimate is the mean of the replicates.
/// @throws foundation::InvalidInput for fewer than two
[[nodiscard]] ConfidenceInterval mean_of_replicates(std::span<const double> replicates, double confidence);

}  // namespace trivet::numerics
