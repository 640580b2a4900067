// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/search/minimum_between.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {

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
