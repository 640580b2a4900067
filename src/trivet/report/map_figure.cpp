// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "trivet/report/answer_figures.h"
#include "trivet/report/map_regions.h"
#include "trivet/report/map_words.h"
#include "trivet/report/plot_panel.h"
#include "trivet/study/axis_words.h"

namespace trivet::report {
namespace {

constexpr const char* halo = "paint-order=\"stroke\" stroke=\"white\" stroke-width=\"3.5\" stroke-linejoin=\"round\"";
// Okabe and Ito's colours mixed with white: neighbours in this order differ in lightness too.
constexpr std::array<const char*, 7> colours = {"#f2bd66", "#8cc8ee", "#e08a66", "#66c4ab", "#dba6c6", "#f5ec8e", "#7aa9cf"};
constexpr const char* other_colour = "#d8d8d8";
constexpr const char* unknown_colour = "#8f8f8f";
constexpr double letter = 6.1;  // width of a sign of 11 pixels, about

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] bool meets(const Box& o) const { return left < o.right && o.left < right && top < o.bottom && o.top < bottom; }
};

/// Signs of a UTF-8 text.
double width_of(const std::string& text) {
  return letter * static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

struct MapPicture {
  const study::DesignMap& map;
  SvgCanvas canvas;
  PlotPanel panel;
  std::vector<Box> taken = {};

  [[nodiscard]] PixelPoint at(const study::MapPlace& p) const { return {panel.corner.x + p.x * panel.width, panel.corner.y + (1 - p.y) * panel.height}; }
  [[nodiscard]] std::vector<PixelPoint> line(const study::MapLine& places) const {
    std::vector<PixelPoint> points;
    for (const study::MapPlace& p : places) points.push_back(at(p));
    return points;
  }
  [[nodiscard]] std::vector<std::vector<PixelPoint>> rings(const std::vector<study::MapLine>& lines) const {
    std::vector<std::vector<PixelPoint>> all;
    for (const study::MapLine& ring : lines) all.push_back(line(ring));
    return all;
  }
  [[nodiscard]] bool inside(const Box& b) const {
    return b.left >= panel.corner.x + 2 && b.right <= panel.corner.x + panel.width - 2 && b.top >= panel.corner.y + 2 && b.bottom <= panel.corner.y + panel.height - 2;
  }
  [[nodiscard]] bool is_free(const Box& b) const {
    return inside(b) && std::none_of(taken.begin(), taken.end(), [&](const Box& t) { return t.meets(b); });
  }
};

/// A sample and its words in the key right of the panel.
class Key {
 public:
  Key(SvgCanvas& canvas, PixelPoint at) : canvas_(canvas), at_(at) {}
  void heading(const std::string& text) {
    at_.y += 8;
    canvas_.text({at_.x, at_.y}, text, "font-weight=\"bold\"");
    at_.y += 18;
  }
  void patch(const std::string& style, const std::string& text, const std::string& second = "") {
    canvas_.rectangle({at_.x, at_.y - 9}, 22, 13, style);
    words(text, second);
  }
  void stroke(const std::string& style, const std::string& text) {
    canvas_.line({at_.x, at_.y - 3}, {at_.x + 22, at_.y - 3}, style);
    words(text, "");
  }
  [[nodiscard]] PixelPoint sample() const { return {at_.x + 11, at_.y - 3}; }
  void words(const std::string& text, const std::string& second) {
    const double size = std::clamp(11 * 225 / width_of(text), 7.0, 11.0);
    canvas_.text({at_.x + 30, at_.y + 1}, text, fmt::format("font-size=\"{:.1f}\"", size));
    if (!second.empty()) canvas_.text({at_.x + 30, at_.y + 14}, second, "fill=\"#555\" font-size=\"10\"");
    at_.y += second.empty() ? 18 : 32;
  }

 private:
  SvgCanvas& canvas_;
  PixelPoint at_;
};

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

void draw_mark(SvgCanvas& canvas, PixelPoint p, bool kept) {
  canvas.circle(p, 4.5, kept ? "fill=\"black\" stroke=\"white\" stroke-width=\"1.5\"" : "fill=\"white\" stroke=\"black\" stroke-width=\"1.6\"");
  if (kept) return;
  canvas.line({p.x - 2, p.y - 2}, {p.x + 2, p.y + 2}, "stroke=\"black\" stroke-width=\"1.3\"");
  canvas.line({p.x - 2, p.y + 2}, {p.x + 2, p.y - 2}, "stroke=\"black\" stroke-width=\"1.3\"");
}

/// Full where it keeps every rule.
void draw_best(SvgCanvas& canvas, PixelPoint p, bool kept) {
  canvas.area({{{p.x, p.y - 7}, {p.x + 6, p.y}, {p.x, p.y + 7}, {p.x - 6, p.y}}},
              kept ? "fill=\"#0072B2\" stroke=\"white\" stroke-width=\"1.2\"" : "fill=\"white\" stroke=\"#0072B2\" stroke-width=\"2\"");
}

/// Does a line of margin 1 run through a box?
bool meets_boundary(const MapPicture& picture, const Box& box) {
  constexpr double step = 3;  // pixels, less than a letter is high
  for (const study::MapLine& line : picture.map.feasible.lines)
    for (std::size_t k = 1; k < line.size(); ++k) {
      const PixelPoint a = picture.at(line[k - 1]), b = picture.at(line[k]);
      const int pieces = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / step);
      for (int i = 0; i <= pieces; ++i) {
        const double x = a.x + (b.x - a.x) * i / pieces, y = a.y + (b.y - a.y) * i / pieces;
        if (x > box.left && x < box.right && y > box.top && y < box.bottom) return true;
      }
    }
  return false;
}

/// Beside the point where it covers nothing, else farther off with a leader. Was there room?
bool is_placed(MapPicture& picture, PixelPoint p, const std::string& text, bool on_boundary) {
  const double width = width_of(text);
  for (const double distance : {9.0, 20.0, 34.0, 50.0, 70.0})
    for (const auto& [dx, dy] : {std::pair{1.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, -0.8}, {-0.8, 0.8}}) {
      const double left = p.x + dx * distance - (dx < 0 ? width : dx == 0 ? width / 2 : 0), base = p.y + 4 + dy * (distance + 4);
      const Box box{left - 2, base - 11, left + width + 2, base + 3};
      if (!picture.is_free(box) || (!on_boundary && meets_boundary(picture, box))) continue;
      picture.taken.push_back(box);
      if (distance > 9) picture.canvas.line({p.x + 5 * dx, p.y + 5 * dy}, {std::clamp(p.x + dx * distance, left, left + width), base - 4 + (dy < 0 ? 5 : dy > 0 ? -5 : 0)}, "stroke=\"#333\" stroke-width=\"0.8\"");
      picture.canvas.text({left, base}, text, halo);
      return true;
    }
  return false;
}

/// On a line of margin 1 only where there is no other room.
void place_label(MapPicture& picture, PixelPoint p, const std::string& text) {
  if (!is_placed(picture, p, text, false)) static_cast<void>(is_placed(picture, p, text, true));
}

struct PlacedMark {
  PixelPoint point;
  std::string names;
  bool kept = false;
};

/// Cases of this model inside the frame; those in one place share a label.
std::vector<PlacedMark> placed_marks(const MapPicture& picture) {
  std::vector<PlacedMark> placed;
  for (const study::MapMark& mark : picture.map.marks) {
    if (!is_drawn(picture.map, mark)) continue;
    const PixelPoint p = picture.at({picture.map.request.x.share(*mark.x), picture.map.request.y.share(*mark.y)});
    const std::string name = mark.name.empty() ? "base" : mark.name;
    const auto same = std::find_if(placed.begin(), placed.end(), [&](const PlacedMark& m) { return std::hypot(m.point.x - p.x, m.point.y - p.y) < 1; });
    if (same == placed.end()) placed.push_back({p, name, mark.judged->governing.kept()});
    else same->names += ", " + name;
  }
  return placed;
}

/// Sample and words of the best design, or of the nearest where none keeps every rule.
void explain_best(const MapPicture& picture, SvgCanvas& canvas, Key& key) {
  const study::DesignMap& map = picture.map;
  const study::DesignOutcome& best = map.outcomes[*map.best];
  const study::DesignPoint p = map.point(*map.best);
  draw_best(canvas, key.sample(), best.kept());
  const std::string where = fmt::format("{}, {}", study::axis_value(p.x, map.request.x), study::axis_value(p.y, map.request.y));
  if (std::isinf(best.margin)) key.words("midst of the designs without bound", where);
  else key.words(fmt::format("{} {:.3g}", best.kept() ? "largest margin:" : "nearest design: margin", best.margin), where);
}

PixelPoint best_point(const MapPicture& picture) {
  const auto nx = static_cast<std::size_t>(picture.map.grid.nx);
  return picture.at(picture.map.grid.place(static_cast<int>(*picture.map.best % nx), static_cast<int>(*picture.map.best / nx)));
}

/// Nothing is written over the points.
void keep_free(MapPicture& picture, const std::vector<PlacedMark>& placed) {
  const auto around = [&](PixelPoint p, double room) { picture.taken.push_back({p.x - room, p.y - room, p.x + room, p.y + room}); };
  for (const PlacedMark& mark : placed) around(mark.point, 6);
  if (picture.map.best) around(best_point(picture), 8);
}

void draw_marks(MapPicture& picture, const std::vector<PlacedMark>& placed, Key& key) {
  if (picture.map.best) draw_best(picture.canvas, best_point(picture), picture.map.outcomes[*picture.map.best].kept());
  for (const PlacedMark& mark : placed) {
    draw_mark(picture.canvas, mark.point, mark.kept);
    place_label(picture, mark.point, mark.names);
  }
  if (placed.empty() && !picture.map.best) return;
  key.heading("Points");
  for (const bool kept : {true, false}) {
    if (std::none_of(placed.begin(), placed.end(), [&](const PlacedMark& m) { return m.kept == kept; })) continue;
    draw_mark(picture.canvas, key.sample(), kept);
    key.words(kept ? "case that keeps every rule" : "case that breaks a rule", "");
  }
  if (picture.map.best) explain_best(picture, picture.canvas, key);
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
