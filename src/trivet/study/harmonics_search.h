// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace trivet::study {

/// The answer with the number of harmonics that was asked for or, for 0, the first one tried that leaves out no more
/// than the tolerance.
/// @param compute  answer for a number of harmonics, with a member `left_out`
template <typename Compute>
[[nodiscard]] auto with_enough_harmonics(int asked, double tolerance, const Compute& compute) {
  constexpr Eigen::Index first = 5, most = 60;
  if (asked > 0) return compute(Eigen::Index{asked});
  for (Eigen::Index harmonics = first;; harmonics = std::min(most, 2 * harmonics)) {
    auto found = compute(harmonics);
    if (found.left_out <= tolerance || harmonics == most) return found;
  }
}

}  // namespace trivet::study
