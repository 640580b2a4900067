// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <fmt/format.h>

#include "trivet/project/analyses/analysis_reader.h"

namespace trivet::project {
namespace {

constexpr std::size_t most_shapes = 1000;

ShapesAnalysis read_shapes(TableReader& reader, const ResultNames&, const SymbolTable& symbols) {
  ShapesAnalysis request;
  request.selection.excitations = read_selected(reader, symbols.harmonic_excitations, "harmonic");
  if (!reader.has("at")) reader.missing("at", "give the frequencies: at = [\"25 Hz\"]");
  request.at = reader.numbers("at", Quantity::angular_frequency).value_or(std::vector<double>{});
  if (reader.has("at") && request.at.empty())
    reader.error("at", "no frequency", "at least one is expected", "for instance at = [\"25 Hz\"]");
  for (std::size_t i = 0; i < request.at.size(); ++i)
    if (!(request.at[i] > 0))
      reader.error("at", value_text(*reader.node("at"), i), "the frequency of a deflection shape is > 0", "correct it");
  if (request.at.size() > most_shapes)
    reader.error("at", fmt::format("{} frequencies", request.at.size()),
                 fmt::format("at most {} shapes are drawn", most_shapes), "name fewer frequencies");
  return request;
}

}  // namespace

const AnalysisReader shapes_analysis = read_into<&Analyses::shapes, read_shapes>(
    {.drive = Drive::harmonic,
     .keys = R"json({"description": "motion of all bodies at single frequencies, as pictures and for other programs",
  "properties": {
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "at": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 1,
     "description": "frequencies, rad/s or with a unit"}},
  "required": ["at"]})json"});

}  // namespace trivet::project
