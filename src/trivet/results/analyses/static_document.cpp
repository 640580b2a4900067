// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "trivet/documents/shown_numbers.h"
#include "trivet/results/format/result_writer.h"

/// Static displacements and forces.
namespace trivet::results {
namespace {

using nonlinear::RestState;
using response::StaticValue;

/// A place with its values, a row of what people read.
struct PlaceAtRest {
  std::string name;
  std::array<std::optional<double>, 6> values;
};

/// One table for people.
struct PlacesAtRest {
  const char *title, *heading;
  std::array<const char*, 2> units;     ///< of the first three components and of the others
  std::vector<std::string> components;  ///< ends of the names of results
};
const std::vector<PlacesAtRest>& all_places_at_rest() {
  static const std::vector<PlacesAtRest> list = {
      {"Static displacements",
       "body or point",
       {"m", "rad"},
       {model::coordinate_names.begin(), model::coordinate_names.end()}},
      {"Static relative motions",
       "relative motion",
       {"m", "rad"},
       {model::relative_components.begin(), model::relative_components.end()}},
      {"Static approach", "clearance", {"m", "rad"}, {model::approach_component}},
      {"Static forces and moments",
       "forces of",
       {"N", "N m"},
       {"force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z"}}};
  return list;
}

std::vector<PlaceAtRest> places_at_rest(const std::vector<StaticValue>& values, const PlacesAtRest& kind) {
  LargestOfKind largest;
  for (const StaticValue& value : values) largest.add(value.unit, value.value);
  std::vector<PlaceAtRest> places;
  for (const StaticValue& value : values)
    for (std::size_t k = 0; k < kind.components.size(); ++k) {
      const std::string end = "." + kind.components[k];
      if (value.unit != kind.units[k / 3] || !value.name.ends_with(end)) continue;
      const std::string name = value.name.substr(0, value.name.size() - end.size());
      auto place = std::ranges::find(places, name, &PlaceAtRest::name);
      if (place == places.end()) place = places.insert(place, PlaceAtRest{name, {}});
      place->values[k] = largest.shown(value.unit, value.value);
    }
  return places;
}

Table rest_table(const std::vector<StaticValue>& values, const PlacesAtRest& kind) {
  const Rows row(places_at_rest(values, kind));
  Table table{.title = kind.title,
              .rows = row.size(),
              .columns = {row("place", Kind::words, kind.heading, &PlaceAtRest::name)},
              .one_prefix = true,
              .forms = for_people};
  for (std::size_t k = 0; k < kind.components.size(); ++k)
    table.columns.push_back(row(kind.components[k], Kind::quantity, kind.components[k],
                                [k](const PlaceAtRest& place) { return place.values[k]; },
                                {.unit = kind.units[k / 3], .digits = 7}));
  return table;
}

Table value_table(const std::vector<StaticValue>& values) {
  const Rows row(values);
  return {
      .key = "results",
      .axis = "result",
      .plain_names = true,
      .file = "static.csv",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "", &StaticValue::name), row("unit", Kind::words, "", &StaticValue::unit),
                  row("value", Kind::quantity, "", &StaticValue::value)},
      .arrays = {{"result", "name"}, "unit", "value"},
      .forms = for_programs};
}

json::Json deflections_json(const RestState& state) {
  json::Json deflections = json::Json::object();
  for (const auto& [name, value] : state.deflections) deflections[name] = value;
  return deflections;
}

const char* unit_at_rest(const std::pair<std::string, double>& deflection) {
  return deflection.first.find(".r", deflection.first.rfind('.')) != std::string::npos ? "rad" : "m";
}

/// Deflections of the nonlinear parts in every position of rest.
void add_states(const std::vector<RestState>& states, Document& document) {
  if (states.empty()) return;
  const Rows state(states);
  document.add(Table{.key = "states",
                     .axis = "state",
                     .rows = state.size(),
                     .columns = {state("stable", Kind::yes_no, "", &RestState::stable),
                                 state("deflections", Kind::words, "", deflections_json, {.forms = in_json})},
                     .forms = for_programs});
  const Rows row(states.front().deflections);
  Table& table = document.add(Table{
      .title =
          fmt::format("Positions of rest: {} found from many starts, which proves no others absent", states.size()),
      .rows = row.size(),
      .columns = {row("name", Kind::words, "deflection", &std::pair<std::string, double>::first),
                  row("unit", Kind::words, "", unit_at_rest)},
      .forms = for_people});
  for (std::size_t i = 0; i < states.size(); ++i)
    table.columns.push_back(row(fmt::format("{}", i + 1), Kind::quantity,
                                fmt::format("{}{}", i + 1, states[i].stable ? " stable" : " unstable"),
                                [&states, i](std::size_t d) { return states[i].deflections[d].second; },
                                {.digits = 9}));
  Curves& curves = document.add(Curves{.axis = "state", .forms = 0});
  for (std::size_t d = 0; d < row.size(); ++d) {
    std::vector<double> values;
    for (const RestState& one : states) values.push_back(one.deflections[d].second);
    const auto& deflection = states.front().deflections[d];
    curves.list.push_back({.name = deflection.first + " at rest",
                           .unit = unit_at_rest(deflection),
                           .values = std::move(values),
                           .forms = in_arrays});
  }
}

Document static_document(const project::Case& variant, const study::CaseResults& results) {
  const response::StaticResponse& found = *results.statics;
  Document document;
  document.add(value_table(found.values));
  for (const PlacesAtRest& kind : all_places_at_rest()) document.add(rest_table(found.values, kind));
  document.add(Single{.name = "backward_error", .value = found.backward_error});
  document.add(
      Sentence{.parts = {fmt::format("Under gravity and the constant forces; round-off is shown as 0. Backward "
                                     "error of the solution: {:.3g}.",
                                     found.backward_error)},
               .place = Sentence::Place::note,
               .forms = on_screen | on_page});
  add_load_sharing(variant, results, document);
  document.add(warnings_part(results));
  add_states(results.rest_states, document);
  return document;
}

}  // namespace

const ResultWriter static_results = {
    .has_result = [](const project::Case&, const study::CaseResults& results) { return results.statics.has_value(); },
    .document = static_document,
    .files = {"static.csv"}};

}  // namespace trivet::results
