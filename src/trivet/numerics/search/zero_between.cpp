// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/search/zero_between.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
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

}  // namespace trivet::numerics
