// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/analyses/request_readers.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

TransmissibilityAnalysis read_transmissibility(TableReader& reader, const ResultNames&, const SymbolTable& symbols) {
  TransmissibilityAnalysis request;
  const auto force = reader.text("force");
  request.force = force.value_or("");
  const auto base = reader.direction("base");
  if (reader.has("force") == reader.has("base"))
    reader.error(reader.has("force") ? "base" : "force",
                 reader.has("force") ? "force and base" : "neither force nor base",
                 "a transmissibility is that of a force excitation or of a motion of the ground",
                 reader.has("force") ? "keep one" : "force = \"EXCITATION\", or base = \"z\"");
  if (force && std::ranges::find(symbols.harmonic_excitations, request.force) == symbols.harmonic_excitations.end()) {
    const std::string guess = foundation::nearest_name(request.force, symbols.harmonic_excitations);
    reader.error("force", foundation::quoted(request.force), "no harmonic excitation has this name",
                 guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
  if (base) request.direction.axis = *base;
  for (const char* key : {"rotation", "of"})
    if (reader.has("force") && reader.has(key))
      reader.error(key, std::string(key) + " together with a force",
                   "a force is compared with the force on the ground in the same direction", "remove it");
  request.direction.rotation = reader.boolean("rotation").value_or(false);
  std::vector<std::string> places = symbols.bodies;
  places.insert(places.end(), symbols.nodes.begin(), symbols.nodes.end());
  places.insert(places.end(), symbols.points.begin(), symbols.points.end());
  request.selection.of = reader.texts("of", R"(["BODY"])").value_or(symbols.bodies);
  for (const std::string& name : request.selection.of)
    if (!symbols.bodies_unknown && std::ranges::find(places, name) == places.end()) {
      const std::string guess = foundation::nearest_name(name, places);
      reader.error("of", foundation::quoted(name), "`of` names bodies or BODY.POINT",
                   guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
    }
  request.band = read_band(reader, "band");
  request.at = read_single_frequencies(reader);
  if (!request.force.empty()) request.selection = {.of = {"ground"}, .excitations = {request.force}};
  return request;
}

/// Reports a force that is not along one direction.
void check_force(const Analyses& request, const model::System& system, foundation::Problems& problems) {
  const std::string& force = request.transmissibility->force;
  if (force.empty()) return;
  try {
    static_cast<void>(model::applied_force(system, force));
  } catch (const foundation::InvalidInput& reason) {
    problems.error("analyses.transmissibility.force", "\"" + force + "\"", reason.what(),
                   "name a harmonic force along one direction");
  }
}

double curves_of_transmissibility(const Analyses& request) {
  const TransmissibilityAnalysis& own = *request.transmissibility;
  return own.force.empty() ? static_cast<double>(own.selection.of.size()) : 1;
}

}  // namespace

const AnalysisReader transmissibility_analysis = read_into<&Analyses::transmissibility, read_transmissibility>(
    {.searches_peaks = true,
     .curves = curves_of_transmissibility,
     .check = check_force,
     .keys =
         R"json({"description": "force on the ground over a harmonic force, or motion of places over that of the ground",
  "properties": {
   "force": {"type": "string", "description": "a harmonic force excitation"},
   "base": {"$ref": "#/$defs/direction", "description": "of a motion of the ground, ground frame; instead of force"},
   "rotation": {"type": "boolean", "description": "the ground turns about `base` instead (default: false)"},
   "of": {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}, "minItems": 1}],
     "description": "bodies and points whose motion is compared with that of the ground"},
   "band": {"$ref": "#/$defs/band"},
   "at": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 1,
     "description": "single frequencies told besides, rad/s or with a unit"}}})json"});

}  // namespace trivet::project
