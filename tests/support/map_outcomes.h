// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/design/map_contours.h"

namespace trivet::test {

inline constexpr float unlimited = std::numeric_limits<float>::infinity();

/// Outcomes of a grid whose margins are a function of the nodes, (int i, int j) → float.
template <typename Margin>
std::vector<design::DesignOutcome> outcomes(const design::MapGrid& grid, const Margin& margin) {
  std::vector<design::DesignOutcome> all;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) all.push_back({margin(i, j), 0});
  return all;
}

}  // namespace trivet::test
