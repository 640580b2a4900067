// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Exact resonance peaks.
namespace trivet::results {
namespace json {
namespace {

Json peaks(const project::Case&, const study::Answers& answers) {
  const response::Peaks& found = answers.peaks->peaks;
  Json result{{"peaks", Json::array()},
              {"curves", Json::array()},
              {"searched", {found.searched_from, number(found.searched_to)}},
              {"min_prominence", answers.peaks->min_prominence},
              {"peak_tolerance", answers.peaks->peak_tolerance},
              {"warnings", warnings(answers.warnings)}};
  for (const response::Peak& peak : found.list) {
    result["peaks"].push_back(
        {{"name", found.curves[peak.curve].name},
         {"unit", found.curves[peak.curve].unit},
         {"angular_frequency", peak.angular_frequency},
         {"amplitude", number(peak.amplitude)},
         {"prominence", number(peak.prominence)},
         {"relative_prominence", number(relative_prominence(peak))},
         {"ratio_to_static", peak.ratio_to_static ? number(*peak.ratio_to_static) : Json(nullptr)},
         {"nearest_mode", optional(peak.nearest_mode)},
         {"unbounded", std::isinf(peak.amplitude)},
         {"angular_frequency_uncertainty", peak.frequency_uncertainty},
         {"amplitude_uncertainty", peak.amplitude_uncertainty},
         {"method", response::method(found, peak)}});
  }
  for (const response::CurveSummary& curve : found.curves)
    result["curves"].push_back({{"name", curve.name},
                                {"unit", curve.unit},
                                {"peaks", curve.peaks},
                                {"static_amplitude", optional(curve.static_amplitude)},
                                {"highest", number(curve.highest)},
                                {"highest_at", number(curve.highest_at)},
                                {"vanishes", curve.vanishes}});
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string peaks_csv(const project::Case&, const study::Answers& answers) {
  std::string text =
      "name,unit,angular_frequency "
      "[rad/s],amplitude,prominence,relative_prominence,ratio_to_static,nearest_mode,angular_frequency_uncertainty "
      "[rad/s],amplitude_uncertainty,method\n";
  const response::Peaks& found = answers.peaks->peaks;
  for (const response::Peak& peak : found.list)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(found.curves[peak.curve].name),
                        csv_field(found.curves[peak.curve].unit), csv_number(peak.angular_frequency),
                        csv_number(peak.amplitude), csv_number(peak.prominence),
                        csv_number(response::relative_prominence(peak)), csv_number(peak.ratio_to_static),
                        csv_number(peak.nearest_mode), csv_number(peak.frequency_uncertainty),
                        csv_number(peak.amplitude_uncertainty), response::method(found, peak));
  return text;
}

std::vector<std::string> peak_headings(const project::ShownUnits& display) {
  std::vector<std::string> header = {"curve"};
  for (const std::string& unit : frequency_units(display)) header.push_back(frequency_heading(display, unit));
  for (const char* name : {"amplitude", "unit", "× static", "above minimum", "nearest mode"}) header.emplace_back(name);
  return header;
}

std::vector<std::string> peak_cells(const project::ShownUnits& display, const response::Peak& peak,
                                    const response::CurveSummary& curve) {
  std::vector<std::string> row = {curve.name};
  for (const std::string& unit : frequency_units(display))
    row.push_back(number_text(shown_frequency(display, peak.angular_frequency, unit), unit == "Hz" ? 6 : 9));
  const DisplayUnit unit = amplitude_unit(display, curve.unit);
  row.push_back(number_text(peak.amplitude * unit.factor, 9));
  row.push_back(unit.label());
  row.push_back(number_text(peak.ratio_to_static.value_or(nothing), 4));
  const double prominence = response::relative_prominence(peak);
  row.push_back(std::isinf(prominence) ? "∞" : fmt::format("{:.3g}%", 100 * prominence));
  row.push_back(mode_words(peak.nearest_mode));
  return row;
}

std::string peaks_table(const project::Case& variant, const study::Answers& answers) {
  const response::Peaks& found = answers.peaks->peaks;
  TextTable table(peak_headings(variant.display));
  for (const response::Peak& peak : found.list) table.add(peak_cells(variant.display, peak, found.curves[peak.curve]));
  std::string text = (std::isfinite(found.searched_to)
                          ? fmt::format("Resonance peaks up to {} rad/s\n", number_text(found.searched_to, 4))
                          : std::string("Resonance peaks, 0 < ω < ∞\n")) +
      (found.list.empty() ? std::string() : table.text());
  for (const response::CurveSummary& curve : found.curves) {
    const DisplayUnit unit = amplitude_unit(variant.display, curve.unit);
    if (curve.vanishes) text += fmt::format("  {}: zero except for round-off\n", curve.name);
    else if (curve.peaks == 0)
      text += fmt::format(
          "  {}: no resonance peak (prominence above {:g} of its maximum); the maximum is {} {} at ω = {} rad/s\n",
          curve.name, answers.peaks->min_prominence, number_text(curve.highest * unit.factor), unit.label(),
          number_text(curve.highest_at));
  }
  if (std::isfinite(found.searched_to))
    text += fmt::format(
        "  searched from ω = {} to {} rad/s: with frequency-dependent elements or delays there is no last resonance; a "
        "`response.band` with a higher end extends the search, up to the end of the tables\n",
        number_text(found.searched_from, 3), number_text(found.searched_to, 4));
  else if (found.searched_from > 0)
    text += fmt::format("  searched from ω = {} rad/s: below it the rigid-body mode dominates\n",
                        number_text(found.searched_from, 3));
  return text;
}

std::string peaks_text(const project::Case& variant, const study::Answers& answers) {
  return excited_at_once(variant, "peaks") + peaks_table(variant, answers);
}

void peaks_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using response::CurveSummary;
  using response::Peak;
  const response::Peaks& found = answers.peaks->peaks;
  list.count("peak", found.list.size());
  list.texts("name", "peak", found.list, [&](const Peak& peak) { return found.curves[peak.curve].name; });
  list.texts("unit", "peak", found.list, [&](const Peak& peak) { return found.curves[peak.curve].unit; });
  list.field("angular_frequency", "rad/s", "peak", found.list, &Peak::angular_frequency);
  list.field("amplitude", unit_of_the_row, "peak", found.list, &Peak::amplitude);
  list.field("prominence", unit_of_the_row, "peak", found.list, &Peak::prominence);
  list.column("relative_prominence", "1", "peak", found.list, response::relative_prominence);
  list.column("ratio_to_static", "1", "peak", found.list, &Peak::ratio_to_static);
  list.column("nearest_mode", "1", "peak", found.list, &Peak::nearest_mode);
  list.field("angular_frequency_uncertainty", "rad/s", "peak", found.list, &Peak::frequency_uncertainty);
  list.field("amplitude_uncertainty", unit_of_the_row, "peak", found.list, &Peak::amplitude_uncertainty);
  list.texts("method", "peak", found.list, [&](const Peak& peak) { return response::method(found, peak); });
  list.texts("result", "result", found.curves, &CurveSummary::name);
  list.texts("result.unit", "result", found.curves, &CurveSummary::unit);
  list.column("result.peaks", "1", "result", found.curves, &CurveSummary::peaks);
  list.column("result.static_amplitude", unit_of_the_row, "result", found.curves, &CurveSummary::static_amplitude);
  list.field("result.highest", unit_of_the_row, "result", found.curves, &CurveSummary::highest);
  list.field("result.highest_at", "rad/s", "result", found.curves, &CurveSummary::highest_at);
  list.column("result.vanishes", "1", "result", found.curves, &CurveSummary::vanishes);
  list.value("searched_from", "rad/s", found.searched_from);
  list.value("searched_to", "rad/s", found.searched_to);
  list.mark_harmonic({"unit", "amplitude", "prominence", "amplitude_uncertainty", "result.unit",
                      "result.static_amplitude", "result.highest"});
}

}  // namespace

const AnswerWriter peaks_results = {
    .has_answer = [](const project::Case&, const study::Answers& answers) { return answers.peaks.has_value(); },
    .json = json::peaks,
    .tables = {{"peaks.csv", peaks_csv}},
    .text = peaks_text,
    .summary = peaks_table,
    .arrays = peaks_arrays,
};

}  // namespace trivet::results
