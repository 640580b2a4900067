// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "trivet/report/map/map_figure.h"
#include "trivet/report/map/map_picture.h"
#include "trivet/report/map/map_regions.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::report {
namespace {

constexpr double matrix_left = 96, matrix_top = 62, between_x = 92, between_y = 84, key_width = 290;

/// Names in the order in which they first appear.
std::vector<std::string> distinct(const std::vector<study::DesignMap>& maps,
                                  project::DesignAxis project::MapRequest::* axis) {
  std::vector<std::string> names;
  for (const study::DesignMap& map : maps)
    if (const std::string& name = (map.request.*axis).name; std::ranges::find(names, name) == names.end())
      names.push_back(name);
  return names;
}

/// Positions and sizes of the maps.
class Layout {
 public:
  explicit Layout(const std::vector<study::DesignMap>& maps)
      : columns_(distinct(maps, &project::MapRequest::x)), rows_(distinct(maps, &project::MapRequest::y)) {
    width_ = columns_.size() <= 2 ? 290 : columns_.size() == 3 ? 230 : 180;
    height_ = 0.85 * width_;
  }

  [[nodiscard]] PlotPanel panel(const study::DesignMap& map) const {
    const auto place = [](const std::vector<std::string>& names, const std::string& name) {
      return static_cast<double>(std::ranges::find(names, name) - names.begin());
    };
    return {{matrix_left + place(columns_, map.request.x.name) * (width_ + between_x),
             matrix_top + place(rows_, map.request.y.name) * (height_ + between_y)},
            width_,
            height_,
            drawn_axis(map.request.x),
            drawn_axis(map.request.y)};
  }
  [[nodiscard]] double right() const {
    return matrix_left + static_cast<double>(columns_.size()) * (width_ + between_x) - between_x;
  }
  [[nodiscard]] double bottom() const {
    return matrix_top + static_cast<double>(rows_.size()) * (height_ + between_y) - between_y;
  }

 private:
  std::vector<std::string> columns_, rows_;
  double width_ = 0, height_ = 0;
};

/// Designs of all maps that a rule governs.
struct Governed {
  std::size_t rule = 0, designs = 0;
  bool infeasible = false, feasible = false;
};

/// All governing rules, that with most designs first; then, in its place, the designs that no rule limits.
std::vector<Governed> governed(const std::vector<study::DesignMap>& maps,
                               const std::vector<std::vector<MapRegion>>& regions) {
  std::map<std::size_t, Governed> by_rule;
  for (std::size_t k = 0; k < maps.size(); ++k)
    for (const MapRegion& region : regions[k]) {
      if (!region.known()) continue;
      Governed& rule = by_rule[region.governing];
      rule.rule = region.governing;
      rule.designs += region.designs;
      rule.infeasible = rule.infeasible || !region.infeasible.empty();
      rule.feasible = rule.feasible || !region.feasible.empty();
    }
  std::vector<Governed> list;
  for (const auto& [rule, one] : by_rule) list.push_back(one);
  std::ranges::stable_sort(list, std::ranges::greater{}, &Governed::designs);
  return list;
}

/// Share of the map that is feasible, and the best margin.
std::string caption(const study::DesignMap& map) {
  std::string text = fmt::format("{:.3g} % feasible", 100 * map.feasible.area);
  if (!map.best) return text;
  const design::DesignOutcome& best = map.outcomes[*map.best];
  return text +
      (std::isinf(best.margin) ? ", no rule limits the best"
                               : fmt::format(", {} margin {:.3g}", best.feasible() ? "best" : "nearest", best.margin));
}

void explain(const std::vector<study::DesignMap>& maps, const std::vector<Governed>& rules,
             const results::MapColours& colours, Key& key) {
  std::size_t all = 0, unknown = 0;
  for (const study::DesignMap& map : maps) all += map.outcomes.size(), unknown += map.unknown;
  const auto share = [&](std::size_t designs) {
    return fmt::format("{:.1f} % of all designs", 100.0 * static_cast<double>(designs) / static_cast<double>(all));
  };
  key.heading("Rule with the least margin");
  Governed others;
  for (const Governed& rule : rules) {
    const std::string colour = colours.of(rule.rule);
    if (colour != results::MapColours::other_rules) {
      key.region(colour, rule.infeasible, rule.feasible,
                 rule.rule == MapRegion::unlimited ? "no rule limits it: " + results::unlimited_words(maps.front())
                                                   : results::rule_words(maps.front(), maps.front().rules[rule.rule]),
                 share(rule.designs));
      continue;
    }
    others.designs += rule.designs;
    others.infeasible = others.infeasible || rule.infeasible;
    others.feasible = others.feasible || rule.feasible;
  }
  if (others.designs > 0)
    key.region(results::MapColours::other_rules, others.infeasible, others.feasible, "other rules",
               share(others.designs));
  if (unknown > 0)
    key.region(results::MapColours::not_computed, true, false, results::not_computed_words, share(unknown));
  key.heading("Feasible region");
  key.patch("fill=\"white\" stroke=\"#000\" stroke-width=\"2\"", "every rule is met (lighter)");
  key.stroke("stroke=\"#000\" stroke-width=\"2.4\"", "margin 1: value at its limit");
  key.heading("Points");
}

/// The signs that are drawn, each once.
void explain_points(const std::vector<std::vector<PlacedMark>>& placed, const std::vector<study::DesignMap>& maps,
                    SvgCanvas& canvas, Key& key) {
  for (const bool feasible : {true, false}) {
    const auto is_there = [&](const std::vector<PlacedMark>& marks) {
      return std::ranges::any_of(marks, [&](const PlacedMark& m) { return m.feasible == feasible; });
    };
    if (std::ranges::any_of(placed, is_there)) {
      draw_case_mark(canvas, key.sample(), feasible);
      key.add_text(feasible ? "given design or case, meets every rule" : "given design or case, violates a rule", "");
    }
    if (std::ranges::any_of(maps, [&](const study::DesignMap& map) {
          return map.best && map.outcomes[*map.best].feasible() == feasible;
        })) {
      draw_best(canvas, key.sample(), feasible);
      key.add_text(feasible ? "largest margin of the map" : "nearest to feasible", "");
    }
  }
}

std::vector<std::string> notes_of(const std::vector<study::DesignMap>& maps) {
  std::vector<std::string> notes = {"Criteria: " + results::criteria_words(maps.front()) + ".",
                                    "In each map all other parameters have the values of the file."};
  for (const study::DesignMap& map : maps)
    for (const std::string& doubt : results::doubts(map))
      if (std::ranges::find(notes, doubt) == notes.end()) notes.push_back(doubt);
  return notes;
}

}  // namespace

Figure map_matrix_figure(const std::vector<study::DesignMap>& maps, const std::string& title) {
  const Layout layout(maps);
  std::vector<std::vector<MapRegion>> regions;
  for (const study::DesignMap& map : maps) regions.push_back(map_regions(map));
  const std::vector<Governed> rules = governed(maps, regions);
  const results::MapColours colours(maps);
  const std::vector<std::string> notes = notes_of(maps);
  constexpr double least_height = 520;  // of a complete key
  const double width = layout.right() + key_width, notes_from = std::max(layout.bottom() + 58, least_height);
  const double height = notes_from + 16 * static_cast<double>(notes.size());
  const std::string heading = title.empty() ? "Maps of designs" : title;
  SvgCanvas canvas(width, height);
  canvas.text({width / 2, 22}, heading, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  std::vector<std::vector<PlacedMark>> placed;
  for (std::size_t k = 0; k < maps.size(); ++k) {
    MapPicture picture{maps[k], std::move(canvas), layout.panel(maps[k])};
    draw_regions(picture, regions[k], fmt::format("{} {}", heading, k + 1), colours);
    draw_frame(picture.canvas, picture.panel);
    placed.push_back(placed_marks(picture));
    for (const PlacedMark& mark : placed.back()) draw_case_mark(picture.canvas, mark.point, mark.feasible);
    draw_best_design(picture);
    picture.canvas.text({picture.panel.corner.x, picture.panel.corner.y - 7}, caption(maps[k]),
                        "font-size=\"10\" fill=\"#333\"");
    canvas = std::move(picture.canvas);
  }
  Key key(canvas, {layout.right() + 22, matrix_top});
  explain(maps, rules, colours, key);
  explain_points(placed, maps, canvas, key);
  double at = notes_from;
  for (const std::string& note : notes) {
    canvas.text({matrix_left, at}, note,
                fmt::format("font-size=\"{:.1f}\" fill=\"#333\"",
                            std::clamp(11 * (width - matrix_left) / width_of(note), 6.0, 11.0)));
    at += 16;
  }
  return {heading, "map.svg", canvas.svg(heading)};
}

}  // namespace trivet::report
