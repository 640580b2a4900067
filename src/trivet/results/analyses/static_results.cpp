// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/results/format/result_writer.h"

/// Static displacements and forces.
namespace trivet::results {
namespace json {
namespace {

Json statics(const project::Case&, const study::CaseResults& results) {
  Json result{{"results", Json::array()},
              {"backward_error", results.statics->backward_error},
              {"warnings", warnings(results.warnings)}};
  for (const response::StaticValue& value : results.statics->values)
    result["results"].push_back({{"name", value.name}, {"unit", value.unit}, {"value", value.value}});
  if (results.rest_states.empty()) return result;
  result["states"] = Json::array();
  for (const nonlinear::RestState& state : results.rest_states) {
    Json deflections = Json::object();
    for (const auto& [name, value] : state.deflections) deflections[name] = value;
    result["states"].push_back({{"stable", state.stable}, {"deflections", std::move(deflections)}});
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string static_csv(const project::Case&, const study::CaseResults& results) {
  std::string text = "name,unit,value\n";
  for (const response::StaticValue& value : results.statics->values)
    text += fmt::format("{},{},{}\n", csv_field(value.name), csv_field(value.unit), csv_number(value.value));
  return text;
}

/// Deflections of the nonlinear parts in every position of rest.
std::string states_text(const study::CaseResults& results) {
  const std::vector<nonlinear::RestState>& states = results.rest_states;
  if (states.empty()) return "";
  std::vector<std::string> headings = {"deflection [m, rad]"};
  for (std::size_t i = 0; i < states.size(); ++i)
    headings.push_back(fmt::format("{}{}", i + 1, states[i].stable ? " stable" : " unstable"));
  TextTable table(headings);
  for (std::size_t d = 0; d < states.front().deflections.size(); ++d) {
    std::vector<std::string> row = {states.front().deflections[d].first};
    for (const nonlinear::RestState& state : states) row.push_back(number_text(state.deflections[d].second, 9));
    table.add(row);
  }
  return fmt::format("Positions of rest: {} found from many starts, which proves no others absent\n", states.size()) +
      table.text();
}

std::string static_text(const project::Case&, const study::CaseResults& results) {
  TextTable table({"result", "value", "unit"});
  LargestOfKind largest;
  for (const response::StaticValue& value : results.statics->values) largest.add(value.unit, value.value);
  for (const response::StaticValue& value : results.statics->values) {
    const DisplayUnit unit = display_unit(results.display, value.unit);
    table.add({value.name, number_text(largest.shown(value.unit, value.value) * unit.factor, 9), unit.unit});
  }
  return "Static displacements and forces\n" + table.text() +
      (results.load_sharing ? load_sharing_text(results) : std::string()) + states_text(results);
}

void static_arrays(const project::Case&, const study::CaseResults& results, LabelledArrays& list) {
  using response::StaticValue;
  const std::vector<StaticValue>& values = results.statics->values;
  list.texts("result", "result", values, &StaticValue::name);
  list.texts("unit", "result", values, &StaticValue::unit);
  list.field("value", unit_of_the_row, "result", values, &StaticValue::value);
  const std::vector<nonlinear::RestState>& states = results.rest_states;
  if (states.empty()) return;
  list.count("state", states.size());
  list.column("state.stable", "1", "state", states, &nonlinear::RestState::stable);
  for (std::size_t d = 0; d < states.front().deflections.size(); ++d) {
    const std::string name = states.front().deflections[d].first;
    const bool turns = name.find(".r", name.rfind('.')) != std::string::npos;
    list.column(name + " at rest", turns ? "rad" : "m", "state", states,
                [d](const nonlinear::RestState& state) { return state.deflections[d].second; });
  }
}

}  // namespace

const ResultWriter static_results = {
    .has_result = [](const project::Case&, const study::CaseResults& results) { return results.statics.has_value(); },
    .json = json::statics,
    .tables = {{"static.csv", static_csv}},
    .text = static_text,
    .arrays = static_arrays,
};

}  // namespace trivet::results
