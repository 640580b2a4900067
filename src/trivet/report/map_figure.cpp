// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "trivet/report/answer_figures.h"
#include "trivet/report/map_picture.h"
#include "trivet/report/map_points.h"
#include "trivet/report/map_regions.h"
#include "trivet/report/map_words.h"

namespace trivet::report {
namespace {

// Okabe and Ito's colours mixed with white: neighbours in this order differ in lightness too.
constexpr std::array<const char*, 7> colours = {"#f2bd66", "#8cc8ee", "#e08a66", "#66c4ab", "#dba6c6", "#f5ec8e", "#7aa9cf"};
constexpr const char* other_colour = "#d8d8d8";
constexpr const char* unknown_colour = "#8f8f8f";
void draw_regions(MapPicture& picture, Key& key) {
  const std::vector<MapRegion> regions = map_regions(picture.map);
  const auto share = [&](std::size_t designs) { return 100.0 * static_cast<double>(designs) / static_cast<double>(picture.map.outcomes.size()); };
  key.heading("Rule with the least margin");
  std::size_t next = 0, others = 0;
  for (const MapRegion& region : regions) {
    const bool free = region.governing == MapRegion::unlimited, known = free || region.governing < study::DesignOutcome::not_computed, other = known && next >= colours.size();
    const char* colour = !known ? unknown_colour : other ? other_colour : colours[next];
    picture.canvas.area(picture.rings(region.rings), fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.7\"", colour));
    if (other) others += region.designs;
    else if (known) key.patch(fmt::format("fill=\"{}\" stroke=\"#777\"", colour), free ? "no rule limits it: no peak" : picture.map.rules[region.governing].words, fmt::format("{:.1f} % of the designs", share(region.designs))), ++next;
  }
  if (others > 0) key.patch(fmt::format("fill=\"{}\" stroke=\"#777\"", other_colour), "other rules", fmt::format("{:.1f} % of the designs", share(others)));
  if (picture.map.unknown > 0) key.patch(fmt::format("fill=\"{}\" stroke=\"#777\"", unknown_colour), "no answer: no real body, or no model", fmt::format("{:.1f} % of the designs", share(picture.map.unknown)));
}

void draw_feasible(MapPicture& picture, Key& key) {
  const study::MapContours& feasible = picture.map.feasible;
  picture.canvas.area(picture.rings(feasible.rings), "fill=\"white\" fill-opacity=\"0.72\" stroke=\"none\"");
  for (const study::MapLine& line : feasible.lines) picture.canvas.polyline(picture.line(line), "stroke=\"#000\" stroke-width=\"2.4\" stroke-linejoin=\"round\"");
  key.heading("Feasible region");
  if (feasible.rings.empty()) return key.words("no design of this map keeps every rule", "");
  key.patch("fill=\"white\" stroke=\"#000\" stroke-width=\"2\"", "every rule is kept (lighter)", fmt::format("{} of {} designs", picture.map.kept, picture.map.outcomes.size()));
  key.stroke("stroke=\"#000\" stroke-width=\"2.4\"", "margin 1: value at its limit");
}

/// Pixels from a point to the nearest of some lines' points, or to the frame.
double room_at(const MapPicture& picture, PixelPoint p) {
  const PlotPanel& panel = picture.panel;
  double room = std::min(std::min(p.x - panel.corner.x, panel.corner.x + panel.width - p.x), std::min(p.y - panel.corner.y, panel.corner.y + panel.height - p.y));
  for (const study::MapLine& line : picture.map.feasible.lines)
    for (const study::MapPlace& place : line) room = std::min(room, std::hypot(picture.at(place).x - p.x, picture.at(place).y - p.y));
  return room;
}

/// On the longest piece of a line, far from the boundary, where nothing else stands.
std::optional<PixelPoint> label_place(const MapPicture& picture, const study::MarginLine& margin, double half_width) {
  constexpr double least = 10, enough = 45;  // pixels of room
  const auto longest = std::max_element(margin.lines.begin(), margin.lines.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
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

/// Lines of equal margin with their numbers; a line without room for its number would say nothing.
void draw_margins(MapPicture& picture, Key& key) {
  constexpr const char* style = "stroke=\"#555\" stroke-width=\"0.8\" stroke-dasharray=\"4,3\"";
  bool any = false;
  for (const study::MarginLine& margin : picture.map.margin_lines) {
    const std::string text = fmt::format("{:g}", margin.margin);
    const double half = 0.5 * width_of(text) + 2;
    const auto place = label_place(picture, margin, half);
    if (!place) continue;
    any = true;
    for (const study::MapLine& line : margin.lines) picture.canvas.polyline(picture.line(line), style);
    picture.taken.push_back({place->x - half, place->y - 7, place->x + half, place->y + 7});
    picture.canvas.text({place->x, place->y + 4}, text, fmt::format("text-anchor=\"middle\" fill=\"#333\" font-size=\"10\" {}", halo));
  }
  if (any) key.stroke(style, "margin = limit / value, as written");
}

/// Paths of the two numbers, small, where the axes are called otherwise; and what the picture does not show.
void draw_notes(MapPicture& picture, const std::vector<std::string>& notes) {
  constexpr const char* small = "text-anchor=\"middle\" fill=\"#666\" font-size=\"9\"";
  const PlotPanel& panel = picture.panel;
  const auto path = [](const study::MapAxis& axis) { return axis_name(axis) == axis.parameter ? "" : axis.parameter; };
  const double bottom = panel.corner.y + panel.height, x = panel.corner.x - 66, y = panel.corner.y + panel.height / 2;
  picture.canvas.text({panel.corner.x + panel.width / 2, bottom + 44}, path(picture.map.request.x), small);
  picture.canvas.text({x, y}, path(picture.map.request.y), fmt::format("{} transform=\"rotate(-90 {:.2f} {:.2f})\"", small, x, y));
  double at = bottom + 66;
  for (const std::string& note : notes) {
    picture.canvas.text({panel.corner.x, at}, note, fmt::format("font-size=\"{:.1f}\" fill=\"#333\"", std::clamp(11 * 860 / width_of(note), 6.0, 11.0)));
    at += 16;
  }
}

}  // namespace

Figure map_figure(const study::DesignMap& map, const std::string& title) {
  std::vector<std::string> notes = doubts(map);
  for (std::string& sentence : undrawn_cases(map)) notes.push_back(std::move(sentence));
  const double width = 990, height = 628 + 16 * static_cast<double>(notes.size());
  const std::string heading = title.empty() ? "Map of designs" : title;
  MapPicture picture{map,
                     SvgCanvas(width, height),
                     {{88, 44},
                      590,
                      520,
                      drawn_axis(map.request.x),
                      drawn_axis(map.request.y)}};
  picture.canvas.text({width / 2, 22}, heading, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  Key key(picture.canvas, {picture.panel.corner.x + picture.panel.width + 22, picture.panel.corner.y});
  draw_regions(picture, key);
  draw_feasible(picture, key);
  draw_frame(picture.canvas, picture.panel);
  const std::vector<PlacedMark> placed = placed_marks(picture);
  keep_free(picture, placed);
  draw_margins(picture, key);
  draw_marks(picture, placed, key);
  draw_notes(picture, notes);
  return {heading, "map.svg", picture.canvas.svg(heading)};
}

std::vector<Figure> map_figures(const study::Answers& answers) {
  if (!answers.map) return {};
  return {map_figure(*answers.map, case_title("Map of designs", answers))};
}

}  // namespace trivet::report
