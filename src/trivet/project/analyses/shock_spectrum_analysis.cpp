// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <fmt/format.h>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

ShockSpectrumAnalysis read_shock_spectrum(TableReader& reader, const ResultNames&, const SymbolTable& symbols) {
  ShockSpectrumAnalysis request;
  request.selection.excitations = read_selected(reader, symbols.time_excitations, "time");
  request.damping_ratio = reader.number("damping", Quantity::pure).value_or(0.05);
  if (!(request.damping_ratio >= 0 && request.damping_ratio < 1))
    reader.error("damping", fmt::format("{:.6g}", request.damping_ratio),
                 "a damping ratio is 0 … 1 (Q = 1/(2ζ); Q = 10 is 0.05)", "correct it");
  const auto band = read_band(reader, "band");
  if (!reader.has("band")) reader.missing("band", "give the natural frequencies: band = [\"5 Hz\", \"2000 Hz\"]");
  if (band && !(band->from > 0)) reader.error("band", "from 0", "natural frequencies are > 0", "raise the lower end");
  request.band = band.value_or(assembly::Band{1, 2});
  return request;
}

}  // namespace

const AnalysisReader shock_spectrum_analysis = read_into<&Analyses::shock_spectrum, read_shock_spectrum>(
    {.drive = Drive::time,
     .keys = R"json({"description": "shock response spectrum of the time histories of the excitations",
  "properties": {
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "damping": {"$ref": "#/$defs/number", "description": "damping ratio (default: 0.05)"},
   "band": {"$ref": "#/$defs/band"}},
  "required": ["band"]})json"});

}  // namespace trivet::project
