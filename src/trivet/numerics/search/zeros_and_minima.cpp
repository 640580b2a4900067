// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/search/zeros_and_minima.h"

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {

double zero_between(double from, double to, const std::function<double(double)>& function) {
  constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();
  constexpr double part_of_range = 1e-20;      // for a zero at 0, whose own round-off is 0
  constexpr std::uintmax_t most_values = 300;  // four values halve the range at least: 4 · 67 for 1e-20 of it
  const double low = std::min(from, to), high = std::max(from, to);
  const double at_low = function(low), at_high = function(high);
  if (!(std::isfinite(high - low) && std::isfinite(at_low) && std::isfinite(at_high)))
    throw foundation::InvalidInput(
        fmt::format("zero between {:g} and {:g}: the ends and the values {:g} and {:g} must be finite", low, high,
                    at_low, at_high));
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  if ((at_low > 0) == (at_high > 0))
    throw foundation::InvalidInput(fmt::format(
        "zero between {:g} and {:g}: the values {:g} and {:g} must differ in sign", low, high, at_low, at_high));
  const auto value = [&](double x) {
    const double result = function(x);
    if (std::isnan(result)) throw foundation::NotComputable(fmt::format("zero search: no value at {:g}", x));
    return result;
  };
  const double closest = part_of_range * (high - low);
  const auto settled = [&](double a, double b) {
    return b - a <= std::max(round_off * std::max(std::abs(a), std::abs(b)), closest);
  };
  std::uintmax_t values = most_values;
  const auto [a, b] = boost::math::tools::toms748_solve(value, low, high, at_low, at_high, settled, values);
  assert(settled(a, b));
  return a + 0.5 * (b - a);
}

Minimum minimum_between(double from, double to, const std::function<double(double)>& function, int bits) {
  constexpr std::uintmax_t most_values = 200;  // golden sections alone need 40
  constexpr double largest = 1e300;            // stands for infinity, so that parabolas remain computable
  if (!(std::isfinite(to - from) && from < to))
    throw foundation::InvalidInput(
        fmt::format("minimum between {:g} and {:g}: the ends must be finite and ascending", from, to));
  const double centre = from + 0.5 * (to - from), half = 0.5 * (to - from);
  const auto place = [&](double share) { return std::clamp(centre + half * share, from, to); };
  const auto value = [&](double share) {
    const double result = function(place(share));
    if (std::isnan(result))
      throw foundation::NotComputable(fmt::format("minimum search: no value at {:g}", place(share)));
    return std::clamp(result, -largest, largest);
  };
  // Brent's tolerance is relative to the place: in shares of half the range, narrow ranges far from 0 are resolved.
  std::uintmax_t values = most_values;
  const auto [share, least] = boost::math::tools::brent_find_minima(value, -1.0, 1.0, bits, values);
  assert(values < most_values);
  return {place(share), std::abs(least) < largest ? least : function(place(share))};
}

}  // namespace trivet::numerics
