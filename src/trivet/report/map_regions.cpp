// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace trivet::report {
namespace {

study::MapPlace middle(const study::MapPlace& a, const study::MapPlace& b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

/// The part of a cell that belongs to one label: its corners, cut at the middles of the edges; with three or four labels in quarters.
void add_parts(const std::array<study::MapPlace, 4>& corner, const std::array<std::uint8_t, 4>& label, std::map<std::uint8_t, MapRegion>& regions) {
  const std::set<std::uint8_t> labels(label.begin(), label.end());
  const study::MapPlace centre = middle(corner[0], corner[2]);
  if (labels.size() > 2) {
    for (std::size_t c = 0; c < 4; ++c)
      regions[label[c]].rings.push_back({corner[c], middle(corner[c], corner[(c + 1) % 4]), centre, middle(corner[c], corner[(c + 3) % 4])});
    return;
  }
  for (const std::uint8_t each : labels) {
    study::MapLine part;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t next = (c + 1) % 4;
      if (label[c] == each) part.push_back(corner[c]);
      if ((label[c] == each) != (label[next] == each)) part.push_back(middle(corner[c], corner[next]));
    }
    regions[each].rings.push_back(std::move(part));
  }
}

}  // namespace

std::vector<MapRegion> map_regions(const study::DesignMap& map) {
  const std::vector<int>&columns = map.drawn.columns, &rows = map.drawn.rows;
  const auto label_of = [](const study::DesignOutcome& outcome) { return std::isinf(outcome.margin) ? MapRegion::unlimited : outcome.governing; };
  const auto label = [&](std::size_t i, std::size_t j) { return label_of(map.outcomes[map.grid.index(columns[i], rows[j])]); };
  const auto place = [&](std::size_t i, std::size_t j) { return map.grid.place(columns[i], rows[j]); };
  std::map<std::uint8_t, MapRegion> regions;
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
    for (std::size_t i = 0; i + 1 < columns.size();) {
      const std::uint8_t here = label(i, j);
      const auto uniform = [&](std::size_t k) { return label(k, j) == here && label(k, j + 1) == here; };
      std::size_t end = i;
      while (end < columns.size() && uniform(end)) ++end;
      if (end > i + 1) {  // a run of equal cells is one rectangle
        regions[here].rings.push_back({place(i, j), place(end - 1, j), place(end - 1, j + 1), place(i, j + 1)});
        i = end - 1;
      } else {
        add_parts({place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)}, {label(i, j), label(i + 1, j), label(i + 1, j + 1), label(i, j + 1)}, regions);
        ++i;
      }
    }
  for (const study::DesignOutcome& outcome : map.outcomes)
    if (const auto region = regions.find(label_of(outcome)); region != regions.end()) ++region->second.designs;
  std::vector<MapRegion> result;
  for (auto& [governing, region] : regions) {
    region.governing = governing;
    result.push_back(std::move(region));
  }
  std::stable_sort(result.begin(), result.end(), [](const MapRegion& a, const MapRegion& b) { return a.designs > b.designs; });
  return result;
}

}  // namespace trivet::report
