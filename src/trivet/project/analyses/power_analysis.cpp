// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

/// Mean power into the ground at each mount.
std::unique_ptr<Analysis> read_power(TableReader& reader, const ResultNames&, const SymbolTable& symbols) {
  auto request = std::make_unique<BandAnalysis>();
  request->selection.excitations = read_selected(reader, symbols.harmonic_excitations, "harmonic");
  request->band = read_band(reader, "band");
  return request;
}

}  // namespace

const AnalysisReader power_analysis = {
    .drive = Drive::harmonic, .read = read_power, .searches_peaks = true, .keys = R"json({"properties": {
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "band": {"$ref": "#/$defs/band"}}})json"};

}  // namespace trivet::project
