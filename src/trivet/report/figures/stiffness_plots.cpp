// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/stiffness_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/study/explain/element_summary.h"

namespace trivet::report {

namespace {

constexpr double cell_size = 44;
constexpr double left = 66, top = 52;  // of the cells in the map
constexpr double round_off = 5e-4;     // shown as 0

// Blue for negative, white for zero, vermilion for positive: colour-blind readers can distinguish them.
using Colour = std::array<double, 3>;
constexpr Colour negative = {0, 114, 178}, positive = {213, 94, 0};

std::string colour(double value) {
  const double strength = std::min(std::abs(value), 1.0);
  const Colour& full = value < 0 ? negative : positive;
  const auto part = [&](std::size_t i) { return static_cast<int>(std::lround(255 + strength * (full[i] - 255))); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

/// K_ij/√(K_ii K_jj); 0 if a diagonal entry is 0.
double scaled(const elements::Matrix12& k, int i, int j) {
  const double scale = std::sqrt(std::abs(k(i, i) * k(j, j)));
  return scale > 0 ? k(i, j) / scale : 0;
}

std::string number(double value) {
  if (std::abs(value) < round_off) return "0";
  return (value < 0 ? "−" : "") + fmt::format("{:.{}f}", std::abs(value), std::abs(value) < 0.0995 ? 3 : 2);
}

void draw_cells(SvgCanvas& canvas, PixelPoint corner, const elements::Matrix12& k) {
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      const double value = scaled(k, i, j);
      const PixelPoint at{corner.x + left + cell_size * j, corner.y + top + cell_size * i};
      canvas.rectangle(at, cell_size, cell_size,
                       fmt::format("fill=\"{}\" stroke=\"#ddd\" stroke-width=\"0.6\"", colour(value)));
      const char* ink = std::abs(value) < round_off ? "#999" : std::abs(value) > 0.75 ? "white" : "#111";
      canvas.text({at.x + cell_size / 2, at.y + cell_size / 2 + 4}, number(value),
                  fmt::format("text-anchor=\"middle\" fill=\"{}\"{}", ink,
                              std::abs(value) < 0.0995 ? " font-size=\"10\"" : ""));
    }
  for (int block = 0; block <= 4; ++block) {  // between the ends, and between translations and rotations
    const double offset = 3 * cell_size * block;
    const std::string style = block % 2 == 0 ? "stroke=\"#222\" stroke-width=\"1.8\""
                                             : "stroke=\"#222\" stroke-width=\"0.8\" stroke-dasharray=\"4,3\"";
    canvas.line({corner.x + left + offset, corner.y + top}, {corner.x + left + offset, corner.y + top + 12 * cell_size},
                style);
    canvas.line({corner.x + left, corner.y + top + offset}, {corner.x + left + 12 * cell_size, corner.y + top + offset},
                style);
  }
}

void draw_labels(SvgCanvas& canvas, PixelPoint corner) {
  for (int i = 0; i < 12; ++i) {
    const double middle = cell_size * (i + 0.5);
    canvas.text({corner.x + left + middle, corner.y + top - 7}, study::component_name(i), "text-anchor=\"middle\"");
    canvas.text({corner.x + left - 7, corner.y + top + middle + 4}, study::component_name(i), "text-anchor=\"end\"");
  }
  for (int end = 0; end < 2; ++end) {
    const double middle = cell_size * (6 * end + 3), x = corner.x + 16, y = corner.y + top + middle;
    const std::string name = end == 0 ? "end N" : "end K";
    canvas.text({corner.x + left + middle, corner.y + top - 26}, name, "text-anchor=\"middle\" font-weight=\"bold\"");
    canvas.text(
        {x, y}, name,
        fmt::format("text-anchor=\"middle\" font-weight=\"bold\" transform=\"rotate(-90 {:.2f} {:.2f})\"", x, y));
  }
}

void draw_diagonal(SvgCanvas& canvas, PixelPoint at, const elements::Matrix12& k) {
  canvas.text({at.x, at.y + top - 26}, "diagonal K_ii", "font-weight=\"bold\"");
  for (int i = 0; i < 12; ++i) {
    const UnitPrefix unit = unit_prefix(std::abs(k(i, i)), i % 6 < 3 ? "N/m" : "N m/rad");
    canvas.text({at.x, at.y + top + cell_size * (i + 0.5) + 4},
                fmt::format("{:.5g} {}", k(i, i) * unit.factor, unit.unit), "");
  }
}

void draw_colour_bar(SvgCanvas& canvas, PixelPoint at) {
  constexpr int steps = 40;
  constexpr double height = 320, width = 20;
  const double above = at.y + top + 6 * cell_size - height / 2;
  canvas.text({at.x, at.y + top - 26}, "K_ij / √(K_ii K_jj)", "font-weight=\"bold\"");
  for (int s = 0; s < steps; ++s)
    canvas.rectangle({at.x, above + height * s / steps}, width, height / steps + 0.5,
                     fmt::format("fill=\"{}\"", colour(1 - 2 * (s + 0.5) / steps)));
  canvas.rectangle({at.x, above}, width, height, "fill=\"none\" stroke=\"#333\"");
  for (const double value : {1.0, 0.5, 0.0, -0.5, -1.0})
    canvas.text({at.x + width + 6, above + height * (1 - value) / 2 + 4},
                (value < 0 ? "−" : "") + fmt::format("{:g}", std::abs(value)), "");
}

}  // namespace

void draw_stiffness_map(SvgCanvas& canvas, PixelPoint corner, const elements::Matrix12& stiffness) {
  draw_cells(canvas, corner, stiffness);
  draw_labels(canvas, corner);
  draw_diagonal(canvas, {corner.x + left + 12 * cell_size + 16, corner.y}, stiffness);
  draw_colour_bar(canvas, {corner.x + left + 12 * cell_size + 150, corner.y});
}

namespace {

using foundation::two_pi;

struct Times {
  double shortest, longest;
};

std::optional<Times> relaxation_times(const elements::Law& law) {
  const auto* relaxing = std::get_if<elements::Viscoelastic>(&law.damping);
  if (!relaxing) return std::nullopt;
  if (const auto* series = std::get_if<elements::GeneralizedMaxwell>(relaxing)) {
    if (series->times.empty()) return std::nullopt;
    const auto [shortest, longest] = std::ranges::minmax_element(series->times);
    return Times{*shortest, *longest};
  }
  if (const auto* zener = std::get_if<elements::Zener>(relaxing)) return Times{zener->time, zener->time};
  if (const auto* fractional = std::get_if<elements::FractionalZener>(relaxing))
    return Times{fractional->time, fractional->time};
  const double time = std::get<elements::KelvinVoigt>(*relaxing).time;
  return Times{time, time};
}

/// Frequencies at equal spacing over the decades, and close to the law's own natural frequencies on both sides.
std::vector<double> frequencies(const elements::Law& law, const assembly::Band& band) {
  constexpr int even = 500, beside = 24;
  std::vector<double> grid;
  for (int i = 0; i <= even; ++i)
    grid.push_back(band.from * std::pow(band.to / band.from, static_cast<double>(i) / even));
  if (law.inertia)
    for (const double nominal : law.inertia->angular_frequencies)
      for (int i = 0; i < beside; ++i)
        for (const double side : {-1.0, 1.0})
          grid.push_back(std::sqrt(law.scale) * nominal * (1 + side * 0.1 * std::pow(10.0, -4.0 * i / beside)));
  std::erase_if(grid, [&](double omega) { return omega < band.from || omega > band.to; });
  std::ranges::sort(grid);
  return grid;
}

struct Curves {
  std::vector<double> hertz;
  std::array<std::vector<double>, 6> magnitude;  ///< of the diagonal of end K
};

Curves curves(const elements::Law& law, const assembly::Band& band) {
  Curves result;
  for (const double omega : frequencies(law, band)) {
    try {
      const elements::Matrix12c d = elements::dynamic_stiffness(law, omega);
      result.hertz.push_back(omega / two_pi);
      for (int j = 0; j < 6; ++j) result.magnitude[j].push_back(std::abs(d(6 + j, 6 + j)));
    } catch (const foundation::NotComputable&) {  // exactly at an undamped natural frequency
    }
  }
  return result;
}

/// Axis from the minima to the peaks, except for the poles of an undamped law.
Axis magnitude_axis(const Curves& c, std::size_t first) {
  constexpr double above_median = 1e3, below_median = 1e-3;
  std::vector<double> all;
  for (std::size_t j = first; j < first + 3; ++j)
    for (const double value : c.magnitude[j])
      if (std::isfinite(value) && value > 0) all.push_back(value);
  if (all.empty()) return {1, 10, true, ""};
  std::ranges::sort(all);
  const double median = all[all.size() / 2];
  return {0.7 * std::max(all.front(), below_median * median), 1.4 * std::min(all.back(), above_median * median), true,
          ""};
}

void draw_own_frequencies(SvgCanvas& canvas, const PlotPanel& p, const elements::Law& law) {
  if (!law.inertia) return;
  for (const double nominal : law.inertia->angular_frequencies) {
    const double hertz = std::sqrt(law.scale) * nominal / two_pi;
    if (hertz < p.x.from || hertz > p.x.to) continue;
    const double x = p.at(hertz, p.y.from).x;
    canvas.line({x, p.corner.y}, {x, p.corner.y + p.height},
                "stroke=\"#888\" stroke-width=\"0.8\" stroke-dasharray=\"3,3\"");
  }
}

void draw_panel(SvgCanvas& canvas, PixelPoint corner, const elements::Law& law, const Curves& c, std::size_t first) {
  PlotPanel panel{corner, 385, 210, {c.hertz.front(), c.hertz.back(), true, "f [Hz]"}, magnitude_axis(c, first)};
  double largest = 0;
  const UnitPrefix unit = unit_prefix(std::sqrt(panel.y.from * panel.y.to), first == 0 ? "N/m" : "N m/rad");
  panel.y.from *= unit.factor;
  panel.y.to *= unit.factor;
  panel.y.label = fmt::format("|D_ii| of end K [{}], log", unit.unit);
  draw_frame(canvas, panel);
  draw_own_frequencies(canvas, panel, law);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::vector<double>& magnitude = c.magnitude[first + j];
    largest = std::ranges::max(magnitude);
    const double x = panel.corner.x + 10 + 70.0 * static_cast<double>(j), y = panel.corner.y - 8;
    canvas.line({x, y - 4}, {x + 26, y - 4}, series_stroke(j));
    canvas.text({x + 31, y}, study::component_name(static_cast<int>(first + j)), "");
    if (!(largest > 0)) continue;
    std::vector<PixelPoint> points;
    for (std::size_t i = 0; i < magnitude.size(); ++i)
      points.push_back(panel.at(c.hertz[i], magnitude[i] * unit.factor));
    canvas.polyline(points, series_stroke(j));
  }
}

}  // namespace

std::optional<assembly::Band> dynamic_band(const elements::Law& law) {
  std::optional<assembly::Band> band;
  const auto include = [&](double from, double to) {
    band = band ? assembly::Band{std::min(band->from, from), std::max(band->to, to)} : assembly::Band{from, to};
  };
  if (const auto times = relaxation_times(law)) include(0.01 / times->longest, 100 / times->shortest);
  if (law.inertia && law.inertia->angular_frequencies.size() > 0)
    include(0.03 * std::sqrt(law.scale) * law.inertia->angular_frequencies.minCoeff(),
            1.2 * std::sqrt(law.scale) * law.inertia->angular_frequencies.maxCoeff());
  if (const auto& given = law.frequency_dependence; given && std::isfinite(given->to))
    band = assembly::Band{std::max(given->from, 1e-3 * given->to), given->to};
  if (band && !(band->to > band->from)) return std::nullopt;
  return band;
}

void draw_dynamic_stiffness(SvgCanvas& canvas, PixelPoint corner, const elements::Law& law,
                            const assembly::Band& band) {
  const Curves c = curves(law, band);
  if (c.hertz.size() < 2) return;
  const bool own = law.inertia && law.inertia->angular_frequencies.size() > 0;
  canvas.text({corner.x + 490, corner.y + 22},
              std::string("Dynamic stiffness of end K, N held") +
                  (own ? "; dotted: own natural frequencies, both ends held" : ""),
              "text-anchor=\"middle\" font-size=\"13\" font-weight=\"bold\"");
  draw_panel(canvas, {corner.x + 86, corner.y + 62}, law, c, 0);
  draw_panel(canvas, {corner.x + 571, corner.y + 62}, law, c, 3);
}

}  // namespace trivet::report
