// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/answer_sections.h"

#include "trivet/report/answer_figures.h"
#include "trivet/report/answer_tables.h"
#include "trivet/report/svg_canvas.h"

namespace trivet::report {
namespace {

/// Nothing where there is nothing to show.
std::string section(const std::string& title, const std::string& tables, const std::vector<Figure>& figures) {
  if (tables.empty() && figures.empty()) return "";
  std::string html = "<section><h2>" + title + "</h2>\n" + tables;
  for (const Figure& figure : figures)
    html += "<figure><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(figure.title) + "\">" + figure.svg +
            "</div></figure>\n";
  return html + "</section>\n";
}

std::vector<Figure> all_run_up_figures(const study::Answers& answers) {
  std::vector<Figure> figures = campbell_figures(answers);
  for (const auto& kind : {waterfall_figures, run_up_figures})
    for (Figure& figure : kind(answers)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace

std::string answer_sections(const study::Answers& answers) {
  return section("Map of designs", map_tables(answers), map_figures(answers)) + section("Random response", random_table(answers), random_figures(answers)) +
         section("Motion in time", transient_table(answers), transient_figures(answers)) +
         section("Run-up", run_up_tables(answers), all_run_up_figures(answers)) +
         section("Transmissibility", transmissibility_table(answers), transmissibility_figures(answers)) +
         section("Power into the ground", power_table(answers), power_figures(answers)) +
         section("Shock response spectrum", shock_table(answers), shock_figures(answers)) +
         section("Earthquake", earthquake_tables(answers), {}) + section("Limit lines", limit_line_table(answers), limit_figures(answers)) +
         section("Operating shapes", "", shape_figures(answers)) + section("Load sharing", load_sharing_table(answers), {});
}

}  // namespace trivet::report
