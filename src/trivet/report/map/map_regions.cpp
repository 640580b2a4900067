// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map/map_regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace trivet::report {

namespace {

using Labels = std::array<std::uint8_t, 4>;  // of a cell's corners, counter-clockwise
using Parts = std::map<std::uint8_t, std::vector<design::MapLine>>;

design::MapPlace middle(const design::MapPlace& a, const design::MapPlace& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}

/// The part of a cell that belongs to one label: its corners, cut at the middles of the edges; with three or four
/// labels in quarters.
void add_parts(const std::array<design::MapPlace, 4>& corner, const Labels& label, Parts& parts) {
  const std::set<std::uint8_t> labels(label.begin(), label.end());
  const design::MapPlace centre = middle(corner[0], corner[2]);
  if (labels.size() > 2) {
    for (std::size_t c = 0; c < 4; ++c)
      parts[label[c]].push_back(
          {corner[c], middle(corner[c], corner[(c + 1) % 4]), centre, middle(corner[c], corner[(c + 3) % 4])});
    return;
  }
  for (const std::uint8_t each : labels) {
    design::MapLine part;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t next = (c + 1) % 4;
      if (label[c] == each) part.push_back(corner[c]);
      if ((label[c] == each) != (label[next] == each)) part.push_back(middle(corner[c], corner[next]));
    }
    parts[each].push_back(std::move(part));
  }
}

/// One side of the boundary: the feasible designs, or the others.
class Side {
 public:
  Side(const study::DesignMap& map, bool feasible) : map_(map), feasible_(feasible) {}

  [[nodiscard]] Parts parts() const {
    const std::size_t columns = map_.drawn.columns.size(), rows = map_.drawn.rows.size();
    Parts result;
    for (std::size_t j = 0; j + 1 < rows; ++j)
      for (std::size_t i = 0; i + 1 < columns;) {
        const std::optional<Labels> labels = labels_of(i, j);
        std::size_t end = i + 1;
        if (labels && is_uniform(*labels)) {  // a run of equal cells is one rectangle
          while (end + 1 < columns && labels_of(end, j) == labels) ++end;
          result[labels->front()].push_back({place(i, j), place(end, j), place(end, j + 1), place(i, j + 1)});
        } else if (labels) {
          add_parts({place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)}, *labels, result);
        }
        i = end;
      }
    return result;
  }

 private:
  static bool is_uniform(const Labels& labels) {
    return std::ranges::all_of(labels, [&](std::uint8_t label) { return label == labels.front(); });
  }
  [[nodiscard]] design::MapPlace place(std::size_t i, std::size_t j) const {
    return map_.grid.place(map_.drawn.columns[i], map_.drawn.rows[j]);
  }
  [[nodiscard]] std::optional<std::uint8_t> label(int column, int row) const {
    const design::DesignOutcome& outcome = map_.outcomes[map_.grid.index(column, row)];
    return outcome.feasible() == feasible_ ? std::optional(results::governing_of(outcome)) : std::nullopt;
  }

  /// Labels of a drawn cell; a corner beyond the boundary gets that of the nearest corner on this side. None if the
  /// cell has no design on this side.
  [[nodiscard]] std::optional<Labels> labels_of(std::size_t i, std::size_t j) const {
    const int left = map_.drawn.columns[i], right = map_.drawn.columns[i + 1], low = map_.drawn.rows[j],
              high = map_.drawn.rows[j + 1];
    const std::array<std::optional<std::uint8_t>, 4> own = {label(left, low), label(right, low), label(right, high),
                                                            label(left, high)};
    std::optional<std::uint8_t> any;
    for (const auto& corner : own)
      if (!any) any = corner;
    if (!any) any = label_between(left, right, low, high);
    if (!any) return std::nullopt;
    Labels labels{};
    for (std::size_t c = 0; c < 4; ++c)
      labels[c] = own[c].value_or(own[(c + 1) % 4].value_or(own[(c + 3) % 4].value_or(*any)));
    return labels;
  }

  /// Label of the first design on this side that is not drawn, in a cell of a fine grid.
  [[nodiscard]] std::optional<std::uint8_t> label_between(int left, int right, int low, int high) const {
    for (int row = low; row <= high; ++row)
      for (int column = left; column <= right; ++column)
        if (const auto found = label(column, row)) return found;
    return std::nullopt;
  }

  const study::DesignMap& map_;
  bool feasible_;
};

}  // namespace

std::vector<MapRegion> map_regions(const study::DesignMap& map) {
  std::map<std::uint8_t, MapRegion> regions;
  for (auto& [label, parts] : Side(map, false).parts()) regions[label].infeasible = std::move(parts);
  for (auto& [label, parts] : Side(map, true).parts()) regions[label].feasible = std::move(parts);
  for (const design::DesignOutcome& outcome : map.outcomes)
    if (const auto region = regions.find(results::governing_of(outcome)); region != regions.end())
      ++region->second.designs;
  std::vector<MapRegion> result;
  for (auto& [governing, region] : regions) {
    region.governing = governing;
    result.push_back(std::move(region));
  }
  std::ranges::stable_sort(result, [](const MapRegion& a, const MapRegion& b) {
    return a.known() != b.known() ? a.known() : a.designs > b.designs;
  });
  return result;
}

void draw_regions(MapPicture& picture, const std::vector<MapRegion>& regions, const std::string& name,
                  const results::MapColours& colours) {
  const auto paint = [&](std::vector<design::MapLine> MapRegion::* side) {
    for (const MapRegion& region : regions)
      picture.canvas.area(
          picture.rings(region.*side),
          fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.7\"",
                      region.known() ? colours.of(region.governing) : results::MapColours::not_computed));
  };
  paint(&MapRegion::infeasible);
  const auto outline = picture.rings(picture.map.feasible.rings);
  if (outline.empty()) return;
  picture.canvas.begin_clip(outline, "feasible of " + name);
  paint(&MapRegion::feasible);
  picture.canvas.end_clip();
  picture.canvas.area(outline, lighter);
  for (const design::MapLine& line : picture.map.feasible.lines)
    picture.canvas.polyline(picture.line(line), "stroke=\"#000\" stroke-width=\"2.4\" stroke-linejoin=\"round\"");
}

}  // namespace trivet::report
