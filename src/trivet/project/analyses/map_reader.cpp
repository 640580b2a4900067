// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/map_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/amplitude_limits.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/idle_key.h"
#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

/// True if a blank is outside the quoted names.
bool has_stray_blank(const std::string& path) {
  char quote = 0;
  for (const char c : path) {
    if (quote == 0 && std::isspace(static_cast<unsigned char>(c))) return true;
    if (quote == 0 && (c == '"' || c == '\'')) quote = c;
    else if (c == quote) quote = 0;
  }
  return false;
}

/// Tables of adjustments, which the file need not have.
bool is_adjustment(const std::string& key) {
  static constexpr std::array<const char*, 4> tables = {"stiffness_factor", "moved", "center_moved",
                                                        "inertia_about_center"};
  return std::find(tables.begin(), tables.end(), key) != tables.end();
}

/// Checks that the path leads to a number of the model, or to a key that is not written and has a default.
void check_parameter(TableReader& root, TableReader& reader, const std::string& path) {
  const std::string shown = "\"" + path.substr(0, 80) + "\"";
  if (path.find('[') != std::string::npos)
    return static_cast<void>(reader.error("parameter", shown, "a path names its parts and has no indices",
                                          "name a number: \"elements.mount.scale\", \"elements.mount.at.y\" of an "
                                          "array of three, \"bodies.machine.mass\""));
  if (has_stray_blank(path))
    return static_cast<void>(reader.error(
        "parameter", shown, "a name with blanks needs quotes in a path",
        R"(write it without, "elements.mount.scale", or the name in quotes, 'elements."front left".scale')"));
  const std::vector<std::string> keys = path_keys(path);
  const std::vector<std::string> parts = {"bodies",      "nodes",   "elements",   "element_types",
                                          "excitations", "damping", "foundations"};
  if (keys.size() < 2 || std::find(parts.begin(), parts.end(), keys.front()) == parts.end()) {
    reader.error("parameter", shown, "an axis changes one number of the model, named by its path as in --set",
                 "for instance \"elements.mount.scale\" or \"bodies.machine.mass\"");
    return;
  }
  const Node* node = root.node(keys.front());
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const bool is_table = node && node->kind == Node::Kind::table;
    const Node* next = node ? node_at(*node, {keys[i]}) : nullptr;
    if (!next && is_table && i >= 2 && (i + 1 == keys.size() || is_adjustment(keys[i]) || is_zero_by_default(keys[i])))
      return;
    if (!next) {
      const std::string guess = is_table ? foundation::nearest_name(keys[i], node->keys) : "";
      reader.error("parameter", shown, fmt::format("the file has no \"{}\" there", foundation::shortened(keys[i])),
                   !guess.empty()                         ? "did you mean \"" + guess + "\"?"
                       : node && component_of(*node, "x") ? "the components of an array of three numbers are x, y and z"
                                                          : "check the path");
      return;
    }
    node = next;
  }
  const auto at_this_path = [&](const foundation::Problem& p) {
    return p.severity == foundation::Severity::error && p.subject == path;
  };
  if (!written_number(*node) &&
      std::none_of(root.problems().list().begin(), root.problems().list().end(), at_this_path))
    reader.error("parameter", shown,
                 fmt::format("it is {}, not a number",
                             node->kind == Node::Kind::text ? project::value_text(*node) : kind_name(node->kind)),
                 "name one number: those of an array of three are .x, .y and .z; a matrix is varied by the scale of "
                 "its element");
}

std::optional<WrittenNumber> end_of_range(TableReader& reader, const std::string& key) {
  const Node* node = reader.node(key);
  if (!node) {
    reader.missing(key, "give the range: from = …, to = …");
    return std::nullopt;
  }
  const auto number = written_number(*node);
  const bool good = number && std::isfinite(number->value) && !outside_range(number->value, Quantity::pure);
  if (!good)
    reader.error(key, value_text(*node),
                 "an end of the range is a finite number up to 1e30, or a text of a number and a unit",
                 "for instance from = 0.5, or from = \"5 mm\"");
  return good ? number : std::nullopt;
}

MapAxis read_axis(TableReader& root, TableReader& map, const std::string& key) {
  MapAxis axis;
  const Node* table = map.table(key);
  if (!table) {
    if (!map.has(key)) map.missing(key, key + " = {parameter = \"elements.mount.scale\", from = 0.5, to = 2}");
    return axis;
  }
  TableReader reader(*table, "analyses.map." + key, root.problems());
  axis.parameter = reader.required_text("parameter");
  const Node* parameter = reader.node("parameter");
  if (parameter && parameter->kind == Node::Kind::text) check_parameter(root, reader, axis.parameter);
  axis.name = reader.text("name").value_or(axis.parameter);
  axis.logarithmic = reader.choice("spacing", {"linear", "logarithmic"}) == "logarithmic";
  const auto from = end_of_range(reader, "from"), to = end_of_range(reader, "to");
  if (from && to && from->unit != to->unit)
    reader.error("to",
                 fmt::format("from = {}, to = {}", value_text(*table->find("from")), value_text(*table->find("to"))),
                 "both ends of a range have the same unit, or neither has one", "give both the same unit");
  else if (from && to) {
    axis.from = from->value;
    axis.to = to->value;
    axis.unit = from->unit;
    if (!(axis.from < axis.to))
      reader.error("to", fmt::format("from {:.6g} to {:.6g}", axis.from, axis.to),
                   "a range goes from the smaller to the larger number", "exchange or change them");
    else if (axis.logarithmic && !(axis.from > 0))
      reader.error("from", fmt::format("{:.6g}", axis.from), "a logarithmic range starts above 0",
                   "raise it; if 0 or less is a possible value, take spacing = \"linear\"");
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

double MapAxis::at(double share) const {
  if (share <= 0) return from;
  if (share >= 1) return to;
  return logarithmic ? from * std::exp(share * std::log(to / from)) : from + share * (to - from);
}

double MapAxis::share(double value) const {
  return logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
}

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
  request.x = read_axis(root, reader, "x");
  request.y = read_axis(root, reader, "y");
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
