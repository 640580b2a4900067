// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/project/analyses/analysis_reader.h"

namespace trivet::project {
namespace {

constexpr double most_time_points = 20'000'000;

std::vector<std::pair<std::string, double>> read_initial(TableReader& reader, const std::string& key,
                                                         const ResultNames& names,
                                                         const std::vector<std::string>& nodes,
                                                         assembly::MotionQuantity quantity) {
  std::vector<std::pair<std::string, double>> values;
  const Node* table = reader.table(key);
  if (!table) return values;
  TableReader inside(*table, reader.path() + "." + key, reader.problems());
  for (const std::string& name : table->keys) {
    const auto measured = names.component(name, quantity);
    const bool coordinate =
        measured && *measured != Quantity::force && *measured != Quantity::moment && std::ranges::count(name, '.') == 1;
    if (!coordinate) {
      inside.error(name, "no such coordinate",
                   "initial values belong to free coordinates of bodies, in quotes: \"BODY.z\"", "check the name");
      continue;
    }
    if (std::ranges::find(nodes, name.substr(0, name.find('.'))) != nodes.end()) {
      inside.error(name, "a coordinate of a node", "a node has no mass: it starts where the elements hold it at rest",
                   "remove it");
      continue;
    }
    if (const auto value = inside.number(name, *measured)) values.emplace_back(name, *value);
  }
  return values;
}

TransientAnalysis read_transient(TableReader& reader, const ResultNames& names, const SymbolTable& symbols) {
  TransientAnalysis request;
  read_selection(reader, names, symbols.time_excitations, "time", request.selection);
  request.from = reader.number("from", Quantity::time).value_or(0);
  request.to = reader.number("to", Quantity::time);
  request.step = reader.number("step", Quantity::time);
  if (request.to && !(*request.to > request.from))
    reader.error("to", fmt::format("{:.6g} s", *request.to), "the end must be after the start",
                 "give `to` above `from`");
  if (request.step && !(*request.step > 0))
    reader.error("step", fmt::format("{:.6g} s", *request.step), "a step is > 0", "correct it");
  if (request.step && request.to && *request.step > *request.to - request.from && *request.to > request.from)
    reader.error("step", fmt::format("{:.6g} s", *request.step), "it is at most the time between `from` and `to`",
                 "take a shorter step");
  if (request.step && request.to && *request.step > 0 &&
      (*request.to - request.from) / *request.step > most_time_points)
    reader.error("step", fmt::format("{:.3g} points", (*request.to - request.from) / *request.step),
                 fmt::format("at most {:.0f} points are computed at once", most_time_points), "take a longer step");
  request.nearest_linear_system = reader.boolean("nearest_linear_system").value_or(false);
  request.displacements =
      read_initial(reader, "initial_displacement", names, symbols.nodes, assembly::MotionQuantity::displacement);
  request.velocities =
      read_initial(reader, "initial_velocity", names, symbols.nodes, assembly::MotionQuantity::velocity);
  return request;
}

bool starts_from_initial_values(const Node& table) {
  return table.find("initial_displacement") || table.find("initial_velocity");
}

}  // namespace

const AnalysisReader transient_analysis = read_into<&Analyses::transient, read_transient>(
    {.drive = Drive::time,
     .of_large_systems = true,
     .moves_by_itself = starts_from_initial_values,
     .keys = R"json({"description": "motion over time after pulses, histories and an initial state",
  "properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "from": {"$ref": "#/$defs/number", "description": "s: beginning of the time (default: 0)"},
   "to": {"$ref": "#/$defs/number", "description": "s: end of the time (default: up to ten periods of the slowest excited mode after the last corner)"},
   "step": {"$ref": "#/$defs/number", "description": "s: between the rows of the result (default: 1/20 of the shortest period)"},
   "nearest_linear_system": {"type": "boolean", "description": "in place of elements that depend on frequency (default: false)"},
   "initial_displacement": {"type": "object", "additionalProperties": {"$ref": "#/$defs/number", "description": "from rest: m, or rad of a rotation"}, "description": "BODY.x = value just before the beginning"},
   "initial_velocity": {"type": "object", "additionalProperties": {"$ref": "#/$defs/number", "description": "m/s, or rad/s of a rotation"}, "description": "BODY.x = value just before the beginning"}}})json"});

}  // namespace trivet::project
