// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/box_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "trivet/report/drawing/plot_panel.h"
#include "trivet/results/design/box_document.h"

namespace trivet::report {
namespace {

constexpr double box_width = 960, box_left = 210, box_right = 30, box_top = 56, box_below = 64, row_height = 64;
constexpr double bar_height = 16;

/// How far the picture reaches to both sides: a single far end does not squeeze the others.
struct Reach {
  double lower = 1, upper = 1;

  explicit Reach(const study::SolutionBox& box) {
    std::vector<double> ends;
    for (const study::BoxRange& one : box.ranges) ends.insert(ends.end(), {one.lower.times, one.upper.times});
    const auto middle = ends.begin() + (std::ssize(ends) - 1) / 2;  // of two the lesser one
    std::ranges::nth_element(ends, middle);
    const double far = 4 * std::max(1.0, *middle);
    for (const study::BoxRange& one : box.ranges) {
      lower = std::max(lower, std::min(one.lower.times, far));
      upper = std::max(upper, std::min(one.upper.times, far));
    }
  }

  [[nodiscard]] bool is_exceeded(const study::BoxRange& one) const {
    return one.lower.times > lower || one.upper.times > upper;
  }
};

struct BoxRow {
  const study::SolutionBox& box;
  const study::BoxRange& range;
  const PlotPanel& panel;
  const Reach& reach;
  double middle;  ///< [pixels]

  void draw(SvgCanvas& canvas) const {
    const double from = panel.at(-std::min(range.lower.times, reach.lower), 0).x,
                 to = panel.at(std::min(range.upper.times, reach.upper), 0).x;
    const double zero = panel.at(0, 0).x, left = panel.at(-1, 0).x, right = panel.at(1, 0).x;
    canvas.rectangle({from, middle - bar_height / 2}, std::max(to - from, 1.0), bar_height,
                     fmt::format("fill=\"{}\" fill-opacity=\"0.55\"", series_colour(0)));
    if (range.lower.times > reach.lower) draw_tip(canvas, from, -1);
    if (range.upper.times > reach.upper) draw_tip(canvas, to, 1);
    for (const double x : {left, right})
      canvas.line({x, middle - bar_height / 2 - 3}, {x, middle + bar_height / 2 + 3},
                  "stroke=\"#333\" stroke-width=\"1.2\"");
    canvas.line({zero, middle - bar_height / 2 - 3}, {zero, middle + bar_height / 2 + 3},
                "stroke=\"#333\" stroke-width=\"2\"");
    draw_end(canvas, range.lower, false);
    draw_end(canvas, range.upper, true);
    draw_name(canvas);
  }

 private:
  /// The tip of an arrow: the range goes on beyond the picture.
  void draw_tip(SvgCanvas& canvas, double x, double direction) const {
    canvas.area({{{x, middle - bar_height / 2 - 3}, {x + 14 * direction, middle}, {x, middle + bar_height / 2 + 3}}},
                fmt::format("fill=\"{}\"", series_colour(0)));
  }

  /// Below the bar, from the edges of the panel inward: labels at the ends themselves would cross the line of the
  /// number where an end is near it.
  void draw_end(SvgCanvas& canvas, const study::BoxEnd& end, bool upper) const {
    const bool is_open = end.stop == study::BoxStop::most || end.stop == study::BoxStop::not_determined;
    const std::string open = is_open ? (upper ? "≥ " : "≤ ") : "";
    const std::string words = open + results::box_end_words(range, end) + ": " + results::box_stop_words(box, end);
    canvas.text({upper ? panel.corner.x + panel.width - 4 : panel.corner.x + 4, middle + bar_height / 2 + 16},
                fitting(words, panel.width / 2 - 12, 10),
                fmt::format("font-size=\"10\" text-anchor=\"{}\"", upper ? "end" : "start"));
  }

  void draw_name(SvgCanvas& canvas) const {
    const double x = panel.corner.x - 12;
    canvas.text({x, middle - 1}, fitting(range.name, box_left - 24, 12),
                "text-anchor=\"end\" font-weight=\"bold\" font-size=\"12\"");
    const study::BoxNumber& first = range.numbers.front();
    std::string words = results::box_number_words(first, first.given);
    if (range.numbers.size() > 1) words += fmt::format(" and {} more", range.numbers.size() - 1);
    canvas.text({x, middle + 14}, fitting(words, box_left - 24, 11),
                "text-anchor=\"end\" font-size=\"11\" fill=\"#555\"");
  }
};

}  // namespace

Figure box_figure(const study::SolutionBox& box, const std::string& title) {
  const Reach reach(box);
  const bool any_beyond = std::ranges::any_of(box.ranges, [&](const auto& one) { return reach.is_exceeded(one); });
  const double height = row_height * static_cast<double>(box.ranges.size());
  constexpr double air = 1.12;
  const PlotPanel panel{{box_left, box_top},
                        box_width - box_left - box_right,
                        height,
                        {-air * reach.lower, air * reach.upper, false, "deviation over the tolerance of the file"},
                        {0, 1, false, ""}};
  SvgCanvas canvas(box_width, box_top + height + box_below);
  canvas.text({box_width / 2, 24}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  canvas.text({box_width / 2, 42}, "Ranges in which every requirement is met, and what stops their ends",
              "text-anchor=\"middle\" font-size=\"11\" fill=\"#555\"");
  for (const Tick& tick : panel.x.ticks(8)) {
    const double x = panel.at(tick.value, 0).x;
    canvas.line({x, box_top}, {x, box_top + height}, "stroke=\"#ddd\"");
    canvas.text({x, box_top + height + 16}, tick.label, "text-anchor=\"middle\" font-size=\"11\"");
  }
  canvas.rectangle(panel.corner, panel.width, height, "fill=\"none\" stroke=\"#333\"");
  canvas.text({box_left + panel.width / 2, box_top + height + 36}, panel.x.label, "text-anchor=\"middle\"");
  canvas.text({box_left + panel.width / 2, box_top + height + 54},
              std::string("thick line: number in the file; thin lines: its tolerance") +
                  (any_beyond ? "; arrow: the range goes on beyond the picture" : ""),
              "text-anchor=\"middle\" font-size=\"10\" fill=\"#555\"");
  double middle = box_top + row_height / 2 - 6;
  for (const study::BoxRange& one : box.ranges) {
    BoxRow{box, one, panel, reach, middle}.draw(canvas);
    middle += row_height;
  }
  return {title, "box.svg", canvas.svg("ranges of the tolerances in which every requirement is met")};
}

}  // namespace trivet::report
