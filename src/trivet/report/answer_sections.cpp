// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/answer_sections.h"

#include <fmt/format.h>

#include "trivet/report/answer_figures.h"
#include "trivet/report/answer_tables.h"
#include "trivet/report/html_table.h"
#include "trivet/report/svg_canvas.h"

namespace trivet::report {
namespace {

/// Tables and figures below each other.
std::string shown(std::string html, const std::vector<Figure>& figures) {
  for (const Figure& figure : figures)
    html += "<figure><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(figure.title) +
        "\">" + figure.html() + "</div></figure>\n";
  return html;
}

/// Title, tables and figures of an answer, or of several that belong together.
struct Shown {
  const char* title;
  std::string (*tables)(const study::Answers& answers);
  std::vector<std::vector<Figure> (*)(const study::Answers& answers)> figures;
};

/// Tables and figures in addition to the harmonic characteristics, in the order of the page. Add new ones here.
const std::vector<Shown>& all_shown() {
  static const std::vector<Shown> list = {
      {"Map of designs", map_tables, {map_figures}},
      {"Best design", optimum_tables, {}},
      {"Front", front_tables, {front_figures}},
      {"Random response", random_table, {random_figures}},
      {"Time history", transient_table, {transient_figures}},
      {"Run-up", run_up_tables, {campbell_figures, waterfall_figures, run_up_figures}},
      {"Transmissibility", transmissibility_table, {transmissibility_figures}},
      {"Power into the ground", power_table, {power_figures}},
      {"Steady motion of the nonlinear machine", steady_tables, {steady_figures, orbit_figures}},
      {"Nonlinear modes", backbone_tables, {backbone_figures}},
      {"Shock response spectrum", shock_table, {shock_figures}},
      {"Earthquake", earthquake_tables, {}},
      {"Limit lines", limit_line_table, {limit_figures}},
      {"Measurements", measurement_tables, {measurement_figures}},
      {"Operating shapes", nullptr, {shape_figures}},
      {"Load sharing", load_sharing_table, {}},
  };
  return list;
}

}  // namespace

std::vector<Figure> answer_figures(const study::Answers& answers) {
  std::vector<Figure> all;
  for (const Shown& kinds : all_shown())
    for (const auto& kind : kinds.figures) {
      int number = 0;  // different names may share the letters that are safe in a file name
      for (Figure& figure : kind(answers)) {
        const std::size_t dash = figure.file_name.find('-');
        if (dash != std::string::npos) figure.file_name.insert(dash, fmt::format("-{:02}", ++number));
        all.push_back(std::move(figure));
      }
    }
  return all;
}

std::string answer_sections(const study::Answers& answers) {
  std::string html;
  for (const Shown& kinds : all_shown()) {
    std::vector<Figure> figures;
    for (const auto& kind : kinds.figures)
      for (Figure& figure : kind(answers)) figures.push_back(std::move(figure));
    html += section("answer", kinds.title, shown(kinds.tables ? kinds.tables(answers) : "", figures));
  }
  return html;
}

}  // namespace trivet::report
