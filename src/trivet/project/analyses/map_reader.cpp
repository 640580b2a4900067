// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/map_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/design_axis_reader.h"
#include "trivet/project/analyses/limits_reader.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {

namespace {

/// Keys that select what no rule of this map uses.
void warn_of_idle_keys(TableReader& reader, bool has_limits, bool needs_peaks) {
  if (!has_limits && reader.has("band"))
    warn_at_key(reader, "band", "a band without limits",
                "the band applies to limits of amplitudes; resonance peaks count at all frequencies",
                "add limits, or remove it");
  for (const char* key : {"min_prominence", "peak_tolerance"})
    if (!needs_peaks && reader.has(key))
      warn_at_key(reader, key, std::string(key) + " without no_peak", "it selects the peaks that count",
                  "add no_peak, or remove it");
}

/// Reads `cases`.
void read_marked_cases(TableReader& root, TableReader& reader, MapRequest& request) {
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
}

/// Notes which rules the map has of its own, and reports a map without any.
void read_presence_of_rules(TableReader& root, TableReader& analyses, TableReader& reader, const SymbolTable& symbols,
                            MapRequest& request) {
  const Node* limits = reader.table("limits");
  const Node* no_peak = reader.node("no_peak");
  const Node* required = root.has("requirements") ? root.node("requirements") : nullptr;
  const bool needs_peaks =
      (no_peak && !(no_peak->kind == Node::Kind::array && no_peak->items.empty())) ||  // readable or not
      (required && required->find("no_peak"));
  const bool has_limits = reader.has("limits") ? limits && !limits->keys.empty()
                                               : root.has("limits") || (required && required->find("limits"));
  const bool judges_more = required || !symbols.clearances.empty();
  if (!needs_peaks && !has_limits && !judges_more)
    reader.error("", "neither limits nor no_peak", "a map needs rules that its designs must meet",
                 "add limits = {\"BODY.x\" = \"1 mm\"}, no_peak = \"coordinates\", [limits], [requirements] or "
                 "[clearances]");
  if (symbols.harmonic_excitations.empty() && (needs_peaks || has_limits || !judges_more))
    analyses.error("map",
                   "no harmonic excitation in the model" +
                       (other_excitations(symbols).empty() ? "" : ": " + other_excitations(symbols)),
                   "a map checks amplitudes under harmonic forces (types harmonic, base, unbalance)",
                   "add [excitations.NAME] with type = \"harmonic\"");
  request.limits_of_file = !reader.has("limits");
  request.own_no_peak = no_peak != nullptr;
  request.own_band = reader.has("band");
  request.own_excitations = reader.has("excitations");
  request.own_peak_shares = reader.has("peak_tolerance") || reader.has("min_prominence");
  warn_of_idle_keys(reader, has_limits, needs_peaks);
}

}  // namespace

void read_map(TableReader& root, TableReader& analyses, const ResultNames& names, const SymbolTable& symbols,
              Analyses& result) {
  const Node* table = analyses.table("map");
  if (!table) return;
  TableReader reader(*table, "analyses.map", root.problems());
  MapRequest request;
  if (reader.has("pairs")) read_pairs(root, reader, result.parameters, request);
  else read_axes(root, reader, result.parameters, request);
  read_scope(reader, symbols, result, request);
  request.limits = read_amplitude_limits(reader, "limits", names, request.quantity, Levels::of_harmonic);
  request.no_peak = read_no_peak(reader, names, request.quantity);
  read_peak_shares(reader, request.min_prominence, request.peak_tolerance);
  read_marked_cases(root, reader, request);
  read_presence_of_rules(root, analyses, reader, symbols, request);
  reader.finish();
  result.map = std::move(request);
}

void use_limits_of_file(Analyses& analyses) {
  if (!analyses.map || !analyses.map->limits_of_file) return;
  const assembly::MotionQuantity quantity =
      analyses.response ? analyses.response->selection.quantity : assembly::MotionQuantity::displacement;
  for (const Limit& limit : analyses.limits) analyses.map->limits.push_back({limit.name, quantity, limit.amplitude});
}

namespace {

constexpr std::size_t most_pairs = 36;  // as many as a picture shows

/// Reads `points`, the designs along an axis.
std::optional<int> read_points(TableReader& reader) {
  const auto points = reader.number("points", Quantity::pure);
  if (!points) return std::nullopt;
  if (*points >= 2 && *points <= most_designs && *points == std::floor(*points)) return static_cast<int>(*points);
  reader.error("points", fmt::format("{:.6g}", *points),
               fmt::format("a whole number from 2 to {:.0f} is expected", most_designs), "change it");
  return std::nullopt;
}

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
  const auto named = std::ranges::find(parameters, parameter, &DesignAxis::name);
  if (named != parameters.end()) {
    axis = *named;
    axis.name = reader.text("name").value_or(axis.name);
    if (reader.has("from") || reader.has("to")) read_range(reader, axis);
    else if (const auto spacing = reader.choice("spacing", {"linear", "logarithmic"}))
      axis.logarithmic = *spacing == "logarithmic" && axis.from > 0;
  } else {
    axis.parameter = parameter;
    axis.places = {{parameter, 1}};
    axis.quantity = quantity_at(root.content(), path_keys(parameter));
    const Node* node = reader.node("parameter");
    if (node && node->kind == Node::Kind::text) check_model_path(root, reader, "parameter", parameter);
    axis.name = reader.text("name").value_or(parameter);
    read_range(reader, axis);
  }
  axis.points = read_points(reader).value_or(axis.points);
  reader.finish();
  return axis;
}

/// One pair of parameters; none if it has problems.
std::optional<std::pair<DesignAxis, DesignAxis>> read_pair(TableReader& root, TableReader& map, const Node& pair,
                                                           const std::vector<DesignAxis>& parameters) {
  const auto refuse = [&](const std::string& finding, const std::string& rule, const std::string& remedy) {
    map.error("pairs", finding, rule, remedy).origin = pair.origin;
    return std::nullopt;
  };
  const bool two_texts = pair.kind == Node::Kind::array && pair.items.size() == 2 &&
      std::ranges::all_of(pair.items, [](const Node& n) { return n.kind == Node::Kind::text; });
  if (!two_texts)
    return refuse(value_text(pair), "a pair is a list of two names in [parameters]",
                  "for instance pairs = [[\"mount stiffness\", \"spread\"]]");
  const std::string first = pair.items[0].text, second = pair.items[1].text;
  if (first == second)
    return refuse(foundation::quoted(first) + " twice", "a map has two different parameters", "name another one");
  std::vector<DesignAxis> axes;
  for (const std::string& name : {first, second}) {
    const auto named = std::ranges::find(parameters, name, &DesignAxis::name);
    if (named != parameters.end()) {
      axes.push_back(*named);
      continue;
    }
    const Node* table = root.has("parameters") ? root.node("parameters") : nullptr;
    if (table && table->find(name))  // a choice of mounts, or a parameter that could not be read
      return refuse(foundation::quoted(name), "an axis is a range of numbers", "name a parameter with from and to");
    std::vector<std::string> known;
    for (const DesignAxis& parameter : parameters) known.push_back(parameter.name);
    const std::string guess = foundation::nearest_name(name, known);
    return refuse(foundation::quoted(name), "no parameter has this name",
                  guess.empty() ? "write [parameters.NAME] with path, from and to" : "did you mean \"" + guess + "\"?");
  }
  return std::pair{axes[0], axes[1]};
}

}  // namespace

void read_axes(TableReader& root, TableReader& map, const std::vector<DesignAxis>& parameters, MapRequest& request) {
  request.x = read_axis(root, map, "x", parameters);
  request.y = read_axis(root, map, "y", parameters);
  if (!request.x.parameter.empty() && path_keys(request.x.parameter) == path_keys(request.y.parameter))
    map.error("y", "\"" + request.y.parameter + "\" on both axes", "a map has two different parameters",
              "name another number");
  if (static_cast<double>(request.x.points) * request.y.points > most_designs)
    map.error("x", fmt::format("{} × {} designs", request.x.points, request.y.points),
              fmt::format("a map holds at most {:.0e} designs", most_designs), "take fewer points");
}

void read_pairs(TableReader& root, TableReader& map, const std::vector<DesignAxis>& parameters, MapRequest& request) {
  for (const char* key : {"x", "y"})
    if (map.has(key))
      map.error(key, std::string(key) + " and pairs", "pairs bring the axes of their maps", "remove one of them");
  map.also_known({"x", "y"});
  const Node& pairs = *map.node("pairs");
  if (pairs.kind != Node::Kind::array || pairs.items.empty())
    return static_cast<void>(map.error("pairs", value_text(pairs), "a list of pairs of parameters is expected",
                                       "for instance pairs = [[\"mount stiffness\", \"spread\"]]"));
  const std::optional<int> points = read_points(map);
  if (points && static_cast<double>(*points) * *points > most_designs)
    map.error("points", fmt::format("{0} × {0} designs", *points),
              fmt::format("a map holds at most {:.0e} designs", most_designs), "take fewer points");
  if (pairs.items.size() > most_pairs)
    map.error("pairs", fmt::format("{} pairs", pairs.items.size()), fmt::format("at most {} maps", most_pairs),
              "name the pairs that matter");
  for (const Node& item : pairs.items) {
    auto pair = read_pair(root, map, item, parameters);
    if (!pair) continue;
    for (DesignAxis* axis : {&pair->first, &pair->second}) axis->points = points.value_or(axis->points);
    const bool known = std::ranges::any_of(request.pairs, [&](const auto& other) {
      return (other.first.name == pair->first.name && other.second.name == pair->second.name) ||
          (other.first.name == pair->second.name && other.second.name == pair->first.name);
    });
    if (known)
      map.error("pairs", foundation::quoted(pair->first.name) + " and " + foundation::quoted(pair->second.name),
                "the list names this pair twice", "name it once")
          .origin = item.origin;
    request.pairs.push_back(std::move(*pair));
  }
  if (!request.pairs.empty()) std::tie(request.x, request.y) = request.pairs.front();
}

}  // namespace trivet::project
