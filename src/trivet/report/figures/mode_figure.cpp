// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/label_placement.h"
#include "trivet/report/drawing/moved_machine.h"
#include "trivet/report/drawing/result_figures.h"

/// Modes drawn on the outline of the machine, one small picture each.
namespace trivet::report {
namespace {

/// The first lines of a text, each at most `width` long [pixels]; "…" if there are more.
std::vector<std::string> first_lines(const std::string& text, double width, std::size_t most) {
  constexpr double font_size = 11;
  std::vector<std::string> lines = {""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || text_width(longer, font_size) <= width) {
      lines.back() = longer;
    } else if (lines.size() == most) {
      lines.back() += " …";
      break;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

Figure mode_figure(const MovedPicture& picture, const modal::Mode& mode, const project::Case& variant,
                   const study::CaseResults& results) {
  const std::string frequency =
      fmt::format("{:.4g} {}", results::shown_frequency(results.display, *mode.angular_frequency),
                  results::frequency_unit(results.display));
  const MachineMotion motion = motion_of(mode, variant.system);
  const DrawnExcursion excursion = drawn_excursion(picture.machine(), motion);
  const std::size_t view = excursion.best_view();
  constexpr double width = quarter_figure_width, tallest = 150, edge = 6, above = 22, line_height = 14;
  constexpr std::size_t most_lines = 2;
  const double bottom = above + picture.height(width - 2 * edge, tallest);
  const double height = bottom + most_lines * line_height + edge;
  SvgCanvas canvas(width, height);
  canvas.rectangle({0.5, 0.5}, width - 1, height - 1, "fill=\"none\" stroke=\"#ccc\"");
  picture.draw(canvas, {edge, above, width - edge, bottom}, view, motion, picture.enlargement(excursion.largest));
  canvas.text({width - edge, 15}, four_views()[view].name, "text-anchor=\"end\" fill=\"#595959\"");
  canvas.text({edge, 15}, fmt::format("{}: {}", mode.number, frequency), "font-weight=\"bold\"");
  double line = bottom;
  for (const std::string& words : first_lines(mode.name, width - 2 * edge, most_lines))
    canvas.text({edge, line += line_height}, words, "fill=\"#333\"");
  const std::string title = case_title(fmt::format("Mode {}, {}: {}", mode.number, frequency, mode.name), results);
  return {.title = title,
          .file_name = fmt::format("mode-{}.svg", file_part(frequency)),
          .svg = canvas.svg(title),
          .in_row = 4};
}

}  // namespace

std::vector<Figure> mode_figures(const project::Case& variant, const study::CaseResults& results) {
  constexpr std::size_t most = 8;
  std::vector<Figure> figures;
  if (!variant.analyses.modes || variant.system.bodies().empty()) return figures;
  const MovedPicture picture(variant);
  for (const modal::Mode& mode : results.modes.list)
    if (mode.angular_frequency.value_or(0) > 0 && figures.size() < most)
      figures.push_back(mode_figure(picture, mode, variant, results));
  return figures;
}

}  // namespace trivet::report
