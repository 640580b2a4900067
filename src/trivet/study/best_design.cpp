// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/best_design.h"

#include <algorithm>
#include <cmath>

namespace trivet::study {
namespace {

/// Distance of every drawn node without bound to the nearest other, nodes beyond the frame among these: first along columns, then across them.
std::vector<double> depths(const DrawnGrid& drawn, const std::vector<DesignOutcome>& outcomes) {
  const MapGrid grid = drawn.nodes();
  const double dx = 1.0 / (grid.nx - 1), dy = 1.0 / (grid.ny - 1);
  std::vector<double> along(grid.count()), depth(grid.count());
  const auto unlimited = [&](std::size_t node) { return std::isinf(outcomes[drawn.design(node)].margin); };
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) along[grid.index(i, j)] = !unlimited(grid.index(i, j)) ? 0 : j == 0 ? dy : along[grid.index(i, j - 1)] + dy;
    for (int j = grid.ny - 1; j >= 0; --j) {
      double& here = along[grid.index(i, j)];
      here = std::min(here, j + 1 == grid.ny ? dy : along[grid.index(i, j + 1)] + dy);
    }
  }
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      double least = dx * std::min(i + 1, grid.nx - i);  // to the frame
      for (int k = 0; k < grid.nx; ++k) least = std::min(least, std::hypot((i - k) * dx, along[grid.index(k, j)]));
      depth[grid.index(i, j)] = least;
    }
  return depth;
}

}  // namespace

std::optional<BestDesign> best_design(const DrawnGrid& grid, const std::vector<DesignOutcome>& outcomes) {
  std::optional<BestDesign> best;
  std::size_t without_bound = 0;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (!outcomes[k].known()) continue;
    without_bound += std::isinf(outcomes[k].margin);
    if (!best || outcomes[k].margin > outcomes[best->design].margin) best = BestDesign{k, 0};
  }
  if (without_bound == 0) return best;
  best->without_bound = without_bound;
  const std::vector<double> depth = depths(grid, outcomes);
  const auto deepest = static_cast<std::size_t>(std::max_element(depth.begin(), depth.end()) - depth.begin());
  if (depth[deepest] > 0) best->design = grid.design(deepest);
  return best;
}

}  // namespace trivet::study
