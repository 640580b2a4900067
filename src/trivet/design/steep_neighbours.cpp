// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/steep_neighbours.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace trivet::design {

std::size_t steep_neighbours(const MapGrid& grid, const std::vector<MapRule>& rules,
                             const std::vector<DesignOutcome>& outcomes) {
  constexpr float often = 10;
  const auto by_amplitude = [&](const DesignOutcome& d) {
    assert(!d.known() || !std::isfinite(d.margin) || d.governing < rules.size());
    return d.known() && std::isfinite(d.margin) && rules[d.governing].kind == DesignRule::Kind::amplitude;
  };
  const auto is_steep = [&](const DesignOutcome& a, const DesignOutcome& b) {
    return by_amplitude(a) && by_amplitude(b) && std::max(a.margin, b.margin) > often * std::min(a.margin, b.margin);
  };
  std::size_t steep = 0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const DesignOutcome& here = outcomes[grid.index(i, j)];
      steep += i + 1 < grid.nx && is_steep(here, outcomes[grid.index(i + 1, j)]);
      steep += j + 1 < grid.ny && is_steep(here, outcomes[grid.index(i, j + 1)]);
    }
  return steep;
}

}  // namespace trivet::design
