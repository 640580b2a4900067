// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/wanted_reader.h"

namespace trivet::project {

TransmissibilityRequest read_transmissibility(TableReader& reader, const Mentioned& mentioned) {
  TransmissibilityRequest request;
  request.force = reader.text("force").value_or("");
  const auto base = reader.direction("base");
  if (reader.has("force") == reader.has("base"))
    reader.error(reader.has("force") ? "base" : "force", reader.has("force") ? "force and base" : "neither force nor base", "a transmissibility is that of a force excitation or of a motion of the ground",
                 reader.has("force") ? "keep one" : "force = \"EXCITATION\", or base = \"z\"");
  if (reader.has("force") && !request.force.empty() && std::find(mentioned.harmonic_excitations.begin(), mentioned.harmonic_excitations.end(), request.force) == mentioned.harmonic_excitations.end()) {
    const std::string guess = foundation::nearest_name(request.force, mentioned.harmonic_excitations);
    reader.error("force", foundation::quoted(request.force), "no harmonic excitation has this name", guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
  if (base) request.direction.axis = *base;
  for (const char* key : {"rotation", "of"})
    if (reader.has("force") && reader.has(key)) reader.error(key, std::string(key) + " beside a force", "a force is compared with the force on the ground in its own direction", "remove it");
  request.direction.rotation = reader.boolean("rotation").value_or(false);
  std::vector<std::string> places = mentioned.bodies;
  places.insert(places.end(), mentioned.points.begin(), mentioned.points.end());
  request.of = reader.texts("of", R"(["BODY"])").value_or(mentioned.bodies);
  for (const std::string& name : request.of)
    if (std::find(places.begin(), places.end(), name) == places.end()) {
      const std::string guess = foundation::nearest_name(name, places);
      reader.error("of", foundation::quoted(name), "a motion is that of a body or BODY.POINT", guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
    }
  request.band = read_band(reader, "band");
  return request;
}

PowerRequest read_power(TableReader& reader, const Mentioned& mentioned) {
  PowerRequest request;
  request.excitations = read_selected(reader, mentioned.harmonic_excitations, "harmonic");
  request.band = read_band(reader, "band");
  return request;
}

ShapesRequest read_shapes(TableReader& reader, const Mentioned& mentioned) {
  ShapesRequest request;
  request.excitations = read_selected(reader, mentioned.harmonic_excitations, "harmonic");
  if (!reader.has("at")) reader.missing("at", "give the frequencies: at = [\"25 Hz\"]");
  request.at = reader.numbers("at", Quantity::angular_frequency).value_or(std::vector<double>{});
  if (reader.has("at") && request.at.empty()) reader.error("at", "no frequency", "at least one is wanted", "for instance at = [\"25 Hz\"]");
  for (const double omega : request.at)
    if (!(omega > 0)) reader.error("at", fmt::format("{:.6g} rad/s", omega), "a shape is drawn at ω > 0", "mend it");
  return request;
}

}  // namespace trivet::project
