// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/report_page.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "trivet/documents/html_table.h"
#include "trivet/foundation/version.h"
#include "trivet/report/drawing/machine_drawing.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/report/figures/design_lines_figure.h"
#include "trivet/report/page/compressed_part.h"
#include "trivet/report/page/design_judgement.h"
#include "trivet/report/page/drawing_json.h"
#include "trivet/report/page/first_page.h"
#include "trivet/report/page/machine_json.h"
#include "trivet/report/page/page_notices.h"
#include "trivet/report/page/result_sections.h"
#include "trivet/report/page/title_block.h"
#include "trivet/report/tables/input_tables.h"
#include "trivet/results/design/verdict_results.h"
#include "trivet/results/format/written_results.h"

namespace trivet::report {

extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_script;
extern const char* const machine_script;
extern const char* const lines_script;

namespace {

void replace(std::string& text, const std::string& place, const std::string& content) {
  const std::size_t at = text.find(place);
  if (at != std::string::npos) text.replace(at, place.size(), content);
}

/// Leaves out the parts of the page of one kind: between <!-- KIND --> and <!-- /KIND -->. The short form has none that
/// are `full`, a page without maps none of a `map`, one without designs as lines none of `lines`, one without bodies
/// none of `3d`.
std::string without_parts(std::string page, const std::string& kind) {
  const std::string begin = "<!-- " + kind + " -->", end = "<!-- /" + kind + " -->";
  for (std::size_t from = page.find(begin); from != std::string::npos; from = page.find(begin))
    page.erase(from, page.find(end, from) + end.size() - from);
  return page;
}

/// Escapes JSON so that it cannot end the script element around it.
std::string inside_script(const std::string& json) {
  std::string result;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] == '<') result += "\\u003c";
    else result += json[i];
  }
  return result;
}

/// A text as a string of a style sheet, which it cannot end, nor the style element around it.
std::string css_string(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool special = c == '"' || c == '\\' || c == '<' || static_cast<unsigned char>(c) < ' ';
    result += special ? fmt::format("\\{:x} ", c) : std::string(1, c);
  }
  return '"' + result + '"';
}

/// One block per case; the script shows that of the selected case, without scripts the first one is visible.
std::string case_blocks(const std::vector<ShownCase>& cases, const std::function<std::string(const ShownCase&)>& html) {
  std::string blocks;
  for (std::size_t i = 0; i < cases.size(); ++i)
    blocks += fmt::format("<div data-case=\"{}\"{}>{}</div>\n", i, i == 0 ? "" : " hidden", html(cases[i]));
  return blocks;
}

std::string case_options(const std::vector<ShownCase>& cases) {
  std::string options;
  for (std::size_t i = 0; i < cases.size(); ++i)
    options += fmt::format("<option value=\"{}\">{}</option>", i, escaped(cases[i].name()));
  return options;
}

/// Sentence about the units of the page.
std::string units_note(const project::DisplayUnits& display) {
  project::DisplayUnits only_level;
  only_level.level = display.level;
  if (display == only_level) return "Everything is in SI units and their multiples, frequencies in Hz.";
  return "Results are in the units that their axis, column or value shows: those of [display] in the project file. "
         "Inputs, maps and best designs are in SI units.";
}

std::string level_note(const project::DisplayUnits& display) {
  const std::string elsewhere = " Limits are at the level of what they limit";
  if (display.level) return std::string(results::level_words(*display.level)) + "." + elsewhere;
  return "rms for velocities and zero-to-peak (0-p) for all others, as their units show." + elsewhere;
}

std::string above_pictures(const ShownCase& shown, std::size_t cases) {
  const auto& verdict = shown.results.verdict;
  const std::string requirements = verdict ? as_html(results::verdict_document(*verdict), verdict->display) : "";
  return case_head(shown, cases) +
      section("requirements", "Requirements in detail",
              cases > 1 || requirements.empty() ? requirements : folded("All requirements", requirements)) +
      section("limits", "Limits", results::limits_html(shown.results)) + modes_part(shown, "Undamped modes", true) +
      section("roots", "Damped roots", results::result_html("roots", shown.variant, shown.results));
}

std::string below_pictures(const ShownCase& shown) {
  return section("response", "Response", results::result_html("response", shown.variant, shown.results)) +
      section("peaks", "Resonance peaks", results::result_html("peaks", shown.variant, shown.results)) +
      result_sections(shown.variant, shown.results);
}

/// The drawing of a case whose machine differs from that of the base model.
std::string own_drawing(const ShownCase& shown, const std::string& of_base) {
  if (machine_drawing(shown.variant) == of_base) return "";
  return section("case-machine", "Machine of this case",
                 drawing_part(shown.variant, "Drawing of the machine of this case"));
}

/// The text of the input file, if it states a case as it is: without settings and changes.
std::string text_of(const project::Project& project, const ShownCase& shown) {
  const bool is_changed = !project.settings.empty() || !shown.results.changes.empty();
  return project.parsed && !is_changed ? project.parsed->text : "";
}

std::string below_comparison(const project::Project& project, const ShownCase& shown,
                             const std::string& drawing_of_base) {
  const project::Case& variant = shown.variant;
  return own_drawing(shown, drawing_of_base) +
      section("static", "Static results", results::result_html("static", variant, shown.results)) +
      section("inputs", "Inputs", input_tables(variant, text_of(project, shown))) +
      section("checks", "Checks", checks_table(shown));
}

}  // namespace

std::string report_page(const project::Project& project, const std::vector<study::CaseResults>& case_results,
                        const std::string& results, const project::ReportForm form, const CaseMapCurves& map_curves) {
  const std::string title = project.title.empty() ? project.source : project.title;
  const std::string input = std::filesystem::path(project.source).filename().string();
  const std::vector<ShownCase> cases = shown_cases(project, case_results);
  const project::DisplayUnits display = project.base().display;
  const bool is_short = form == project::ReportForm::brief;
  std::string page = is_short ? without_parts(page_html, "full") : page_html;
  const bool has_points = has_map_point(map_curves);
  if (!has_points) page = without_parts(page, "map");
  const bool has_motion = !is_short && has_moving_machine(cases);
  if (!has_motion) page = without_parts(page, "3d");
  const std::string analyses = case_blocks(cases, below_pictures);
  const bool has_lines = !is_short && has_design_lines(analyses);
  if (!has_lines) page = without_parts(page, "lines");
  // From the end to the start, so that inserted text that looks like a placeholder is not replaced.
  if (has_lines) replace(page, "{{lines_script}}", lines_script);
  replace(page, "{{script}}", page_script);
  if (has_motion) {
    replace(page, "{{machine_data}}", compressed_part(machine_json(cases)));
    replace(page, "{{machine_script}}", compressed_part(machine_script));
  }
  if (has_points) replace(page, "{{designs}}", inside_script(map_point_json(case_results, map_curves)));
  replace(page, "{{drawing}}", inside_script(drawing_json(case_results, map_curves)));
  replace(page, "{{results}}", inside_script(results));
  replace(page, "{{input_file}}", section("input-file", "Appendix: input file", input_file(project)));
  replace(page, "{{open}}", is_short ? " open" : "");
  replace(page, "{{form}}", is_short ? " class=\"short\"" : "");
  replace(page, "{{level}}", level_note(display));
  replace(page, "{{units}}", units_note(display));
  const std::string drawing_of_base = machine_drawing(project.base());
  replace(page, "{{tables}}",
          case_blocks(cases, [&](const ShownCase& c) { return below_comparison(project, c, drawing_of_base); }));
  replace(page, "{{analyses}}", analyses);
  replace(page, "{{heads}}", case_blocks(cases, [&](const ShownCase& c) { return above_pictures(c, cases.size()); }));
  replace(page, "{{cases}}", case_options(cases));
  // Next to the charts of a single case, its overview would be the same curves again.
  replace(page, "{{overview}}",
          is_short || cases.size() > 1 ? overview_part(overview(title, case_results).html(), is_short) : "");
  replace(page, "{{short_results}}", is_short ? short_results(cases) : "");
  replace(page, "{{machine}}", machine_part(project));
  const study::Envelope envelope = study::envelope_of(case_results);
  replace(page, "{{glance}}",
          section("glance", "Cases", cases.size() > 1 ? glance_table(cases) : "") +
              section("envelope", "Load cases", as_html(results::envelope_document(envelope), envelope.display)));
  replace(page, "{{speeds}}", speeds_part(cases));
  replace(page, "{{requirements}}", section("judgements", "Requirements", judgements_table(cases, display)));
  replace(page, "{{notices}}", page_notices(cases, !is_short));
  replace(page, "{{title_block}}", title_block(project));
  replace(page, "{{heading}}", escaped(title));
  replace(page, "{{source_on_paper}}", css_string(input));
  replace(page, "{{title_on_paper}}", css_string(title));
  replace(page, "{{style}}", page_css);
  replace(page, "{{title}}", escaped(title));
  return page;
}

}  // namespace trivet::report
