// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/drawn_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::design {

namespace {

constexpr int most_drawn = 241;  // along an axis: about two pixels apart

std::vector<int> drawn_nodes(int points) {
  const int count = std::min(points, most_drawn);
  assert(count >= 2 && "an axis of a map has two ends");
  std::vector<int> nodes;
  for (int k = 0; k < count; ++k)
    nodes.push_back(static_cast<int>(std::lround(static_cast<double>(k) * (points - 1) / (count - 1))));
  return nodes;
}

/// Linear interpolation between drawn nodes.
double share(double among_nodes, const std::vector<int>& nodes) {
  const double at = among_nodes * static_cast<double>(nodes.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(std::max(at, 0.0)), nodes.size() - 2);
  return (nodes[k] + (at - static_cast<double>(k)) * (nodes[k + 1] - nodes[k])) / nodes.back();
}

}  // namespace

MapPlace DrawnGrid::on_map(const MapPlace& among_nodes) const {
  return {share(among_nodes.x, columns), share(among_nodes.y, rows)};
}

DrawnGrid drawn_grid(const MapGrid& grid) { return {grid, drawn_nodes(grid.nx), drawn_nodes(grid.ny)}; }

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

namespace {

/// Distance of every drawn node that is one of the equals to the nearest node that is not, nodes beyond the frame
/// included: first along columns, then across them.
template <typename Equal>
std::vector<double> depths(const DrawnGrid& drawn, const Equal& is_equal) {
  const MapGrid grid = drawn.nodes();
  const double dx = 1.0 / (grid.nx - 1), dy = 1.0 / (grid.ny - 1);
  std::vector<double> along(grid.count()), depth(grid.count());
  const auto equal = [&](std::size_t node) { return is_equal(drawn.design(node)); };
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j)
      along[grid.index(i, j)] = !equal(grid.index(i, j)) ? 0 : j == 0 ? dy : along[grid.index(i, j - 1)] + dy;
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
  if (!best) return best;
  best->without_bound = without_bound;
  constexpr float tie = 1 - 1e-6F;
  const float least = outcomes[best->design].margin * tie;
  const auto equal = [&](std::size_t k) { return outcomes[k].known() && outcomes[k].margin >= least; };
  best->equals = 0;
  for (std::size_t k = 0; k < outcomes.size(); ++k) best->equals += equal(k);
  if (best->equals < 2) return best;
  const std::vector<double> depth = depths(grid, equal);
  const double deepest = std::ranges::max(depth);
  std::vector<std::size_t> candidates;  // a narrow strip has many equally deep nodes: take the middle one
  for (std::size_t node = 0; node < depth.size(); ++node)
    if (depth[node] >= deepest * (1 - 1e-9)) candidates.push_back(node);
  assert(!candidates.empty() && "the deepest node is one of them");
  if (deepest > 0) best->design = grid.design(candidates[candidates.size() / 2]);
  return best;
}

}  // namespace trivet::design
