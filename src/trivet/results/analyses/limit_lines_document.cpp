// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/documents/shown_numbers.h"
#include "trivet/results/format/result_writer.h"

/// Channels of the response compared with limit lines of the user.
namespace trivet::results {
namespace {

using assembly::Band;
using study::LimitLineResult;

/// Bands "from … to" with a separator.
std::string band_words(const std::vector<Band>& bands, const char* separator, const auto& words) {
  std::string text;
  for (const Band& band : bands) text += (text.empty() ? "" : separator) + words(band);
  return text;
}

/// The same line at the speed of the machine where the tones and the random vibration together have the largest share
/// of it; none if it is not judged there.
const study::OperatingLine* at_worst_speed(const study::CaseResults& results, const LimitLineResult& line) {
  const study::OperatingLine* worst = nullptr;
  if (!results.operation || line.bands.empty()) return worst;
  for (const study::OperatingLine& one : results.operation->lines)
    if (one.of == line.of && one.line.name == line.line.name && (!worst || one.share() > worst->share())) worst = &one;
  return worst;
}

std::string words_of_line(const study::CaseResults& results, const LimitLineResult& line, bool is_alone) {
  const bool met = line.comparison.met();
  std::string words = met ? "✓ met" : is_alone ? "✗ VIOLATED" : "above the line; judged as a requirement";
  const study::OperatingLine* with_tones = at_worst_speed(results, line);
  if (!with_tones) return words;
  const std::string at = study::speed_words(with_tones->speed);
  if (with_tones->met()) return met ? "✓ met, with tones too" : words;
  return fmt::format("✗ VIOLATED with the tones at {}{}", at, met ? "; random vibration alone is below" : "");
}

}  // namespace

Table limit_line_table(const study::CaseResults& results, const project::DisplayUnits& display) {
  const auto is_alone = [alone = limit_lines_alone(results)](const LimitLineResult& line) {
    return std::ranges::find(alone, &line) != alone.end();
  };
  const Rows row(results.limit_lines);
  const auto in_hertz = [](const Band& band) { return fmt::format("{} to {}", hertz(band.from), hertz(band.to)); };
  const auto shown = [display](const Band& band) {
    return fmt::format("{:.4g} … {:.4g}", shown_frequency(display, band.from), shown_frequency(display, band.to));
  };
  const auto exceeded_json = [](const LimitLineResult& l) {
    Json list = Json::array();
    for (const Band& band : l.comparison.exceeded) list.push_back({band.from, band.to});
    return list;
  };
  const auto exceeded_shown = [shown](const LimitLineResult& l) {
    return l.comparison.met() ? std::string("–") : band_words(l.comparison.exceeded, ", ", shown);
  };
  const std::string unit = " [" + frequency_unit(display) + "]";
  return {
      .key = whole_json,
      .axis = "limit_line",
      .plain_names = true,
      .file = "limit_lines.csv",
      .title = "Limit lines",
      .rows = row.size(),
      .columns =
          {row("name", Kind::words, "limit line", [](const LimitLineResult& l) { return l.line.name; }),
           row("of", Kind::words, "result", &LimitLineResult::of),
           row("unit", Kind::words, "", [](const LimitLineResult& l) { return l.line.unit; }),
           row("level", Kind::words, "", [](const LimitLineResult& l) { return l.line.rms ? "rms" : "zero_to_peak"; }),
           row("bands", Kind::words, "",
               [](const LimitLineResult& l) { return l.bands.empty() ? "" : name(l.bands.front().width); },
               {.forms = in_json | in_arrays}),
           row("source", Kind::words, "", &LimitLineResult::source, {.forms = in_json | in_arrays}),
           row("compared", Kind::words, "",
               [](const LimitLineResult& l) -> Json { return {l.comparison.compared.from, l.comparison.compared.to}; },
               {.forms = in_json}),
           row("compared", Kind::words, "",
               [in_hertz](const LimitLineResult& l) { return in_hertz(l.comparison.compared); }, {.forms = in_csv}),
           row("compared", Kind::words, "compared" + unit,
               [shown](const LimitLineResult& l) { return shown(l.comparison.compared); }, {.forms = for_people}),
           row("compared_from", Kind::frequency, "",
               [](const LimitLineResult& l) { return l.comparison.compared.from; }, {.forms = in_arrays}),
           row("compared_to", Kind::frequency, "", [](const LimitLineResult& l) { return l.comparison.compared.to; },
               {.forms = in_arrays}),
           row("least_margin", Kind::number, "", [](const LimitLineResult& l) { return l.comparison.least_margin; }),
           row("least_margin_db", Kind::number, "least margin",
               [](const LimitLineResult& l) { return response::margin_level(l.comparison.least_margin); },
               {.unit = "dB", .digits = 4}),
           row("at", Kind::frequency, "at", [](const LimitLineResult& l) { return l.comparison.least_margin_at; }),
           row("exceeded", Kind::words, "", exceeded_json, {.forms = in_json}),
           row("exceeded", Kind::words, "",
               [in_hertz](const LimitLineResult& l) { return band_words(l.comparison.exceeded, "; ", in_hertz); },
               {.forms = in_csv}),
           row("exceeded", Kind::words, "exceeded" + unit, exceeded_shown, {.forms = for_people}),
           row("kept", Kind::yes_no, "", [](const LimitLineResult& l) { return l.comparison.met(); }),
           row("verdict", Kind::words, "verdict",
               [&results, is_alone](const LimitLineResult& l) { return words_of_line(results, l, is_alone(l)); },
               {.forms = for_people})},
      .csv = {{"limit line", "name"},
              {"name", "of"},
              "unit",
              "level",
              {"compared [Hz]", "compared"},
              "least_margin",
              {"least_margin [dB]", "least_margin_db"},
              "at [rad/s]",
              {"exceeded [Hz]", "exceeded"},
              "kept"},
      .arrays = {{"limit_line", "name"},
                 {"name", "of"},
                 "unit",
                 "level",
                 "bands",
                 "source",
                 "compared_from",
                 "compared_to",
                 "least_margin",
                 "least_margin_db",
                 "at",
                 "kept"},
      .mark = [&results, is_alone](std::size_t i) {
        const LimitLineResult& line = results.limit_lines[i];
        const study::OperatingLine* with_tones = at_worst_speed(results, line);
        if (with_tones && !with_tones->met()) return Mark::bad;
        return line.comparison.met() ? Mark::plain : is_alone(line) ? Mark::bad : Mark::minor;
      }};
}

namespace {

/// A band in which a limit line is exceeded.
struct ExceededBand {
  std::string limit_line;
  double from = 0, to = 0;  ///< [rad/s]
};

Table exceeded_bands(const std::vector<LimitLineResult>& lines) {
  std::vector<ExceededBand> bands;
  for (const LimitLineResult& l : lines)
    for (const Band& band : l.comparison.exceeded) bands.push_back({l.line.name, band.from, band.to});
  const Rows row(std::move(bands));
  return {.axis = "exceeded",
          .rows = row.size(),
          .columns = {row("limit_line", Kind::words, "", &ExceededBand::limit_line),
                      row("from", Kind::frequency, "", &ExceededBand::from),
                      row("to", Kind::frequency, "", &ExceededBand::to)},
          .forms = in_arrays};
}

/// Which bands are judged, and where the named lines are published.
void add_notes_on_bands(const std::vector<LimitLineResult>& lines, Document& document) {
  const auto note = [&document](std::string words) {
    document.add(Sentence{.parts = {std::move(words)}, .place = Sentence::Place::note});
  };
  std::vector<std::string> sources;
  for (const LimitLineResult& l : lines) {
    if (l.bands.empty()) continue;
    note(fmt::format("{}: root mean square in each {} band, {:.4g} … {:.4g} Hz", l.line.name,
                     name(l.bands.front().width), l.bands.front().nominal_hz(), l.bands.back().nominal_hz()));
    if (!l.source.empty() && std::ranges::find(sources, l.source) == sources.end()) sources.push_back(l.source);
  }
  for (const std::string& source : sources) note("source of named lines: " + source);
}

Document limit_lines_document(const project::Case& variant, const study::CaseResults& results) {
  Document document;
  document.add(limit_line_table(results, variant.display));
  for (const LimitLineResult& l : results.limit_lines)
    document.add(Curves{
        .axis = l.line.name + " angular_frequency",
        .unit = "rad/s",
        .points = l.comparison.angular_frequency,
        .list = {{.name = l.line.name + " margin", .unit = "1", .values = l.comparison.margin, .forms = in_arrays}},
        .forms = in_arrays});
  document.add(exceeded_bands(results.limit_lines));
  add_notes_on_bands(results.limit_lines, document);
  return document;
}

}  // namespace

const ResultWriter limit_lines_results = {
    .has_result = [](const project::Case&, const study::CaseResults& results) { return !results.limit_lines.empty(); },
    .document = limit_lines_document,
    .files = {"limit_lines.csv"}};

}  // namespace trivet::results
