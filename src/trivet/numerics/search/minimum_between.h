// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace trivet::numerics {

struct Minimum {
  double at = 0;
  double value = 0;
};

/// Minimum of a function with one minimum between two ends, by Brent's method (parabolas and golden sections). Its
/// place is known to 3e-8 of half the range, about the root of round-off, which limits every search by values; an error
/// of the value is then round-off. With several minima it is one of them.
/// @param function  may be infinite
/// @throws foundation::InvalidInput if the ends are not finite or not ascending, foundation::NotComputable if a value
/// is not a number
[[nodiscard]] Minimum minimum_between(double from, double to, const std::function<double(double)>& function);

}  // namespace trivet::numerics
