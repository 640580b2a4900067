// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/request_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/design_axis_reader.h"
#include "trivet/project/analyses/map_reader.h"
#include "trivet/project/analyses/map_requirements.h"

namespace trivet::project {
namespace {

constexpr int most_points = 2'000'000;

/// Reports a steady response without a harmonic excitation.
void check_driven(TableReader& analyses, const std::string& key, const SymbolTable& symbols) {
  if (symbols.harmonic_excitations.empty())
    analyses.error(key, "no harmonic excitation in the model", "a response needs an excitation",
                   "add [excitations.NAME] with type = \"harmonic\"");
}

ResponseRequest read_response(const Node& node, const ResultNames& names, const SymbolTable& symbols,
                              foundation::Problems& problems) {
  TableReader reader(node, "analyses.response", problems);
  ResponseRequest request;
  read_selection(reader, names, symbols.harmonic_excitations, "harmonic", request.selection);
  request.band = read_band(reader, "band");
  const auto spacing = reader.choice("spacing", {"automatic", "linear", "logarithmic"});
  if (spacing == "linear") request.spacing = Spacing::linear;
  if (spacing == "logarithmic") request.spacing = Spacing::logarithmic;
  if (request.spacing == Spacing::logarithmic && request.band && !(request.band->from > 0))
    reader.error("band", "a band from 0", "a logarithmic grid starts above 0", "raise the lower end");
  if (const auto points = reader.number("points", Quantity::pure)) {
    if (*points >= 2 && *points <= most_points && *points == static_cast<int>(*points))
      request.points = static_cast<int>(*points);
    else
      reader.error("points", fmt::format("{:.6g}", *points),
                   fmt::format("a whole number from 2 to {} is expected", most_points), "change it");
    if (!reader.has("spacing") || spacing == "automatic")
      reader.error("points", "points without spacing", "an automatic grid chooses its points itself",
                   "add spacing = \"linear\" or \"logarithmic\"");
  }
  if (const auto at = reader.numbers("at", Quantity::angular_frequency)) {
    for (std::size_t i = 0; i < at->size(); ++i)
      if ((*at)[i] < 0) reader.error("at", value_text(*reader.node("at"), i), "a frequency is ≥ 0", "remove the sign");
    if (at->empty()) reader.error("at", "an empty list", "at least one frequency is expected", "give one, or a band");
    if (reader.has("band")) reader.error("at", "at and band", "only one of them sets the frequencies", "remove one");
    for (const char* key : {"spacing", "points"})
      if (reader.has(key))
        reader.error(key, std::string(key) + " together with at", "single frequencies have no grid",
                     "remove it, or give a band in place of at");
    request.at = *at;
  }
  request.continuous_phase = reader.choice("phase", {"wrapped", "continuous"}) == "continuous";
  reader.finish();
  return request;
}

PeaksRequest read_peaks(const Node& node, const ResultNames& names, const SymbolTable& symbols,
                        const std::optional<ResponseRequest>& response, foundation::Problems& problems) {
  TableReader reader(node, "analyses.peaks", problems);
  PeaksRequest request;
  if (response) request.selection = response->selection;  // by default the peaks of the same curves
  read_selection(reader, names, symbols.harmonic_excitations, "harmonic", request.selection);
  read_peak_shares(reader, request.min_prominence, request.peak_tolerance);
  reader.finish();
  return request;
}

/// The limit of another motion than that of the response: "0.5 mm/s rms" of a displacement.
bool refuse_other_motion(TableReader& reader, const ResultNames& names, const std::string& name,
                         assembly::MotionQuantity of_response) {
  const Node* value = reader.node(name);
  if (value->kind != Node::Kind::text ||
      to_si_at_level(value->text, *names.component(name, of_response), Levels::of_harmonic))
    return false;
  for (const assembly::MotionQuantity quantity : assembly::motion_quantities)
    if (to_si_at_level(value->text, *names.component(name, quantity), Levels::of_harmonic)) {
      reader.error(name, value_text(*value),
                   fmt::format("[limits] bounds the curves of analyses.response, which has quantity = \"{}\"",
                               assembly::motion_name(of_response)),
                   fmt::format("add quantity = \"{}\" to response, or give it in limits of [requirements], which may "
                               "be of any motion",
                               assembly::motion_name(quantity)));
      return true;
    }
  return false;
}

std::vector<Limit> read_limits(TableReader& root, const ResultNames& names,
                               const std::optional<ResponseRequest>& response, bool quantity_is_clear, bool judged) {
  std::vector<Limit> limits;
  const Node* table = root.table("limits");
  if (!table) return limits;
  if (!response && !judged)
    root.error("limits", "no response to compare with", "limits apply to the band of analyses.response",
               "add response = {…} to [analyses]");
  TableReader reader(*table, "limits", root.problems());
  for (const std::string& name : table->keys) {
    if (name == "accept") continue;
    const auto measured =
        names.component(name, response ? response->selection.quantity : assembly::MotionQuantity::displacement);
    if (!measured) {
      refuse_limit(reader, names, name);
      continue;
    }
    if (!quantity_is_clear) continue;  // its unit depends on what could not be read
    if (const Node* value = reader.node(name); value->kind == Node::Kind::array) {
      reader.error(name, "a list", "[limits] has one number for each result",
                   "several limits of one result belong to [analyses.map.limits]");
      continue;
    }
    if (refuse_other_motion(reader, names, name,
                            response ? response->selection.quantity : assembly::MotionQuantity::displacement))
      continue;
    const auto amplitude = reader.number(name, *measured, Levels::of_harmonic);
    if (amplitude && !(*amplitude > 0))
      reader.error(name, fmt::format("{:.6g} {}", *amplitude, si_unit(*measured)), "a limit is > 0", "change it");
    if (amplitude) limits.push_back({name, *amplitude});
  }
  return limits;
}

int read_lowest(const Node& node, foundation::Problems& problems) {
  constexpr double most = 1e6;
  TableReader reader(node, "analyses.modes", problems);
  const auto lowest = reader.number("lowest", Quantity::pure);
  const bool good = !lowest || (*lowest >= 1 && *lowest <= most && *lowest == std::floor(*lowest));
  if (!good)
    reader.error("lowest", fmt::format("{:.6g}", *lowest), "a whole number of modes ≥ 1 is expected",
                 "change it, or leave it out for all modes");
  reader.finish();
  return lowest && good ? static_cast<int>(*lowest) : 0;
}

std::vector<std::string> read_static(const Node& node, const ResultNames& names, const SymbolTable& symbols,
                                     bool& all_states, foundation::Problems& problems) {
  TableReader reader(node, "analyses.static", problems);
  std::vector<std::string> of = {"coordinates"};
  of.insert(of.end(), symbols.elements.begin(), symbols.elements.end());
  of.push_back("ground");
  read_of(reader, names, of);
  const auto states = reader.choice("states", {"reached", "all"});
  all_states = states && *states == "all";
  reader.finish();
  return of;
}

}  // namespace

Analyses read_analyses(TableReader& root, const SymbolTable& symbols) {
  Analyses analyses;
  const ResultNames names(symbols);
  bool quantity_is_clear = true;
  analyses.parameters = read_parameters(root);
  analyses.tolerances = read_tolerances(root);
  if (const Node* table = root.table("analyses")) {
    TableReader reader(*table, "analyses", root.problems());
    if (const Node* node = reader.table("modes")) {
      analyses.modes = true;
      analyses.lowest_modes = read_lowest(*node, root.problems());
    }
    if (const Node* node = reader.table("roots")) {
      analyses.roots = true;
      TableReader(*node, "analyses.roots", root.problems()).finish();
    }
    if (const Node* node = reader.table("response")) {
      check_driven(reader, "response", symbols);
      const std::size_t before = root.problems().errors();
      analyses.response = read_response(*node, names, symbols, root.problems());
      quantity_is_clear = root.problems().errors() == before || !node->find("quantity");
    }
    if (const Node* node = reader.table("peaks")) {
      if (!analyses.response) check_driven(reader, "peaks", symbols);
      analyses.peaks = read_peaks(*node, names, symbols, analyses.response, root.problems());
    }
    if (const Node* node = reader.table("static")) {
      analyses.static_of = read_static(*node, names, symbols, analyses.all_rest_states, root.problems());
      if (!root.has("gravity") && symbols.constant_excitations.empty() && !analyses.all_rest_states)
        reader.error("static", "neither gravity nor a constant force", "a static analysis needs a load",
                     "give gravity = [0, 0, -9.80665] or an excitation of type \"constant\"");
      analyses.load_sharing = root.has("gravity");
    }
    read_independent_analyses(reader, false, names, symbols, analyses);
    read_map(root, reader, names, symbols, analyses);
    read_optimize(root, reader, names, symbols, analyses);
    analyses.sample = read_sample(root, reader, names, analyses.response);
    analyses.box = read_box(root, reader);
    reader.finish();
  }
  read_independent_analyses(root, true, names, symbols, analyses);
  read_limit_lines(root, names, symbols, analyses);
  analyses.limits = read_limits(root, names, analyses.response, quantity_is_clear,
                                (analyses.map && analyses.map->limits_of_file) || root.has("requirements"));
  use_limits_of_file(analyses);
  read_requirements(root, names, symbols, analyses);
  use_requirements(analyses);
  return analyses;
}

}  // namespace trivet::project
