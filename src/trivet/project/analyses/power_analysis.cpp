// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/request_readers.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

/// Mean power into the ground at each mount.
PowerAnalysis read_power(TableReader& reader, const ResultNames&, const SymbolTable& symbols) {
  PowerAnalysis request;
  request.selection.excitations = read_selected(reader, symbols.harmonic_excitations, "harmonic");
  request.band = read_band(reader, "band");
  request.at = read_single_frequencies(reader);
  return request;
}

}  // namespace

const AnalysisReader power_analysis = read_into<&Analyses::power, read_power>(
    {.drive = Drive::harmonic,
     .searches_peaks = true,
     .keys = R"json({"description": "power that the excitations feed and the dampers dissipate, over frequency",
  "properties": {
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "band": {"$ref": "#/$defs/band"},
   "at": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 1,
     "description": "single frequencies told besides, rad/s or with a unit"}}})json"});

}  // namespace trivet::project
