// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/share_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "trivet/report/drawing/plot_panel.h"
#include "trivet/results/design/sample_words.h"
#include "trivet/results/design/share_parts.h"
#include "trivet/results/design/verdict_words.h"

namespace trivet::report {
namespace {

using numerics::ConfidenceInterval;
using study::RequirementShares;

constexpr double shares_width = 980, bars_left = 250, bars_width = 470, to_words = 12, head = 62;
constexpr double share_row_height = 34, share_bar_height = 9, to_first = 5, to_total = 18, above_panel = 26,
                 below_panel = 40;
constexpr std::size_t most_rows = 12;
constexpr const char *alone = "#0072B2", *together = "#74b3d8";

/// A bar with its interval, or the hollow interval of a share that may be 0.
void draw_bar(SvgCanvas& canvas, const PlotPanel& panel, double top, const ConfidenceInterval& share,
              const char* colour) {
  const auto x = [&](double value) { return panel.corner.x + panel.width * panel.x.share(value); };
  const double zero = x(0), from = x(share.from), to = x(share.to), middle = top + share_bar_height / 2;
  if (share.from <= 0) {
    canvas.rectangle({zero, top + 1}, std::max(to - zero, 1.0), share_bar_height - 2,
                     fmt::format("fill=\"none\" stroke=\"{}\" stroke-dasharray=\"3,2\"", colour));
  } else {
    canvas.rectangle({zero, top}, std::max(x(share.estimate) - zero, 1.0), share_bar_height,
                     fmt::format("fill=\"{}\"", colour));
    canvas.line({from, middle}, {to, middle}, "stroke=\"#000\"");
    for (const double end : {from, to}) canvas.line({end, middle - 3}, {end, middle + 3}, "stroke=\"#000\"");
  }
  canvas.text({panel.corner.x + panel.width + to_words, middle + 4}, results::share_words(share),
              share.from <= 0 ? "fill=\"#555\"" : "");
}

void draw_drawn_number(SvgCanvas& canvas, double top, const study::DrawnName& name) {
  const double x = bars_left - 12, room = bars_left - 20;
  canvas.text({x, top + (name.which.empty() ? 20 : 14)}, fitting(name.tolerance, room, 12),
              "text-anchor=\"end\" font-size=\"12\"");
  if (!name.which.empty())
    canvas.text({x, top + 27}, fitting(name.which, room, 10), "text-anchor=\"end\" font-size=\"10\" fill=\"#555\"");
}

/// "and 8 more, with others ≤ 0.5 % each": the numbers that are not drawn.
std::string rest_words(const RequirementShares& of, const std::vector<std::size_t>& order) {
  double largest = 0;
  for (std::size_t r = most_rows; r < order.size(); ++r) largest = std::max(largest, of.sets[order[r]].total.to);
  return fmt::format("and {} more, with others ≤ {} % each", order.size() - most_rows,
                     results::rounded_percent(largest, results::decimals_of(largest), results::Rounded::up));
}

struct SharePanel {
  const study::SampledCaseResult& in;
  const RequirementShares& of;
  const std::vector<std::size_t> order = results::by_total_share(of);

  [[nodiscard]] std::size_t rows() const { return std::min(order.size(), most_rows); }
  [[nodiscard]] bool has_rest() const { return order.size() > most_rows; }
  [[nodiscard]] double height() const { return share_row_height * static_cast<double>(rows()) + (has_rest() ? 20 : 0); }

  void draw(SvgCanvas& canvas, double top, const std::vector<study::DrawnSet>& sets,
            const project::DisplayUnits& display) const {
    double largest = 1;
    for (const numerics::VarianceShare& one : of.sets) largest = std::max({largest, one.first.to, one.total.to});
    constexpr double most = 1.2;
    const PlotPanel panel{
        {bars_left, top + above_panel}, bars_width, height(), {0, std::min(largest, most), false, ""}, {}};
    const std::string value = results::requirement_words(in.requirements[of.requirement].given, display) +
        results::in_case_words(in.case_name);
    canvas.text({bars_left, top + 17}, value, "font-weight=\"bold\" font-size=\"12\"");
    for (const Tick& tick : panel.x.ticks(6)) {
      const double x = panel.corner.x + panel.width * panel.x.share(tick.value), end = panel.corner.y + panel.height;
      canvas.line({x, panel.corner.y}, {x, end}, "stroke=\"#ddd\"");
      canvas.text({x, end + 15}, fmt::format("{:.4g} %", 100 * tick.value), "text-anchor=\"middle\"");
    }
    canvas.rectangle(panel.corner, panel.width, panel.height, "fill=\"none\" stroke=\"#333\"");
    for (std::size_t r = 0; r < rows(); ++r) {
      const double row = panel.corner.y + share_row_height * static_cast<double>(r);
      draw_drawn_number(canvas, row, sets[order[r]].name);
      draw_bar(canvas, panel, row + to_first, of.sets[order[r]].first, alone);
      draw_bar(canvas, panel, row + to_total, of.sets[order[r]].total, together);
    }
    if (has_rest())
      canvas.text({bars_left + 8, panel.corner.y + panel.height - 7}, rest_words(of, order), "fill=\"#555\"");
  }
};

void draw_key_of_bars(SvgCanvas& canvas) {
  double x = bars_left;
  const auto entry = [&](const std::string& style, const std::string& words, double width) {
    canvas.rectangle({x, 38}, 22, share_bar_height, style);
    canvas.text({x + 28, 47}, words, "");
    x += width;
  };
  entry(fmt::format("fill=\"{}\"", alone), "alone", 80);
  entry(fmt::format("fill=\"{}\"", together), "with all others", 126);
  entry(fmt::format("fill=\"none\" stroke=\"{}\" stroke-dasharray=\"3,2\"", alone), "cannot be told from 0", 160);
  canvas.line({x, 42.5}, {x + 22, 42.5}, "stroke=\"#000\"");
  for (const double end : {x, x + 22}) canvas.line({end, 39.5}, {end, 45.5}, "stroke=\"#000\"");
  canvas.text({x + 28, 47}, results::confidence_words() + " interval", "");
}

}  // namespace

std::optional<Figure> share_figure(const study::Sample& sample, const std::optional<project::DisplayUnits>& display) {
  if (!sample.shares) return std::nullopt;
  std::vector<SharePanel> panels;
  double height = head;
  for (const RequirementShares& of : sample.shares->list)
    if (!of.sets.empty()) {
      panels.push_back({sample.cases[of.in_case], of});
      height += above_panel + panels.back().height() + below_panel;
    }
  if (panels.empty()) return std::nullopt;
  SvgCanvas canvas(shares_width, height);
  const std::string title = "Which tolerance scatters which value: shares of the variance";
  canvas.text({shares_width / 2, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  draw_key_of_bars(canvas);
  double top = head;
  for (const SharePanel& panel : panels) {
    if (top > head) canvas.permit_break(top);
    panel.draw(canvas, top, sample.shares->sets, display.value_or(panel.in.display));
    top += above_panel + panel.height() + below_panel;
  }
  Figure figure{title, "shares.svg", canvas.svg(title)};
  if (panels.size() > 1) figure.strips = canvas.strips(title);
  return figure;
}

}  // namespace trivet::report
