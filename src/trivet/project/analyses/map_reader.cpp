// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/map_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/amplitude_limits.h"
#include "trivet/project/analyses/design_axis_reader.h"
#include "trivet/project/text/idle_key.h"
#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

DesignAxis read_axis(TableReader& root, TableReader& map, const std::string& key,
                     const std::vector<DesignAxis>& parameters) {
  DesignAxis axis;
  const Node* table = map.table(key);
  if (!table) {
    if (!map.has(key)) map.missing(key, key + " = {parameter = \"elements.mount.scale\", from = 0.5, to = 2}");
    return axis;
  }
  TableReader reader(*table, "analyses.map." + key, root.problems());
  const std::string parameter = reader.required_text("parameter");
  const auto named =
      std::find_if(parameters.begin(), parameters.end(), [&](const DesignAxis& one) { return one.name == parameter; });
  if (named != parameters.end()) {
    axis = *named;
    axis.name = reader.text("name").value_or(axis.name);
    if (reader.has("from") || reader.has("to")) read_range(reader, axis);
    else if (const auto spacing = reader.choice("spacing", {"linear", "logarithmic"}))
      axis.logarithmic = *spacing == "logarithmic" && axis.from > 0;
  } else {
    axis.parameter = parameter;
    axis.places = {{parameter, 1}};
    const Node* node = reader.node("parameter");
    if (node && node->kind == Node::Kind::text) check_model_path(root, reader, "parameter", parameter);
    axis.name = reader.text("name").value_or(parameter);
    read_range(reader, axis);
  }
  if (const auto points = reader.number("points", Quantity::pure)) {
    if (*points >= 2 && *points <= most_designs && *points == std::floor(*points))
      axis.points = static_cast<int>(*points);
    else
      reader.error("points", fmt::format("{:.6g}", *points),
                   fmt::format("a whole number from 2 to {:.0f} is expected", most_designs), "change it");
  }
  reader.finish();
  return axis;
}

}  // namespace

void read_map(TableReader& root, TableReader& analyses, const ResultNames& names, const NamesInFile& in_file,
              Analyses& result) {
  const Node* table = analyses.table("map");
  if (!table) return;
  if (in_file.harmonic_excitations.empty())
    analyses.error("map",
                   "no harmonic excitation in the model" +
                       (other_excitations(in_file).empty() ? "" : ": " + other_excitations(in_file)),
                   "a map checks amplitudes under harmonic forces (types harmonic, base, unbalance)",
                   "add [excitations.NAME] with type = \"harmonic\"");
  TableReader reader(*table, "analyses.map", root.problems());
  MapRequest request;
  if (result.response) {
    request.band = result.response->band;
    request.quantity = result.response->selection.quantity;
    request.excitations = result.response->selection.excitations;
  }
  if (result.peaks) {
    request.min_prominence = result.peaks->min_prominence;
    request.peak_tolerance = result.peaks->peak_tolerance;
  }
  request.x = read_axis(root, reader, "x", result.parameters);
  request.y = read_axis(root, reader, "y", result.parameters);
  if (!request.x.parameter.empty() && path_keys(request.x.parameter) == path_keys(request.y.parameter))
    reader.error("y", "\"" + request.y.parameter + "\" on both axes", "a map has two different parameters",
                 "name another number");
  if (static_cast<double>(request.x.points) * request.y.points > most_designs)
    reader.error("x", fmt::format("{} × {} designs", request.x.points, request.y.points),
                 fmt::format("a map holds at most {:.0e} designs", most_designs), "take fewer points");
  if (reader.node("band")) request.band = read_band(reader, "band");
  if (reader.node("excitations")) request.excitations = read_selected_harmonic(reader, in_file);
  if (const auto quantity = read_quantity(reader)) request.quantity = *quantity;
  request.limits = read_amplitude_limits(reader, "limits", names, request.quantity);
  request.no_peak = read_no_peak(reader, names, request.quantity);
  read_peak_shares(reader, request.min_prominence, request.peak_tolerance);
  if (const auto cases = reader.texts("cases", R"(["NAME"])")) {
    const Node* known = root.node("cases");
    for (const std::string& name : *cases)
      if (!known || !known->find(name)) {
        const std::string guess = known ? foundation::nearest_name(name, known->keys) : "";
        reader.error("cases", foundation::quoted(name), "no case has this name",
                     guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
      }
    request.cases = *cases;
  }
  const Node* limits = reader.table("limits");
  const Node* no_peak = reader.node("no_peak");
  const bool asks_for_peaks =
      no_peak && !(no_peak->kind == Node::Kind::array && no_peak->items.empty());  // readable or not
  if (!asks_for_peaks && (reader.has("limits") ? limits && limits->keys.empty() : !root.has("limits")))
    reader.error("", "neither limits nor no_peak", "a map needs rules that its designs must meet",
                 "add limits = {\"BODY.x\" = \"1 mm\"}, no_peak = \"coordinates\", or [limits]");
  request.limits_of_file = !reader.has("limits");
  const bool has_limits = reader.has("limits") ? limits && !limits->keys.empty() : root.has("limits");
  if (!has_limits && reader.has("band"))
    warn_of_idle_key(reader, "band", "a band without limits",
                     "the band applies to limits of amplitudes; resonance peaks count at all frequencies",
                     "add limits, or remove it");
  for (const char* key : {"min_prominence", "peak_tolerance"})
    if (!asks_for_peaks && reader.has(key))
      warn_of_idle_key(reader, key, std::string(key) + " without no_peak", "it selects the peaks that count",
                       "add no_peak, or remove it");
  reader.finish();
  result.map = std::move(request);
}

void use_limits_of_file(Analyses& analyses) {
  if (!analyses.map || !analyses.map->limits_of_file) return;
  const assembly::MotionQuantity quantity =
      analyses.response ? analyses.response->selection.quantity : assembly::MotionQuantity::displacement;
  for (const Limit& limit : analyses.limits) analyses.map->limits.push_back({limit.name, quantity, limit.amplitude});
}

}  // namespace trivet::project
