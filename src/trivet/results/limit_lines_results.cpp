// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Answers of the response compared with limit lines of the user.
namespace trivet::results {
namespace json {

Json limit_lines(const study::Answers& answers) {
  Json result = Json::array();
  for (const study::LimitLineResult& l : answers.limit_lines) {
    Json exceeded = Json::array();
    for (const assembly::Band& band : l.comparison.exceeded) exceeded.push_back({band.from, band.to});
    result.push_back({{"name", l.line.name},
                      {"of", l.of},
                      {"unit", l.line.unit},
                      {"level", l.line.rms ? "rms" : "zero_to_peak"},
                      {"compared", {l.comparison.compared.from, l.comparison.compared.to}},
                      {"least_margin", number(l.comparison.least_margin)},
                      {"least_margin_db", number(response::margin_level(l.comparison.least_margin))},
                      {"at", l.comparison.least_margin_at},
                      {"exceeded", std::move(exceeded)},
                      {"kept", l.comparison.met()}});
  }
  return result;
}

}  // namespace json

std::string limit_lines_text(const study::Answers& answers) {
  if (answers.limit_lines.empty()) return "";
  const auto in_unit = [&](double omega) { return shown_frequency(answers.display, omega); };
  const std::string unit = " [" + frequency_unit(answers.display) + "]";
  TextTable table(
      {"limit line", "result", "compared" + unit, "least margin [dB]", "at" + unit, "exceeded" + unit, "verdict"});
  for (const study::LimitLineResult& l : answers.limit_lines) {
    std::string bands;
    for (const assembly::Band& band : l.comparison.exceeded)
      bands += (bands.empty() ? "" : ", ") + fmt::format("{:.4g} … {:.4g}", in_unit(band.from), in_unit(band.to));
    table.add({l.line.name, l.of,
               fmt::format("{:.4g} … {:.4g}", in_unit(l.comparison.compared.from), in_unit(l.comparison.compared.to)),
               number_text(response::margin_level(l.comparison.least_margin), 4),
               number_text(in_unit(l.comparison.least_margin_at), 5), bands.empty() ? "–" : bands,
               l.comparison.met() ? "met" : "EXCEEDED"});
  }
  return "Limit lines\n" + table.text();
}

namespace {

/// One row per limit line; exceeded bands as "from … to" in hertz.
std::string limit_lines_csv(const project::Case&, const study::Answers& answers) {
  std::string text =
      "limit line,name,unit,level,compared [Hz],least_margin,least_margin [dB],at [rad/s],exceeded [Hz],kept\n";
  for (const study::LimitLineResult& l : answers.limit_lines) {
    std::string bands;
    for (const assembly::Band& band : l.comparison.exceeded)
      bands += (bands.empty() ? "" : "; ") + fmt::format("{} to {}", hertz(band.from), hertz(band.to));
    text += fmt::format("{},{},{},{},{} to {},{},{},{},{},{}\n", csv_field(l.line.name), csv_field(l.of),
                        csv_field(l.line.unit), l.line.rms ? "rms" : "zero_to_peak", hertz(l.comparison.compared.from),
                        hertz(l.comparison.compared.to), csv_number(l.comparison.least_margin),
                        csv_number(response::margin_level(l.comparison.least_margin)),
                        csv_number(l.comparison.least_margin_at), csv_field(bands), l.comparison.met() ? "yes" : "no");
  }
  return text;
}

json::Json limit_lines_json(const project::Case&, const study::Answers& answers) { return json::limit_lines(answers); }

std::string limit_lines_table(const project::Case&, const study::Answers& answers) { return limit_lines_text(answers); }

void limit_lines_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using study::LimitLineResult;
  const std::vector<LimitLineResult>& lines = answers.limit_lines;
  const std::string axis = "limit_line";
  list.texts(axis, axis, lines, [](const LimitLineResult& l) { return l.line.name; });
  list.texts("name", axis, lines, &LimitLineResult::of);
  list.texts("unit", axis, lines, [](const LimitLineResult& l) { return l.line.unit; });
  list.texts("level", axis, lines, [](const LimitLineResult& l) { return l.line.rms ? "rms" : "zero_to_peak"; });
  list.column("compared_from", "rad/s", axis, lines, [](const auto& l) { return l.comparison.compared.from; });
  list.column("compared_to", "rad/s", axis, lines, [](const auto& l) { return l.comparison.compared.to; });
  list.column("least_margin", "1", axis, lines, [](const auto& l) { return l.comparison.least_margin; });
  list.column("least_margin_db", "dB", axis, lines,
              [](const auto& l) { return response::margin_level(l.comparison.least_margin); });
  list.column("at", "rad/s", axis, lines, [](const auto& l) { return l.comparison.least_margin_at; });
  list.column("kept", "1", axis, lines, [](const auto& l) { return l.comparison.met(); });
  std::vector<std::string> names;
  std::vector<assembly::Band> bands;
  for (const LimitLineResult& l : lines) {
    names.insert(names.end(), l.comparison.exceeded.size(), l.line.name);
    bands.insert(bands.end(), l.comparison.exceeded.begin(), l.comparison.exceeded.end());
    const std::string frequencies = l.line.name + " angular_frequency";
    list.view(frequencies, "rad/s", frequencies, l.comparison.angular_frequency);
    list.view(l.line.name + " margin", "1", frequencies, l.comparison.margin);
  }
  list.count("exceeded", bands.size());
  list.texts("exceeded.limit_line", "exceeded", std::move(names));
  list.column("exceeded.from", "rad/s", "exceeded", bands, &assembly::Band::from);
  list.column("exceeded.to", "rad/s", "exceeded", bands, &assembly::Band::to);
}

}  // namespace

const AnswerWriter limit_lines_results = {
    .has_answer = [](const project::Case&, const study::Answers& answers) { return !answers.limit_lines.empty(); },
    .json = limit_lines_json,
    .tables = {{"limit_lines.csv", limit_lines_csv}},
    .text = limit_lines_table,
    .arrays = limit_lines_arrays,
};

}  // namespace trivet::results
