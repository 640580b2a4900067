// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Static displacements and forces, and the load on each mount.
namespace trivet::results {
namespace json {
namespace {

Json statics(const project::Case&, const study::Answers& answers) {
  Json result{{"results", Json::array()},
              {"backward_error", answers.statics->backward_error},
              {"warnings", warnings(answers.warnings)}};
  for (const response::StaticValue& value : answers.statics->values)
    result["results"].push_back({{"name", value.name}, {"unit", value.unit}, {"value", value.value}});
  if (answers.rest_states.empty()) return result;
  result["states"] = Json::array();
  for (const nonlinear::RestState& state : answers.rest_states) {
    Json deflections = Json::object();
    for (const auto& [name, value] : state.deflections) deflections[name] = value;
    result["states"].push_back({{"stable", state.stable}, {"deflections", std::move(deflections)}});
  }
  return result;
}

Json load_sharing(const project::Case&, const study::Answers& answers) {
  Json mounts = Json::array();
  for (const response::MountLoad& m : answers.load_sharing->mounts)
    mounts.push_back({{"element", m.element},
                      {"force", list(m.force)},
                      {"bearing", m.bearing},
                      {"share", m.share},
                      {"deflection", list(m.deflection)}});
  return {{"mounts", std::move(mounts)}, {"bearing_in_total", answers.load_sharing->bearing_in_total}};
}

}  // namespace
}  // namespace json

namespace {

std::string static_csv(const project::Case&, const study::Answers& answers) {
  std::string text = "name,unit,value\n";
  for (const response::StaticValue& value : answers.statics->values)
    text += fmt::format("{},{},{}\n", csv_field(value.name), csv_field(value.unit), csv_number(value.value));
  return text;
}

std::string load_sharing_csv(const project::Case&, const study::Answers& answers) {
  std::string text = "element,bearing [N],share,deflection x [m],deflection y [m],deflection z [m]\n";
  for (const response::MountLoad& m : answers.load_sharing->mounts)
    text += fmt::format("{},{},{},{},{},{}\n", csv_field(m.element), csv_number(m.bearing), csv_number(m.share),
                        csv_number(m.deflection(0)), csv_number(m.deflection(1)), csv_number(m.deflection(2)));
  return text;
}

std::string load_sharing_text(const study::Answers& answers) {
  const DisplayUnit force = display_unit(answers.display, "N"), length = display_unit(answers.display, "m");
  const std::string in_length = " [" + length.unit + "]";
  TextTable table(
      {"mount", "load [" + force.unit + "]", "share", "deflection x" + in_length, "y" + in_length, "z" + in_length});
  LargestOfKind largest;
  for (const response::MountLoad& m : answers.load_sharing->mounts) {
    largest.add("N", m.bearing);
    for (const double deflection : m.deflection) largest.add("m", deflection);
  }
  for (const response::MountLoad& m : answers.load_sharing->mounts) {
    std::vector<std::string> row = {m.element, number_text(largest.shown("N", m.bearing) * force.factor),
                                    percent(m.share)};
    for (int j = 0; j < 3; ++j) row.push_back(number_text(largest.shown("m", m.deflection(j)) * length.factor, 4));
    table.add(row);
  }
  return "Load sharing (deflection of end K relative to N in the element's axes)\n" + table.text();
}

/// Deflections of the nonlinear parts in every position of rest.
std::string states_text(const study::Answers& answers) {
  const std::vector<nonlinear::RestState>& states = answers.rest_states;
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

std::string static_text(const project::Case&, const study::Answers& answers) {
  TextTable table({"result", "value", "unit"});
  LargestOfKind largest;
  for (const response::StaticValue& value : answers.statics->values) largest.add(value.unit, value.value);
  for (const response::StaticValue& value : answers.statics->values) {
    const DisplayUnit unit = display_unit(answers.display, value.unit);
    table.add({value.name, number_text(largest.shown(value.unit, value.value) * unit.factor, 9), unit.unit});
  }
  return "Static displacements and forces\n" + table.text() +
      (answers.load_sharing ? load_sharing_text(answers) : std::string()) + states_text(answers);
}

void static_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using response::StaticValue;
  const std::vector<StaticValue>& values = answers.statics->values;
  list.texts("result", "result", values, &StaticValue::name);
  list.texts("unit", "result", values, &StaticValue::unit);
  list.field("value", unit_of_the_row, "result", values, &StaticValue::value);
  const std::vector<nonlinear::RestState>& states = answers.rest_states;
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

void load_sharing_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using response::MountLoad;
  const std::vector<MountLoad>& mounts = answers.load_sharing->mounts;
  list.texts("element", "element", mounts, &MountLoad::element);
  list.field("bearing", "N", "element", mounts, &MountLoad::bearing);
  list.field("share", "1", "element", mounts, &MountLoad::share);
  list.texts("direction", "direction", {"x", "y", "z"});
  list.lists("force", "N", {"element", "direction"}, 3, mounts, &MountLoad::force);
  add_motion_coordinates(list);
  list.lists("deflection", unit_of_the_row, {"element", "coordinate"}, 6, mounts, &MountLoad::deflection);
  list.value("bearing_in_total", "N", answers.load_sharing->bearing_in_total);
}

}  // namespace

const AnswerWriter static_results = {
    .has_answer = [](const project::Case&, const study::Answers& answers) { return answers.statics.has_value(); },
    .json = json::statics,
    .tables = {{"static.csv", static_csv}},
    .text = static_text,
    .arrays = static_arrays,
};

const AnswerWriter load_sharing_results = {
    .has_answer = [](const project::Case&, const study::Answers& answers) { return answers.load_sharing.has_value(); },
    .json = json::load_sharing,
    .tables = {{"load_sharing.csv", load_sharing_csv}},
    .text = [](const project::Case&, const study::Answers&) { return std::string(); },
    .arrays = load_sharing_arrays,
};

}  // namespace trivet::results
