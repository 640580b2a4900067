// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/suspension_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/modal/motion_words.h"
#include "trivet/results/format/in_documents.h"
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

std::string suspension_json(const project::Case& variant, const study::SuspensionResult& found) {
  Json result{{"bodies", Json::array()},
              {"excitations", found.excitations},
              {"frequency_separation", Json::array()},
              {"warnings", json::warnings(found.warnings)}};
  for (const modal::BodySuspension& body : found.bodies) {
    Json rolls = Json::array();
    for (const modal::RollAxes& axes : body.roll_axes) rolls.push_back(roll_json(axes));
    result["bodies"].push_back({{"name", variant.system.bodies()[body.body].name},
                                {"stiffness", json::rows(body.stiffness)},
                                {"elastic", elastic_json(body)},
                                {"roll_axes", std::move(rolls)},
                                {"modes", modes_json(body)},
                                {"notes", body.notes}});
  }
  for (const modal::FrequencySeparation& row : found.separation)
    result["frequency_separation"].push_back({{"mode", row.mode},
                                              {"angular_frequency", row.angular_frequency},
                                              {"ratio_to_next", json::optional(row.ratio_to_next)},
                                              {"excitation_ratio", row.excitation_ratio}});
  return json::text(result, 1) + "\n";
}

std::string suspension_csv(const project::Case& variant, const study::SuspensionResult& found) {
  std::string text = "body,angular_frequency [rad/s]";
  for (const char* coordinate : model::coordinate_names) text += fmt::format(",kinetic energy share {}", coordinate);
  text += ",in elements,purest,decoupling\n";
  for (const modal::BodySuspension& body : found.bodies)
    for (const modal::BodyMode& mode : body.modes) {
      text += csv_field(variant.system.bodies()[body.body].name) + "," +
          (mode.angular_frequency ? fmt::format("{}", *mode.angular_frequency) : "");
      for (const double share : mode.kinetic_energy_share) text += fmt::format(",{}", share);
      text += fmt::format(",{},{},{}\n", mode.in_elements, model::coordinate_names[mode.purest], mode.decoupling());
    }
  return text;
}

namespace {

using foundation::two_pi;

/// "(0.1, 0, -0.25)": a number far below the others or below `least` is round-off and shown as 0.
/// @param factor  of the shown unit
std::string triple(const Eigen::Vector3d& v, double least, double factor = 1) {
  const auto number = [&](double x) {
    return fmt::format("{:.4g}", std::abs(x) < std::max(least, 1e-9 * v.cwiseAbs().maxCoeff()) ? 0.0 : x * factor);
  };
  return fmt::format("({}, {}, {})", number(v.x()), number(v.y()), number(v.z()));
}

constexpr double nanometre = 1e-9;

std::string elastic_text(const model::Body& body, const modal::BodySuspension& suspension,
                         const project::DisplayUnits& display) {
  if (!suspension.elastic) return "";
  const elements::StiffnessProperties& c = *suspension.elastic;
  const DisplayUnit length = display_unit(display, "m"), stiffness = display_unit(display, "N/m"),
                    rotational = display_unit(display, "N m/rad");
  std::string text = fmt::format("  elastic centre {} {} from the pole{}, centre of mass {} {}: {:.4g} {} apart\n",
                                 triple(c.elastic_centre, nanometre, length.factor), length.unit,
                                 c.centre_is_unique ? "" : " (not unique: the nearest point of a line)",
                                 triple(body.mass.centre, nanometre, length.factor), length.unit,
                                 suspension.centre_distance * length.factor, length.unit);
  text += fmt::format("  coupling that remains at the elastic centre, largest |K_ij|/√(K_ii K_jj): {:.3f}\n",
                      c.coupling_at_centre);
  TextTable table({"principal stiffness", "along", "rotational, about the elastic centre", "about"});
  for (int i = 0; i < 3; ++i)
    table.add({fmt::format("{:.5g} {}", c.principal_stiffnesses(i) * stiffness.factor, stiffness.unit),
               modal::direction_words(c.principal_axes.col(i)),
               fmt::format("{:.5g} {}", c.principal_rotational_stiffnesses(i) * rotational.factor, rotational.unit),
               modal::direction_words(c.principal_rotational_axes.col(i))});
  return text + table.text();
}

std::string roll_text(const modal::BodySuspension& suspension, const project::DisplayUnits& display) {
  if (suspension.roll_axes.empty()) return "";
  const DisplayUnit length = display_unit(display, "m"), torsional = display_unit(display, "N m/rad");
  const std::string in_length = " [" + length.unit + "]";
  TextTable table({"moment about", "torque roll axis", "elastic roll axis", "through" + in_length, "angle",
                   "apart" + in_length, "from centre of mass" + in_length, "torsional stiffness"});
  for (const modal::RollAxes& axes : suspension.roll_axes) {
    const spatial::Screw& elastic = axes.elastic_roll_axis;
    table.add(
        {modal::direction_words(axes.torque), triple(axes.torque_roll_axis, nanometre),
         triple(elastic.direction, nanometre), triple(elastic.point, nanometre, length.factor),
         fmt::format("{:.3g}°", axes.angle * 360 / two_pi < 1e-6 ? 0.0 : axes.angle * 360 / two_pi),
         fmt::format("{:.4g}", axes.shortest_distance < nanometre ? 0.0 : axes.shortest_distance * length.factor),
         fmt::format("{:.4g}", axes.distance_at_centre < nanometre ? 0.0 : axes.distance_at_centre * length.factor),
         fmt::format("{:.5g} {}", axes.torsional_stiffness * torsional.factor, torsional.unit)});
  }
  return table.text();
}

std::string decoupling_text(const modal::BodySuspension& suspension, const project::DisplayUnits& display) {
  const bool heavy_elements = std::ranges::any_of(
      suspension.modes, [](const modal::BodyMode& mode) { return std::abs(mode.in_elements) >= 5e-4; });
  std::vector<std::string> header = {frequency_heading(display), "x", "y", "z", "rx", "ry", "rz"};
  if (heavy_elements) header.emplace_back("in elements");
  header.emplace_back("purest");
  header.emplace_back("decoupled");
  TextTable table(header);
  const auto percent = [](double share) { return fmt::format("{:.1f} %", std::abs(share) < 5e-4 ? 0.0 : 100 * share); };
  for (const modal::BodyMode& mode : suspension.modes) {
    std::vector<std::string> row = {number_text(shown_frequency(display, mode.angular_frequency.value_or(nothing)), 5)};
    for (const double share : mode.kinetic_energy_share) row.push_back(percent(share));
    if (heavy_elements) row.push_back(percent(mode.in_elements));
    row.emplace_back(model::coordinate_names[mode.purest]);
    row.push_back(percent(mode.decoupling()));
    table.add(row);
  }
  return "  kinetic energy of the modes by coordinate at the centre of mass, body axes\n" + table.text();
}

std::string separation_text(const study::SuspensionResult& found, const project::DisplayUnits& display) {
  std::vector<std::string> header = {"mode", frequency_heading(display), "next / this"};
  for (const double excitation : found.excitations)
    header.push_back(fmt::format("{:.4g} {} / this", shown_frequency(display, excitation), frequency_unit(display)));
  TextTable table(header);
  for (const modal::FrequencySeparation& row : found.separation) {
    std::vector<std::string> cells = {std::to_string(row.mode),
                                      number_text(shown_frequency(display, row.angular_frequency), 5),
                                      number_text(row.ratio_to_next.value_or(nothing), 4)};
    for (const double ratio : row.excitation_ratio) cells.push_back(number_text(ratio, 4));
    table.add(cells);
  }
  return "Frequency separation of the whole system" +
      std::string(found.excitations.empty() ? "" : " (a mode isolates above √2)") + "\n" + table.text();
}

}  // namespace

std::string suspension_text(const project::Case& variant, const study::SuspensionResult& found) {
  std::string text;
  for (const auto& problem : found.warnings.list()) text += foundation::message(problem) + "\n";
  if (!text.empty()) text += "\n";
  for (const modal::BodySuspension& suspension : found.bodies) {
    const model::Body& body = variant.system.bodies()[suspension.body];
    text += fmt::format("{} on its elements{}; body frame\n", body.name,
                        found.bodies.size() > 1 ? ", all other bodies held" : "");
    text += elastic_text(body, suspension, variant.display) + roll_text(suspension, variant.display) +
        decoupling_text(suspension, variant.display);
    for (const std::string& note : suspension.notes) text += "  note: " + note + "\n";
    text += "\n";
  }
  return text + separation_text(found, variant.display);
}

}  // namespace trivet::results
