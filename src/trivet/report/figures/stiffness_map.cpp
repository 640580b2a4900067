// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/stiffness_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/report/drawing/axis_ticks.h"
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

}  // namespace trivet::report
