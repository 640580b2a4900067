// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/margin_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace trivet::design {
namespace {

/// Up to five round margins between 1 and the largest.
std::vector<double> round_margins(double largest) {
  for (const auto& candidates : {std::vector{1.05, 1.1, 1.15, 1.2, 1.25},
                                 {1.1, 1.2, 1.3, 1.4, 1.5},
                                 {1.25, 1.5, 1.75, 2.0, 2.5},
                                 {1.5, 2.0, 3.0, 4.0, 5.0},
                                 {2.0, 5.0, 10.0, 20.0, 50.0}})
    if (largest <= candidates.back() || candidates.back() == 50) {
      std::vector<double> below;
      for (const double margin : candidates)
        if (margin < largest) below.push_back(margin);
      return below;
    }
  return {};
}

/// Up to six round margins below the largest if none reaches 1: the coarsest steps with at least four above the least.
std::vector<double> round_margins_below(double largest, double least) {
  constexpr std::size_t enough = 4, most = 6;
  std::vector<double> every_tenth;
  for (int k = 10; k < 100; ++k) every_tenth.push_back(0.1 * k);
  std::vector<double> margins;
  for (const auto& steps : {std::vector{1.0, 2.0, 5.0},
                            {1.0, 1.5, 2.0, 3.0, 5.0, 7.0},
                            {1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0},
                            every_tenth}) {
    margins.clear();
    for (double decade = std::pow(10, std::floor(std::log10(largest))); decade * 10 > least && margins.size() < most;
         decade /= 10)
      for (auto step = steps.rbegin(); step != steps.rend(); ++step)
        if (decade * *step < largest && decade * *step > least) margins.push_back(decade * *step);
    if (margins.size() >= enough) break;
  }
  const std::size_t stride =
      std::max<std::size_t>(1, (margins.size() + most - 1) / most);  // spread the many tenths over their range
  std::vector<double> chosen;
  for (std::size_t k = 0; k < margins.size() && chosen.size() < most; k += stride) chosen.push_back(margins[k]);
  return chosen;
}

double least_above_zero(const std::vector<DesignOutcome>& outcomes) {
  double least = std::numeric_limits<double>::infinity();
  for (const DesignOutcome& outcome : outcomes)
    if (outcome.known() && outcome.margin > 0) least = std::min(least, static_cast<double>(outcome.margin));
  return least;
}

double length(const MapLine& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += std::hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y);
  return sum;
}

/// Adds the pieces of a line between undefined (NaN) places, except for very short ones.
void add_pieces(const MapLine& line, const DrawnGrid& grid, std::vector<MapLine>& pieces) {
  constexpr double crumb = 0.05;  // of an axis
  MapLine piece;
  bool whole = true;
  const auto finish = [&] {
    if (piece.size() > 1 && (whole || length(piece) > crumb)) pieces.push_back(piece);
    piece.clear();
  };
  for (const MapPlace& place : line)
    if (std::isnan(place.x + place.y)) whole = false, finish();
    else piece.push_back(grid.on_map(place));
  finish();
}

/// Do several of these margins lie between `a` and `b`? Then their lines are closer to each other than the designs.
bool crowded(const std::vector<double>& margins, double a, double b) {
  return std::ranges::count_if(margins, [&](double m) { return (m > a) != (m > b); }) > 1;
}

std::vector<MapLine> lines_of(const DrawnGrid& grid, const std::vector<DesignOutcome>& outcomes, double margin,
                              const std::vector<double>& all) {
  const MapGrid nodes = grid.nodes();
  const auto margin_at = [&](std::size_t node) {
    const DesignOutcome& outcome = outcomes[grid.design(node)];
    return outcome.known() ? static_cast<double>(outcome.margin) : std::numeric_limits<double>::quiet_NaN();
  };
  const std::function<bool(std::size_t)> above = [&](std::size_t node) { return margin_at(node) >= margin; };
  const std::vector<CrossedEdge> edges = crossed_edges(nodes, above);
  std::vector<double> crossing;
  for (const CrossedEdge& e : edges) {
    const double a = margin_at(nodes.index(e.i, e.j)),
                 b = margin_at(e.upwards ? nodes.index(e.i, e.j + 1) : nodes.index(e.i + 1, e.j));
    const bool between = a > 0 && b > 0 && std::isfinite(a) && std::isfinite(b) && !crowded(all, a, b);
    crossing.push_back(between ? std::log(margin / a) / std::log(b / a) : std::numeric_limits<double>::quiet_NaN());
  }
  std::vector<MapLine> pieces;
  for (const MapLine& line : contours(nodes, above, edges, crossing, [](int, int) { return false; }).lines)
    add_pieces(line, grid, pieces);
  return pieces;
}

}  // namespace

std::vector<MarginLine> margin_lines(const DrawnGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                     double largest) {
  const std::vector<double> margins =
      largest < 1 ? round_margins_below(largest, least_above_zero(outcomes)) : round_margins(largest);
  std::vector<double> with_boundary = {1};
  with_boundary.insert(with_boundary.end(), margins.begin(), margins.end());
  std::vector<MarginLine> all;
  for (const double margin : margins)
    if (std::vector<MapLine> lines = lines_of(grid, outcomes, margin, with_boundary); !lines.empty())
      all.push_back({margin, std::move(lines)});
  return all;
}

}  // namespace trivet::design
