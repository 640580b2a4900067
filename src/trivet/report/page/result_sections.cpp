// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/result_sections.h"

#include <fmt/format.h>

#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/format/written_results.h"

namespace trivet::report {
namespace {

/// Title, tables and figures of a result, or of several that belong together.
struct Shown {
  const char* title;
  const char* result;  ///< whose document it is; nullptr: `tables` has its tables
  std::string (*tables)(const study::CaseResults& results);
  std::vector<std::vector<Figure> (*)(const study::CaseResults& results)> figures;
  std::vector<Figure> (*drawings)(const project::Case& variant, const study::CaseResults& results) = nullptr;
};

std::vector<std::vector<Figure>> figures_of(const Shown& shown, const project::Case& variant,
                                            const study::CaseResults& results) {
  std::vector<std::vector<Figure>> kinds;
  for (const auto& kind : shown.figures) kinds.push_back(kind(results));
  if (shown.drawings) kinds.push_back(shown.drawings(variant, results));
  return kinds;
}

std::string best_design(const study::CaseResults& results) {
  return results.optimization ? as_html(results::optimization_document(*results.optimization), results.display) : "";
}

std::string front_between(const study::CaseResults& results) {
  return results.front ? as_html(results::front_document(*results.front), results.display) : "";
}

/// Tables and figures in addition to the harmonic characteristics, in the order of the page. Add new ones here.
const std::vector<Shown>& all_shown() {
  static const std::vector<Shown> list = {
      {"Map of designs", "map", nullptr, {map_figures}},
      {"Best design", nullptr, best_design, {}, best_design_figures},
      {"Front", nullptr, front_between, {front_figures}},
      {"Designs within tolerances", "sample", nullptr, {sample_figures}},
      {"At the operating speed", "operation", nullptr, {}},
      {"Measured levels of the excitation", nullptr, nullptr, {}, band_level_figures},
      {"Random response", "random", nullptr, {random_figures}},
      {"Time history", "transient", nullptr, {transient_figures}},
      {"Run-up", "orders", nullptr, {campbell_figures, waterfall_figures, run_up_figures}},
      {"Transmissibility", "transmissibility", nullptr, {transmissibility_figures}},
      {"Power into the ground", "power", nullptr, {power_figures}},
      {"Steady motion of the nonlinear machine", "steady", nullptr, {steady_figures, orbit_figures}},
      {"Nonlinear modes", "backbone", nullptr, {backbone_figures}},
      {"Shock response spectrum", "shock_spectrum", nullptr, {shock_figures}},
      {"Earthquake", "earthquake", nullptr, {}},
      {"Limit lines", "limit_lines", nullptr, {limit_figures}},
      {"Measurements", "measurements", nullptr, {measurement_figures}},
      {"Operating shapes", "shapes", nullptr, {}, shape_figures},
      {"Load sharing", "load_sharing", nullptr, {}},
  };
  return list;
}

}  // namespace

std::string figures_html(const std::vector<Figure>& figures) {
  std::string html, quarters;
  const auto end_row = [&] {
    if (!quarters.empty()) html += "<div class=\"quarters\">" + quarters + "</div>\n";
    quarters.clear();
  };
  for (const Figure& figure : figures) {
    if (figure.in_row == 4) {
      quarters += "<figure>" + figure.html() + "</figure>\n";
      continue;
    }
    end_row();
    html += std::string(figure.in_row == 2 ? "<figure class=\"half\">" : "<figure>") +
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"" + escaped(figure.title) + "\">" +
        figure.html() + "</div></figure>\n";
  }
  end_row();
  return html;
}

std::vector<Figure> result_figures(const project::Case& variant, const study::CaseResults& results) {
  std::vector<Figure> all;
  const auto add = [&all](std::vector<Figure> figures) {
    int number = 0;  // different names may share the letters that are safe in a file name
    for (Figure& figure : figures) {
      const std::size_t dash = figure.file_name.find('-');
      if (dash != std::string::npos) figure.file_name.insert(dash, fmt::format("-{:02}", ++number));
      all.push_back(std::move(figure));
    }
  };
  add(mode_figures(variant, results));
  for (const Shown& kinds : all_shown())
    for (std::vector<Figure>& kind : figures_of(kinds, variant, results)) add(std::move(kind));
  return all;
}

std::string result_sections(const project::Case& variant, const study::CaseResults& results) {
  std::string html;
  for (const Shown& kinds : all_shown()) {
    std::string figures;
    for (const std::vector<Figure>& kind : figures_of(kinds, variant, results)) figures += figures_html(kind);
    const std::string tables = kinds.result ? results::result_html(kinds.result, variant, results)
        : kinds.tables                      ? kinds.tables(results)
                                            : "";
    html += section(std::string("answer") + (kinds.result ? std::string(" ") + kinds.result : ""), kinds.title,
                    tables + figures);
  }
  return html;
}

}  // namespace trivet::report
