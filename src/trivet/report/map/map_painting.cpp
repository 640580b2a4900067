// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map/map_painting.h"

#include <fmt/format.h>

#include <array>

namespace trivet::report {
namespace {

// Okabe and Ito's colours mixed with white.
constexpr std::array<const char*, different_rules> rule_colours = {"#f2bd66", "#8cc8ee", "#e08a66", "#66c4ab",
                                                                   "#dba6c6", "#f5ec8e", "#7aa9cf"};

}  // namespace

const char* rule_colour(std::size_t rank) { return rank < rule_colours.size() ? rule_colours[rank] : other_colour; }

void draw_regions(MapPicture& picture, const std::vector<MapRegion>& regions, const std::string& name,
                  const std::function<const char*(const MapRegion&, std::size_t)>& colour) {
  const auto paint = [&](std::vector<design::MapLine> MapRegion::* side) {
    for (std::size_t rank = 0; rank < regions.size(); ++rank)
      picture.canvas.area(picture.rings(regions[rank].*side),
                          fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.7\"", colour(regions[rank], rank)));
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
