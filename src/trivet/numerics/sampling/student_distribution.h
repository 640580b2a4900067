// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::numerics {

/// t such that a Student variable is in (−t, t) with probability `confidence`.
/// @param confidence  in (0, 1)
/// @param degrees_of_freedom  > 0, not necessarily an integer; infinite: the normal distribution
[[nodiscard]] double student_quantile(double confidence, double degrees_of_freedom);

}  // namespace trivet::numerics
