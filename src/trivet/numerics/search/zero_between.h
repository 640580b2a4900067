// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace trivet::numerics {

/// Zero of a continuous function between two ends, to round-off of x (or 1e-20 of the range if that is more), by the
/// method of Alefeld, Potra and Shi (TOMS 748), which needs fewer values than bisection and never leaves the range.
/// @param function  its values at the ends are finite, and their signs differ or one of them is 0
/// @throws foundation::InvalidInput if the ends or the values there are not as required, foundation::NotComputable if a
/// value between them is not a number
[[nodiscard]] double zero_between(double from, double to, const std::function<double(double)>& function);

}  // namespace trivet::numerics
