// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map/map_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "trivet/report/drawing/result_figures.h"
#include "trivet/report/map/map_picture.h"
#include "trivet/report/map/map_regions.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::report {
namespace {

void explain_regions(const study::DesignMap& map, const std::vector<MapRegion>& regions,
                     const results::MapColours& colours, Key& key) {
  const auto share = [&](std::size_t designs) {
    return fmt::format("{:.1f} % of the designs",
                       100.0 * static_cast<double>(designs) / static_cast<double>(map.outcomes.size()));
  };
  key.heading("Rule with the least margin");
  MapRegion others;
  for (const MapRegion& region : regions) {
    const bool infeasible = !region.infeasible.empty(), feasible = !region.feasible.empty();
    if (!region.known()) break;
    const std::string colour = colours.of(region.governing);
    if (colour == results::MapColours::other_rules) {
      others.designs += region.designs;
      if (infeasible) others.infeasible = region.infeasible;
      if (feasible) others.feasible = region.feasible;
    } else {
      key.region(colour, infeasible, feasible,
                 region.governing == MapRegion::unlimited ? "no rule limits it: " + results::unlimited_words(map)
                                                          : results::rule_words(map, map.rules[region.governing]),
                 share(region.designs));
    }
  }
  if (others.designs > 0)
    key.region(results::MapColours::other_rules, !others.infeasible.empty(), !others.feasible.empty(), "other rules",
               share(others.designs));
  if (map.unknown > 0)
    key.region(results::MapColours::not_computed, true, false, results::not_computed_words, share(map.unknown));
}

void explain_feasible(const study::DesignMap& map, Key& key) {
  key.heading("Feasible region");
  if (map.feasible.rings.empty()) return key.add_text("no design of this map is feasible", "");
  key.patch("fill=\"white\" stroke=\"#000\" stroke-width=\"2\"", "every rule is met (lighter)",
            fmt::format("{} of {} designs", map.feasible_designs, map.outcomes.size()));
  key.stroke("stroke=\"#000\" stroke-width=\"2.4\"", "margin 1: value at its limit");
}

/// Distance in pixels from a point to the boundary or to the frame.
double room_at(const MapPicture& picture, PixelPoint p) {
  const PlotPanel& panel = picture.panel;
  double room = std::min(std::min(p.x - panel.corner.x, panel.corner.x + panel.width - p.x),
                         std::min(p.y - panel.corner.y, panel.corner.y + panel.height - p.y));
  for (const design::MapLine& line : picture.map.feasible.lines)
    for (const design::MapPlace& place : line)
      room = std::min(room, std::hypot(picture.at(place).x - p.x, picture.at(place).y - p.y));
  return room;
}

/// Free position on the longest piece of a line, far from the boundary.
std::optional<PixelPoint> label_place(const MapPicture& picture, const design::MarginLine& margin, double half_width) {
  constexpr double least = 10, enough = 45;  // pixels of room
  const auto longest =
      std::ranges::max_element(margin.lines, [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (longest == margin.lines.end()) return std::nullopt;
  double most = least;
  std::optional<PixelPoint> best;
  for (std::size_t k = 0; k < longest->size(); k += 1 + longest->size() / 40) {
    const PixelPoint p = picture.at((*longest)[k]);
    const double room = std::min(enough, room_at(picture, p));
    if (room <= most || !picture.is_free({p.x - half_width, p.y - 7, p.x + half_width, p.y + 7})) continue;
    most = room;
    best = p;
  }
  return best;
}

/// Lines of equal margin with their numbers; a line without room for its number is not drawn. Numbers have a white
/// background above all lines: a dash between two digits would look like a sign.
void draw_margins(MapPicture& picture, Key& key) {
  constexpr const char* style = "stroke=\"#555\" stroke-width=\"0.8\" stroke-dasharray=\"4,3\"";
  std::vector<std::pair<PixelPoint, std::string>> labels;
  for (const design::MarginLine& margin : picture.map.margin_lines) {
    const std::string text = fmt::format("{:g}", margin.margin);
    const double half = 0.5 * width_of(text) + 2;
    const auto place = label_place(picture, margin, half);
    if (!place) continue;
    for (const design::MapLine& line : margin.lines) picture.canvas.polyline(picture.line(line), style);
    picture.taken.push_back({place->x - half, place->y - 7, place->x + half, place->y + 7});
    labels.emplace_back(*place, text);
  }
  for (const auto& [place, text] : labels) {
    const double width = width_of(text) + 3;
    picture.canvas.rectangle({place.x - width / 2, place.y - 6}, width, 12,
                             "rx=\"3\" fill=\"white\" fill-opacity=\"0.85\"");
    picture.canvas.text({place.x, place.y + 4}, text, "text-anchor=\"middle\" fill=\"#333\" font-size=\"10\"");
  }
  if (!labels.empty()) key.stroke(style, "margin = limit / value, as labelled");
}

/// Paths of the two numbers, small, if the axes have other names; then the criteria, and what the picture does not
/// show.
void draw_notes(MapPicture& picture, const std::vector<std::string>& notes) {
  constexpr const char* small = "text-anchor=\"middle\" fill=\"#666\" font-size=\"9\"";
  const PlotPanel& panel = picture.panel;
  const auto path = [](const project::DesignAxis& axis) {
    return results::axis_name(axis) == axis.parameter ? "" : axis.parameter;
  };
  const double bottom = panel.corner.y + panel.height, x = panel.corner.x - y_title_distance(panel) - 18,
               y = panel.corner.y + panel.height / 2;
  picture.canvas.text({panel.corner.x + panel.width / 2, bottom + 44}, path(picture.map.request.x), small);
  picture.canvas.text({x, y}, path(picture.map.request.y),
                      fmt::format("{} transform=\"rotate(-90 {:.2f} {:.2f})\"", small, x, y));
  double at = bottom + 66;
  for (const std::string& note : notes) {
    picture.canvas.text(
        {panel.corner.x, at}, note,
        fmt::format("font-size=\"{:.1f}\" fill=\"#333\"", std::clamp(11 * 860 / width_of(note), 6.0, 11.0)));
    at += 16;
  }
}

}  // namespace

Figure map_figure(const study::DesignMap& map, const std::string& title) {
  std::vector<std::string> notes = {"Criteria: " + results::criteria_words(map) + "."};
  for (std::string& sentence : results::doubts(map)) notes.push_back(std::move(sentence));
  for (std::string& sentence : undrawn_cases(map)) notes.push_back(std::move(sentence));
  const double width = 998, height = 628 + 16 * static_cast<double>(notes.size());
  const std::string heading = title.empty() ? "Map of designs" : title;
  MapPicture picture{
      map,
      SvgCanvas(width, height),
      {map_frame.corner, map_frame.width, map_frame.height, drawn_axis(map.request.x), drawn_axis(map.request.y)}};
  picture.canvas.text({width / 2, 22}, heading, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  Key key(picture.canvas, {picture.panel.corner.x + picture.panel.width + 22, picture.panel.corner.y});
  const std::vector<MapRegion> regions = map_regions(map);
  const results::MapColours colours({&map, 1});
  draw_regions(picture, regions, heading, colours);
  explain_regions(map, regions, colours, key);
  explain_feasible(map, key);
  draw_frame(picture.canvas, picture.panel);
  const std::vector<PlacedMark> placed = placed_marks(picture);
  keep_free(picture, placed);
  draw_margins(picture, key);
  draw_marks(picture, placed, key);
  draw_notes(picture, notes);
  return {heading, "map.svg", picture.canvas.svg(heading)};
}

std::vector<Figure> map_figures(const study::CaseResults& results) {
  if (!results.map_pairs.empty()) return {map_matrix_figure(results.map_pairs, case_title("Maps of designs", results))};
  if (!results.map) return {};
  return {map_figure(*results.map, case_title("Map of designs", results))};
}

}  // namespace trivet::report
