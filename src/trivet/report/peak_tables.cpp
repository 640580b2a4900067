// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/report/html_table.h"
#include "trivet/report/result_tables.h"
#include "trivet/report/svg_canvas.h"

namespace trivet::report {

std::string limits_table(const project::Case&, const study::Answers& answers) {
  if (answers.limits.empty()) return "";
  std::vector<Row> rows;
  for (const study::LimitAnswer& l : answers.limits) {
    const results::DisplayUnit unit = results::amplitude_unit(answers.display, l.unit);
    Row row{{{l.name},
             aligned_quantity_cell(l.limit, unit),
             aligned_quantity_cell(l.in_band, unit),
             percent_cell(l.in_band / l.limit)},
            l.met ? "" : "failed"};
    add_frequency(row.cells, l.in_band_at, answers.display);
    row.cells.push_back(aligned_quantity_cell(l.anywhere, unit));
    row.cells.push_back(verdict_cell(l.met, "met", "EXCEEDED"));
    rows.push_back(std::move(row));
  }
  std::vector<Cell> headings = {{"curve"}, right("limit"), right("largest in the band"), right("share of the limit")};
  add_frequency_headings(headings, answers.display);
  headings.push_back(right("largest at any frequency"));
  headings.push_back({"verdict"});
  return html_table(headings, rows);
}

namespace {

Row peak_row(const study::Answers& answers, const response::Peak& p) {
  const response::Peaks& found = answers.peaks->peaks;
  const response::CurveSummary& curve = found.curves[p.curve];
  const double prominence = response::relative_prominence(p), tolerance = answers.peaks->peak_tolerance;
  const bool unbounded = std::isinf(p.amplitude);
  const bool counted = unbounded || !std::isfinite(prominence) || prominence >= tolerance;
  std::string remarks;
  const auto remark = [&](bool applies, const std::string& words) {
    if (applies) remarks += (remarks.empty() ? "" : "; ") + words;
  };
  remark(unbounded, "unbounded: no damping");
  remark(!counted, fmt::format("prominence under {:.6g} %", 100 * tolerance));
  if (answers.response && answers.response->band.from < answers.response->band.to) {
    const assembly::Band& band = answers.response->band;
    remark(p.angular_frequency < band.from || p.angular_frequency > band.to, "outside the band");
  }
  remark(!p.refined, "very flat, less exact");
  Row row{{{curve.name}}, counted ? "" : "minor"};
  add_frequency(row.cells, p.angular_frequency, answers.display);
  row.cells.push_back(aligned_quantity_cell(p.amplitude, results::amplitude_unit(answers.display, curve.unit)));
  row.cells.push_back(p.ratio_to_static ? aligned_cell(*p.ratio_to_static) : right("–"));
  row.cells.push_back(std::isfinite(prominence) ? aligned_cell(100 * prominence, 4) : right("∞"));
  row.cells.push_back(right(p.nearest_mode ? std::to_string(*p.nearest_mode) : "–"));
  row.cells.push_back({remarks});
  return row;
}

std::string peakless_words(const response::CurveSummary& s, const project::ShownUnits& display) {
  if (s.vanishes) return s.name + ": no resonance peak; below round-off at all frequencies.";
  return fmt::format("{}: no resonance peak; highest amplitude {} {}.", s.name,
                     aligned_quantity_cell(s.highest, results::amplitude_unit(display, s.unit)).text,
                     std::isfinite(s.highest_at) ? fmt::format("at ω = {:.5g} rad/s", s.highest_at) : "as ω → ∞");
}

}  // namespace

std::string peaks_table(const project::Case&, const study::Answers& answers) {
  if (!answers.peaks) return "";
  const response::Peaks& found = answers.peaks->peaks;
  std::vector<Row> rows;
  for (const response::Peak& peak : found.list) rows.push_back(peak_row(answers, peak));
  std::vector<Cell> headings = {{"curve"}};
  add_frequency_headings(headings, answers.display);
  for (const char* name : {"amplitude", "ratio to static", "relative prominence [%]", "nearest mode"})
    headings.push_back(right(name));
  headings.push_back({"remark"});
  std::string peakless;
  for (const response::CurveSummary& curve : found.curves)
    if (curve.peaks == 0) peakless += "<li>" + escaped(peakless_words(curve, answers.display)) + "</li>";
  return (rows.empty() ? "" : html_table(headings, rows)) +
      (peakless.empty() ? "" : "<ul class=\"sentences\">" + peakless + "</ul>\n") +
      hint(fmt::format(
          "All peaks at {}, except those lower than {:.6g} of the curve's largest amplitude; grey ones "
          "rise less than {:.6g} % above the adjacent minimum. Prominence “∞”: the amplitude next to the "
          "peak falls to 0. Ratio “–”: the static amplitude is 0 or not defined.",
          std::isfinite(found.searched_to) ? fmt::format("0 < ω < {:.4g} rad/s", found.searched_to) : "0 < ω < ∞",
          answers.peaks->min_prominence, 100 * answers.peaks->peak_tolerance));
}

std::string response_table(const project::Case&, const study::Answers& answers) {
  constexpr std::size_t few_points = 24;
  if (!answers.response || answers.response->model) return "";
  if (answers.response->curves.angular_frequency.size() > few_points) return "";
  const response::FrequencyResponse& response = answers.response->curves;
  std::vector<Row> rows;
  for (std::size_t c = 0; c < response.curves.size(); ++c)
    for (std::size_t i = 0; i < response.angular_frequency.size(); ++i) {
      const response::Curve& curve = response.curves[c];
      const auto at = static_cast<Eigen::Index>(i);
      const double amplitude = std::abs(curve.value(at)), phase = answers.response->phase[c](at);
      Row row{{{curve.name}}, ""};
      add_frequency(row.cells, response.angular_frequency[i], answers.display);
      row.cells.push_back(std::isfinite(amplitude)
                              ? aligned_quantity_cell(amplitude, results::amplitude_unit(answers.display, curve.unit))
                              : right("not defined"));
      row.cells.push_back(amplitude > 0 && std::isfinite(phase)
                              ? right(fmt::format("{:.2f}", phase * 360 / foundation::two_pi))
                              : right("–"));
      rows.push_back(std::move(row));
    }
  std::vector<Cell> headings = {{"curve"}};
  add_frequency_headings(headings, answers.display);
  headings.push_back(right("amplitude"));
  headings.push_back(right("phase [°]"));
  const std::string table = html_table(headings, rows);
  return response.angular_frequency.size() < 2 ? table : folded("The response at its frequencies as a table", table);
}

}  // namespace trivet::report
