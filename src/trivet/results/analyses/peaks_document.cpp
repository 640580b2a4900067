// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "trivet/results/format/result_writer.h"

/// Exact resonance peaks.
namespace trivet::results {
namespace {

using response::Peak;

constexpr Sentence::Place item = Sentence::Place::item;

/// Rises a peak far enough above the adjacent minimum to count for the design rule?
bool counts(const Peak& peak, double tolerance) {
  const double prominence = response::relative_prominence(peak);
  return std::isinf(peak.amplitude) || !std::isfinite(prominence) || prominence >= tolerance;
}

std::string remarks(const study::CaseResults& results, const Peak& peak) {
  const double tolerance = results.peaks->peak_tolerance;
  std::string words;
  const auto remark = [&](bool applies, const std::string& one) {
    if (applies) words += (words.empty() ? "" : "; ") + one;
  };
  remark(std::isinf(peak.amplitude), "unbounded: no damping");
  remark(!counts(peak, tolerance), fmt::format("prominence under {:.6g} %", 100 * tolerance));
  if (results.response && results.response->band.from < results.response->band.to) {
    const assembly::Band& band = results.response->band;
    remark(peak.angular_frequency < band.from || peak.angular_frequency > band.to, "outside the band");
  }
  remark(!peak.refined, "very flat, less exact");
  return words;
}

Table peak_table(const study::CaseResults& results) {
  const response::Peaks& found = results.peaks->peaks;
  const Rows row(found.list);
  const auto curve = [&found](const Peak& peak) -> const response::CurveSummary& { return found.curves[peak.curve]; };
  std::map<std::string, double> largest;  // of each unit
  for (const Peak& peak : found.list) {
    double& size = largest[curve(peak).unit];
    size = std::max(size, peak.amplitude);
  }
  const bool has_remarks =
      std::ranges::any_of(found.list, [&](const Peak& peak) { return !remarks(results, peak).empty(); });
  return {
      .key = "peaks",
      .axis = "peak",
      .plain_names = true,
      .file = "peaks.csv",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "curve", [curve](const Peak& peak) { return curve(peak).name; }),
                  row("unit", Kind::words, "", [curve](const Peak& peak) { return curve(peak).unit; }),
                  row("angular_frequency", Kind::frequency, "ω", &Peak::angular_frequency, {.digits = 7}),
                  row("amplitude", Kind::amplitude, "amplitude", &Peak::amplitude, {.digits = 7}),
                  row("prominence", Kind::amplitude, "", &Peak::prominence),
                  row("relative_prominence", Kind::share, "above minimum", response::relative_prominence),
                  row("ratio_to_static", Kind::number, "× static", &Peak::ratio_to_static, {.digits = 5}),
                  row("nearest_mode", Kind::number, "nearest mode", &Peak::nearest_mode),
                  row("unbounded", Kind::yes_no, "", [](const Peak& peak) { return std::isinf(peak.amplitude); },
                      {.forms = in_json}),
                  row("angular_frequency_uncertainty", Kind::frequency, "", &Peak::frequency_uncertainty),
                  row("amplitude_uncertainty", Kind::amplitude, "", &Peak::amplitude_uncertainty),
                  row("method", Kind::words, "", [&found](const Peak& peak) { return response::method(found, peak); }),
                  row("remark", Kind::words, has_remarks ? "remark" : "",
                      [&results](const Peak& peak) { return remarks(results, peak); }, {.forms = for_people})},
      .csv = {"name", "unit", "angular_frequency [rad/s]", "amplitude", "prominence", "relative_prominence",
              "ratio_to_static", "nearest_mode", "angular_frequency_uncertainty [rad/s]", "amplitude_uncertainty",
              "method"},
      .height =
          [&found, largest](std::size_t i) {
            return found.list[i].amplitude / largest.at(found.curves[found.list[i].curve].unit);
          },
      .mark =
          [&results](std::size_t i) {
            return counts(results.peaks->peaks.list[i], results.peaks->peak_tolerance) ? Mark::plain : Mark::minor;
          },
  };
}

Table curve_table(const response::Peaks& found) {
  using response::CurveSummary;
  const Rows row(found.curves);
  return {
      .key = "curves",
      .axis = "result",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "", &CurveSummary::name), row("unit", Kind::words, "", &CurveSummary::unit),
                  row("peaks", Kind::number, "", &CurveSummary::peaks),
                  row("static_amplitude", Kind::amplitude, "", &CurveSummary::static_amplitude),
                  row("highest", Kind::amplitude, "", &CurveSummary::highest),
                  row("highest_at", Kind::frequency, "", &CurveSummary::highest_at),
                  row("vanishes", Kind::yes_no, "", &CurveSummary::vanishes)},
      .arrays = {{"result", "name"}, "unit", "peaks", "static_amplitude", "highest", "highest_at", "vanishes"},
      .forms = for_programs};
}

Sentence without_peak(const response::CurveSummary& curve) {
  if (curve.vanishes) return {.parts = {curve.name + ": zero except for round-off"}, .place = item};
  Sentence words{.parts = {curve.name + ": no resonance peak; its highest amplitude is ",
                           Quantity{curve.highest, curve.unit, Kind::amplitude}},
                 .place = item};
  if (std::isfinite(curve.highest_at))
    words.parts.insert(words.parts.end(), {" at ", Quantity{curve.highest_at, "rad/s", Kind::frequency}});
  else words.parts.emplace_back(" as ω → ∞");
  return words;
}

/// Where peaks were searched, and what is not in the table.
void add_search_notes(const study::CaseResults& results, Document& document) {
  const response::Peaks& found = results.peaks->peaks;
  const auto omega = [](double value) { return Quantity{value, "rad/s", Kind::frequency, 4}; };
  Sentence note{.parts = {"All peaks "}, .place = Sentence::Place::note};
  if (std::isfinite(found.searched_to))
    note.parts.insert(note.parts.end(), {"between ", omega(found.searched_from), " and ", omega(found.searched_to)});
  else if (found.searched_from > 0)
    note.parts.insert(note.parts.end(),
                      {"above ", omega(found.searched_from), " (below it the rigid-body mode dominates)"});
  else note.parts.emplace_back("at ω > 0");
  note.parts.emplace_back(fmt::format(", except those lower than {:.6g} of the largest amplitude of their curve.",
                                      results.peaks->min_prominence));
  document.add(std::move(note));
  if (std::isfinite(found.searched_to))
    document.add(Sentence{.parts = {"searched so far: with frequency-dependent elements or delays there is no last "
                                    "resonance; a `response.band` with a higher end extends the search, up to the end "
                                    "of the tables"},
                          .place = Sentence::Place::note});
  const auto is_minor = [&](const Peak& peak) { return !counts(peak, results.peaks->peak_tolerance); };
  if (std::ranges::any_of(found.list, is_minor))
    document.add(Sentence{.parts = {fmt::format("Minor ones rise less than {:.6g} % above the adjacent minimum.",
                                                100 * results.peaks->peak_tolerance)},
                          .place = Sentence::Place::note});
}

Document peaks_document(const project::Case& variant, const study::CaseResults& results) {
  const response::Peaks& found = results.peaks->peaks;
  Document document;
  document.add(excited_part(variant, "peaks"));
  document.add(Sentence{.parts = {"Resonance peaks"}, .forms = on_screen | in_summary});
  document.add(peak_table(results));
  document.add(curve_table(found));
  for (const response::CurveSummary& curve : found.curves)
    if (curve.peaks == 0) document.add(without_peak(curve));
  add_search_notes(results, document);
  document.add(Single{.name = "searched", .value = {found.searched_from, json::number(found.searched_to)}});
  document.add(Single{.name = "searched_from", .value = found.searched_from, .unit = "rad/s", .forms = in_arrays});
  document.add(Single{.name = "searched_to", .value = found.searched_to, .unit = "rad/s", .forms = in_arrays});
  document.add(Single{.name = "min_prominence", .value = results.peaks->min_prominence});
  document.add(Single{.name = "peak_tolerance", .value = results.peaks->peak_tolerance});
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter peaks_results = {
    .has_result = [](const project::Case&, const study::CaseResults& results) { return results.peaks.has_value(); },
    .document = peaks_document,
    .files = {"peaks.csv"}};

}  // namespace trivet::results
