// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/plot_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/report/drawing/label_placement.h"

namespace trivet::report {
namespace {

constexpr std::array<const char*, 6> colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00"};
const std::array<std::vector<int>, 6> dashes = {{{}, {7, 3}, {2, 2}, {9, 3, 2, 3}, {5, 2}, {1, 3}}};

}  // namespace

double Axis::position(double value) const {
  return logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
}

double Axis::share(double value) const { return position(std::clamp(value, from, to)); }

std::vector<Tick> Axis::ticks(int wanted) const {
  return logarithmic ? decade_ticks(from, to) : linear_ticks(from, to, wanted);
}

PixelPoint PlotPanel::at(double x_value, double y_value) const {
  return {corner.x + x.share(x_value) * width, corner.y + (1 - y.share(y_value)) * height};
}

namespace {

constexpr int y_ticks = 5;

/// Values of short ticks: powers of ten and, if there is room, 2 … 9 times them.
std::vector<double> minor_values(const Axis& axis) {
  constexpr double most_decades = 8;
  std::vector<double> values;
  if (!axis.logarithmic) return values;
  const int last_digit = std::log10(axis.to / axis.from) > most_decades ? 1 : 9;
  for (double decade = std::pow(10.0, std::floor(std::log10(axis.from))); decade < axis.to; decade *= 10)
    for (int digit = 1; digit <= last_digit; ++digit)
      if (digit * decade > axis.from && digit * decade < axis.to) values.push_back(digit * decade);
  return values;
}

}  // namespace

double y_title_distance(const PlotPanel& p) {
  constexpr double usual = 48, of_sign = 6.2, beside = 20, at_edge = 10;
  std::size_t signs = 0;
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };  // of a character in UTF-8
  for (const Tick& tick : p.y.ticks(y_ticks))
    signs = std::max(signs, static_cast<std::size_t>(std::ranges::count_if(tick.label, begins)));
  return std::min(p.corner.x - at_edge, std::max(usual, of_sign * static_cast<double>(signs) + beside));
}

void draw_frame(SvgCanvas& canvas, const PlotPanel& p) {
  const double bottom = p.corner.y + p.height, right = p.corner.x + p.width;
  for (const Tick& tick : p.x.ticks(std::max(3, static_cast<int>(p.width / 70)))) {
    const double x = p.at(tick.value, p.y.from).x;
    canvas.line({x, p.corner.y}, {x, bottom}, "stroke=\"#e4e4e4\"");
    canvas.text({x, bottom + 16.5}, tick.label, "text-anchor=\"middle\" fill=\"#333\"");
  }
  for (const Tick& tick : p.y.ticks(y_ticks)) {
    const double y = p.at(p.x.from, tick.value).y;
    canvas.line({p.corner.x, y}, {right, y}, "stroke=\"#e4e4e4\"");
    canvas.text({p.corner.x - 6, y + 4}, tick.label, "text-anchor=\"end\" fill=\"#333\"");
  }
  for (const double value : minor_values(p.x)) {
    const double x = p.at(value, p.y.from).x;
    canvas.line({x, bottom - 4}, {x, bottom}, "stroke=\"#777\" stroke-width=\"0.8\"");
  }
  for (const double value : minor_values(p.y)) {
    const double y = p.at(p.x.from, value).y;
    canvas.line({p.corner.x, y}, {p.corner.x + 4, y}, "stroke=\"#777\" stroke-width=\"0.8\"");
  }
  canvas.rectangle(p.corner, p.width, p.height, "fill=\"none\" stroke=\"#333\"");
  canvas.text({p.corner.x + p.width / 2, bottom + 32}, p.x.label, "text-anchor=\"middle\"");
  const double x = p.corner.x - y_title_distance(p), y = p.corner.y + p.height / 2;
  constexpr double font = 11, beyond = 36;  // of the frame, where the label may be
  const double size = font * std::min(1.0, (p.height + beyond) / text_width(p.y.label, font));
  canvas.text(
      {x, y}, p.y.label,
      fmt::format("text-anchor=\"middle\" font-size=\"{:.1f}\" transform=\"rotate(-90 {:.2f} {:.2f})\"", size, x, y));
}

SeriesStyle series_style(std::size_t series) {
  return {series_colour(series), dashes[(series + series / dashes.size()) % dashes.size()]};
}

const char* series_colour(std::size_t series) { return colours[series % colours.size()]; }

std::string series_stroke(std::size_t series) {
  const SeriesStyle style = series_style(series);
  return fmt::format("stroke=\"{}\" stroke-width=\"1.6\" stroke-linejoin=\"round\"{}", style.colour,
                     style.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", fmt::join(style.dash, ",")));
}

}  // namespace trivet::report
