// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/map_reader.h"

#include <fmt/format.h>

#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/amplitude_limits.h"
#include "trivet/project/analyses/map_axes_reader.h"
#include "trivet/project/text/idle_key.h"

namespace trivet::project {
namespace {

/// Keys that select what no rule of this map uses.
void warn_of_idle_keys(TableReader& reader, bool has_limits, bool asks_for_peaks) {
  if (!has_limits && reader.has("band"))
    warn_of_idle_key(reader, "band", "a band without limits",
                     "the band applies to limits of amplitudes; resonance peaks count at all frequencies",
                     "add limits, or remove it");
  for (const char* key : {"min_prominence", "peak_tolerance"})
    if (!asks_for_peaks && reader.has(key))
      warn_of_idle_key(reader, key, std::string(key) + " without no_peak", "it selects the peaks that count",
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
void read_presence_of_rules(TableReader& root, TableReader& analyses, TableReader& reader, const NamesInFile& in_file,
                            MapRequest& request) {
  const Node* limits = reader.table("limits");
  const Node* no_peak = reader.node("no_peak");
  const Node* required = root.has("requirements") ? root.node("requirements") : nullptr;
  const bool asks_for_peaks =
      (no_peak && !(no_peak->kind == Node::Kind::array && no_peak->items.empty())) ||  // readable or not
      (required && required->find("no_peak"));
  const bool has_limits = reader.has("limits") ? limits && !limits->keys.empty()
                                               : root.has("limits") || (required && required->find("limits"));
  const bool judges_more = required || !in_file.clearances.empty();
  if (!asks_for_peaks && !has_limits && !judges_more)
    reader.error("", "neither limits nor no_peak", "a map needs rules that its designs must meet",
                 "add limits = {\"BODY.x\" = \"1 mm\"}, no_peak = \"coordinates\", [limits], [requirements] or "
                 "[clearances]");
  if (in_file.harmonic_excitations.empty() && (asks_for_peaks || has_limits || !judges_more))
    analyses.error("map",
                   "no harmonic excitation in the model" +
                       (other_excitations(in_file).empty() ? "" : ": " + other_excitations(in_file)),
                   "a map checks amplitudes under harmonic forces (types harmonic, base, unbalance)",
                   "add [excitations.NAME] with type = \"harmonic\"");
  request.limits_of_file = !reader.has("limits");
  request.own_no_peak = no_peak != nullptr;
  request.own_band = reader.has("band");
  request.own_excitations = reader.has("excitations");
  request.own_peak_shares = reader.has("peak_tolerance") || reader.has("min_prominence");
  warn_of_idle_keys(reader, has_limits, asks_for_peaks);
}

}  // namespace

void read_map(TableReader& root, TableReader& analyses, const ResultNames& names, const NamesInFile& in_file,
              Analyses& result) {
  const Node* table = analyses.table("map");
  if (!table) return;
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
  if (reader.has("pairs")) read_pairs(root, reader, result.parameters, request);
  else read_axes(root, reader, result.parameters, request);
  if (reader.node("band")) request.band = read_band(reader, "band");
  if (reader.node("excitations")) request.excitations = read_selected_harmonic(reader, in_file);
  if (const auto quantity = read_quantity(reader)) request.quantity = *quantity;
  request.limits = read_amplitude_limits(reader, "limits", names, request.quantity);
  request.no_peak = read_no_peak(reader, names, request.quantity);
  read_peak_shares(reader, request.min_prominence, request.peak_tolerance);
  read_marked_cases(root, reader, request);
  read_presence_of_rules(root, analyses, reader, in_file, request);
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
