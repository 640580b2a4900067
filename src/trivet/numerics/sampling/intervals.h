// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace trivet::numerics {

/// An estimate and the interval that contains the true value with a stated confidence.
struct ConfidenceInterval {
  double estimate = 0, from = 0, to = 0;
};

/// The share of successes among independent trials by Clopper and Pearson: it contains the true share with at least the
/// confidence, for any share. Without failures (or successes) it is one-sided, with the whole confidence: with none in
/// n trials the share is at least (1 − confidence)^(1/n).
/// @param confidence  in (0, 1)  @throws foundation::InvalidInput
[[nodiscard]] ConfidenceInterval share_of_trials(std::uint64_t successes, std::uint64_t trials, double confidence);

/// The mean of independent replicates by Student's t. Its estimate is the mean of the replicates.
/// @throws foundation::InvalidInput for fewer than two
[[nodiscard]] ConfidenceInterval mean_of_replicates(std::span<const double> replicates, double confidence);

}  // namespace trivet::numerics
