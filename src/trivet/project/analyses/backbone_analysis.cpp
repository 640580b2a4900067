// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/request_readers.h"

namespace trivet::project {
namespace {

BackboneAnalysis read_backbone(TableReader& reader, const ResultNames& names, const SymbolTable&) {
  BackboneAnalysis request;
  read_results(reader, names, request.selection);
  if (const auto modes = reader.numbers("modes", Quantity::pure)) {
    request.modes.clear();
    for (const double mode : *modes) {
      if (mode >= 1 && mode == std::floor(mode)) request.modes.push_back(static_cast<int>(mode));
      else
        reader.error("modes", fmt::format("{:.6g}", mode), "numbers of modes as trivet modes lists them, from 1",
                     "for instance modes = [1, 2]");
    }
    if (modes->empty()) reader.error("modes", "no mode", "at least one is expected", "remove it for the first mode");
  }
  const auto read_end = [&](const char* key, Quantity quantity, const char* unit, double& end) {
    const auto value = reader.number(key, quantity);
    if (value && !(*value > 0)) reader.error(key, fmt::format("{:.6g} {}", *value, unit), "it is > 0", "correct it");
    if (value) end = *value;
  };
  read_end("up_to", Quantity::length, "m", request.up_to);
  read_end("up_to_angle", Quantity::angle, "rad", request.up_to_angle);
  read_end("up_to_energy", Quantity::energy, "J", request.up_to_energy);
  if (!reader.has("up_to") && !reader.has("up_to_angle") && !reader.has("up_to_energy"))
    reader.missing("up_to",
                   "give the largest deflection of a nonlinear part, up_to = \"10 mm\"; or up_to_angle, up_to_energy");
  request.damped = reader.boolean("damped").value_or(false);
  read_harmonics(reader, request.harmonics, request.tolerance);
  return request;
}

void check_backbone(const Analyses&, const model::System& system, foundation::Problems& problems) {
  require_nonlinear("analyses.backbone", "take modes, or give an element laws or a stop (docs/nonlinear.md)", system,
                    problems);
}

}  // namespace

const AnalysisReader backbone_analysis = read_into<&Analyses::backbone, read_backbone>(
    {.check = check_backbone,
     .keys = R"json({"description": "nonlinear modes: frequency and shape of free motions over their amplitude",
  "properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "modes": {"type": "array", "items": {"type": "integer", "minimum": 1}, "minItems": 1, "description": "numbers of modes about rest (default: [1])"},
   "up_to": {"$ref": "#/$defs/number", "description": "m: largest deflection of any nonlinear part"},
   "up_to_angle": {"$ref": "#/$defs/number", "description": "rad: largest rotation of any nonlinear part"},
   "up_to_energy": {"$ref": "#/$defs/number", "description": "J"},
   "damped": {"type": "boolean", "description": "with the damping ratio over amplitude (default: false)"},
   "harmonics": {"type": "integer", "minimum": 1, "maximum": 200, "description": "number of harmonics (default: as many as tolerance needs)"},
   "tolerance": {"$ref": "#/$defs/number", "description": "share of the deflections beyond the last harmonic, 0 to 1 (default: 1e-3)"}}})json"});

}  // namespace trivet::project
