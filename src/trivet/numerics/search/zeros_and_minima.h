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

struct Minimum {
  double at = 0;
  double value = 0;
};

/// Bits of the place of a minimum beyond which values differ by round-off only: a step of 2⁻²⁶ changes a parabola by
/// 2⁻⁵².
inline constexpr int bits_of_minimum = 26;

/// Minimum of a function with one minimum between two ends, by Brent's method (parabolas and golden sections). Its
/// place is known to 2^(1−bits) of half the range: with 26 to 3e-8, about the root of round-off, which limits every
/// search by values; an error of the value is then round-off. With several minima it is one of them.
/// @param function  may be infinite
/// @param bits      fewer for a function that takes long
/// @throws foundation::InvalidInput if the ends are not finite or not ascending, foundation::NotComputable if a value
/// is not a number
[[nodiscard]] Minimum minimum_between(double from, double to, const std::function<double(double)>& function,
                                      int bits = bits_of_minimum);

}  // namespace trivet::numerics
