// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/suspension_text.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/modal/motion_words.h"

namespace trivet::results {
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
                         const project::ShownUnits& display) {
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

std::string roll_text(const modal::BodySuspension& suspension, const project::ShownUnits& display) {
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

std::string decoupling_text(const modal::BodySuspension& suspension, const project::ShownUnits& display) {
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

std::string separation_text(const study::SuspensionAnswer& answer, const project::ShownUnits& display) {
  std::vector<std::string> header = {"mode", frequency_heading(display), "next / this"};
  for (const double excitation : answer.excitations)
    header.push_back(fmt::format("{:.4g} {} / this", shown_frequency(display, excitation), frequency_unit(display)));
  TextTable table(header);
  for (const modal::FrequencySeparation& row : answer.separation) {
    std::vector<std::string> cells = {std::to_string(row.mode),
                                      number_text(shown_frequency(display, row.angular_frequency), 5),
                                      number_text(row.ratio_to_next.value_or(nothing), 4)};
    for (const double ratio : row.excitation_ratio) cells.push_back(number_text(ratio, 4));
    table.add(cells);
  }
  return "Frequency separation of the whole system" +
      std::string(answer.excitations.empty() ? "" : " (a mode isolates above √2)") + "\n" + table.text();
}

}  // namespace

std::string suspension_text(const project::Case& variant, const study::SuspensionAnswer& answer) {
  std::string text;
  for (const auto& problem : answer.warnings.list()) text += foundation::message(problem) + "\n";
  if (!text.empty()) text += "\n";
  for (const modal::BodySuspension& suspension : answer.bodies) {
    const model::Body& body = variant.system.bodies()[suspension.body];
    text += fmt::format("{} on its elements{}; body frame\n", body.name,
                        answer.bodies.size() > 1 ? ", all other bodies held" : "");
    text += elastic_text(body, suspension, variant.display) + roll_text(suspension, variant.display) +
        decoupling_text(suspension, variant.display);
    for (const std::string& note : suspension.notes) text += "  note: " + note + "\n";
    text += "\n";
  }
  return text + separation_text(answer, variant.display);
}

}  // namespace trivet::results
