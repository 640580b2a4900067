// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/suspension_json.h"

#include <fmt/format.h>

#include "trivet/documents/csv_field.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using json::Json;

Json elastic_json(const modal::BodySuspension& body) {
  if (!body.elastic) return nullptr;
  const elements::StiffnessProperties& c = *body.elastic;
  return {{"center", json::list(c.elastic_centre)},
          {"center_is_unique", c.centre_is_unique},
          {"distance_to_center_of_mass", json::number(body.centre_distance)},
          {"principal_stiffnesses", json::list(c.principal_stiffnesses)},
          {"principal_axes", json::rows(c.principal_axes.transpose())},
          {"principal_rotational_stiffnesses", json::list(c.principal_rotational_stiffnesses)},
          {"principal_rotational_axes", json::rows(c.principal_rotational_axes.transpose())},
          {"coupling_at_center", json::number(c.coupling_at_centre)}};
}

Json roll_json(const modal::RollAxes& axes) {
  const spatial::Screw& elastic = axes.elastic_roll_axis;
  return {
      {"torque", json::list(axes.torque)},
      {"torque_roll_axis", json::list(axes.torque_roll_axis)},
      {"elastic_roll_axis",
       {{"direction", json::list(elastic.direction)}, {"point", json::list(elastic.point)}, {"pitch", elastic.pitch}}},
      {"torsional_stiffness", json::number(axes.torsional_stiffness)},
      {"angle", axes.angle},
      {"shortest_distance", axes.shortest_distance},
      {"distance_at_center_of_mass", axes.distance_at_centre}};
}

Json modes_json(const modal::BodySuspension& body) {
  Json result = Json::array();
  for (const modal::BodyMode& mode : body.modes)
    result.push_back({{"angular_frequency", json::optional(mode.angular_frequency)},
                      {"kinetic_energy_share", json::list(mode.kinetic_energy_share)},
                      {"in_elements", json::number(mode.in_elements)},
                      {"purest", model::coordinate_names[mode.purest]},
                      {"decoupling", json::number(mode.decoupling())}});
  return result;
}

}  // namespace

std::string suspension_json(const project::Case& variant, const study::SuspensionAnswer& answer) {
  Json result{{"bodies", Json::array()},
              {"excitations", answer.excitations},
              {"frequency_separation", Json::array()},
              {"warnings", json::warnings(answer.warnings)}};
  for (const modal::BodySuspension& body : answer.bodies) {
    Json rolls = Json::array();
    for (const modal::RollAxes& axes : body.roll_axes) rolls.push_back(roll_json(axes));
    result["bodies"].push_back({{"name", variant.system.bodies()[body.body].name},
                                {"stiffness", json::rows(body.stiffness)},
                                {"elastic", elastic_json(body)},
                                {"roll_axes", std::move(rolls)},
                                {"modes", modes_json(body)},
                                {"notes", body.notes}});
  }
  for (const modal::FrequencySeparation& row : answer.separation)
    result["frequency_separation"].push_back({{"mode", row.mode},
                                              {"angular_frequency", row.angular_frequency},
                                              {"ratio_to_next", json::optional(row.ratio_to_next)},
                                              {"excitation_ratio", row.excitation_ratio}});
  return json::text(result, 1) + "\n";
}

std::string suspension_csv(const project::Case& variant, const study::SuspensionAnswer& answer) {
  std::string text = "body,angular_frequency [rad/s]";
  for (const char* coordinate : model::coordinate_names) text += fmt::format(",kinetic energy share {}", coordinate);
  text += ",in elements,purest,decoupling\n";
  for (const modal::BodySuspension& body : answer.bodies)
    for (const modal::BodyMode& mode : body.modes) {
      text += csv_field(variant.system.bodies()[body.body].name) + "," +
          (mode.angular_frequency ? fmt::format("{}", *mode.angular_frequency) : "");
      for (const double share : mode.kinetic_energy_share) text += fmt::format(",{}", share);
      text += fmt::format(",{},{},{}\n", mode.in_elements, model::coordinate_names[mode.purest], mode.decoupling());
    }
  return text;
}

}  // namespace trivet::results
