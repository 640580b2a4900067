// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/search_parts.h"

#include <fmt/format.h>

#include "trivet/foundation/plain_text.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/result_writer.h"

namespace trivet::results {

std::vector<Column> parameter_columns(std::vector<SearchedParameter> parameters) {
  using Parameter = SearchedParameter;
  const Rows row(std::move(parameters));
  const auto name = [](const Parameter& p) { return p.axis->name; };
  const auto places = [](const Parameter& p) {
    Json list = Json::array();
    for (const project::ParameterPlace& place : p.axis->places)
      list.push_back({{"path", place.path}, {"factor", place.factor}});
    return list;
  };
  const auto given = [](const Parameter& p) { return p.given ? Json(*p.given) : Json("differ"); };
  const ColumnOptions in_unit = {.unit = unit_of_the_row};
  return {row("name", Kind::words, "parameter", name, {.forms = in_json | in_csv | for_people}),
          row("parameter", Kind::words, "", name, {.forms = in_arrays}),
          row("places", Kind::words, "", places, {.forms = in_json}),
          row("unit", Kind::words, "unit", [](const Parameter& p) { return axis_unit(*p.axis); },
              {.forms = in_json | for_people}),
          row("unit", Kind::words, "", [](const Parameter& p) { return array_unit(*p.axis); }, {.forms = in_arrays}),
          row(
              "from", Kind::number, "from", [](const Parameter& p) { return p.axis->from; }, in_unit),
          row(
              "to", Kind::number, "to", [](const Parameter& p) { return p.axis->to; }, in_unit),
          row("given", Kind::number, "", &Parameter::given, {.unit = unit_of_the_row, .forms = for_programs}),
          row("given", Kind::number, "given", given, {.unit = unit_of_the_row, .forms = for_people})};
}

std::string parameter_settings(const project::DesignAxis& axis, double value) {
  std::string text;
  for (const project::ParameterPlace& place : axis.places) {
    const std::string number = fmt::format("{:.12g}", place.factor * value);
    text += fmt::format("--set '{} = {}'\n", place.path,
                        axis.unit.empty() ? number : "\"" + number + " " + axis.unit + "\"");
  }
  return text;
}

void add_search_lines(const std::vector<std::string>& sentences, Document& document) {
  for (const std::string& one : sentences) document.add(Sentence{.parts = {one}, .place = Sentence::Place::note});
  document.add(Sentence{.parts = {"A search finds the best of where it looked; it proves no global optimum."},
                        .place = Sentence::Place::note});
}

std::string computed_words(std::size_t evaluations, std::size_t failed, const std::string& first_failure) {
  return fmt::format("{} designs computed", evaluations) +
      (failed > 0 ? fmt::format(", {} of them without a result ({})", failed, first_failure) : "") + ".";
}

std::string differences_words(const std::vector<std::string>& kinds, std::size_t differences) {
  if (kinds.empty()) return "";
  return fmt::format("Slopes by differences of values: {}; {} more designs computed for them.",
                     foundation::comma_separated(kinds), differences);
}

Single differenced_part(const std::vector<std::string>& kinds, std::size_t evaluations) {
  Json list = Json::array();
  for (const std::string& kind : kinds) list.push_back({{"requirement", kind}, {"evaluations", evaluations}});
  return {.name = "differenced", .value = std::move(list)};
}

}  // namespace trivet::results
