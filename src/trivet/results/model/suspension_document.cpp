// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/suspension_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/shown_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/modal/motion_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using modal::BodySuspension;
using modal::RollAxes;

constexpr double nanometre = 1e-9, degree = foundation::two_pi / 360;

/// "(0.1, 0, -0.25)": a number far below the others or below a nanometre is round-off and shown as 0.
/// @param factor  of the shown unit
std::string triple(const Eigen::Vector3d& v, double factor = 1) {
  const double least = nanometre * std::max(1.0, v.cwiseAbs().maxCoeff());
  const auto number = [&](double x) { return fmt::format("{:.4g}", std::abs(x) < least ? 0.0 : x * factor); };
  return fmt::format("({}, {}, {})", number(v.x()), number(v.y()), number(v.z()));
}

Json elastic_json(const BodySuspension& body) {
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

/// The elastic centre and the principal stiffnesses for people.
void add_elastic(const Eigen::Vector3d& centre_of_mass, const BodySuspension& suspension, const DisplayUnit& length,
                 Document& document) {
  const elements::StiffnessProperties& c = *suspension.elastic;
  const auto place = [&](const Eigen::Vector3d& v) { return triple(v, length.factor) + " " + length.unit; };
  document.add(Sentence{.parts = {"elastic centre " + place(c.elastic_centre) + " from the pole" +
                                      (c.centre_is_unique ? "" : " (not unique: the nearest point of a line)") +
                                      ", centre of mass " + place(centre_of_mass) + ": ",
                                  Quantity{suspension.centre_distance, "m", Kind::quantity, 4}, " apart"},
                        .place = Sentence::Place::note});
  document.add(Sentence{.parts = {"coupling that remains at the elastic centre, largest |K_ij|/√(K_ii K_jj): ",
                                  fmt::format("{:.3f}", c.coupling_at_centre)},
                        .place = Sentence::Place::note});
  const Rows row(std::vector<int>{0, 1, 2});
  document.add(Table{
      .rows = row.size(),
      .columns = {row("stiffness", Kind::quantity, "principal stiffness",
                      [&c](int i) { return c.principal_stiffnesses(i); }, {.unit = "N/m", .digits = 5}),
                  row("axis", Kind::words, "along",
                      [&c](int i) { return modal::direction_words(c.principal_axes.col(i)); }),
                  row("rotational", Kind::quantity, "rotational, about the elastic centre",
                      [&c](int i) { return c.principal_rotational_stiffnesses(i); }, {.unit = "N m/rad", .digits = 5}),
                  row("rotational_axis", Kind::words, "about",
                      [&c](int i) { return modal::direction_words(c.principal_rotational_axes.col(i)); })},
      .forms = for_people});
}

Table roll_table(const BodySuspension& suspension, const DisplayUnit& length) {
  const Rows row(suspension.roll_axes);
  const auto elastic = [](const RollAxes& axes) -> Json {
    const spatial::Screw& screw = axes.elastic_roll_axis;
    return {{"direction", json::list(screw.direction)}, {"point", json::list(screw.point)}, {"pitch", screw.pitch}};
  };
  Table table{.key = "roll_axes", .rows = row.size(), .one_prefix = true};
  const auto add = [&](Column column) { table.columns.push_back(std::move(column)); };
  const auto show = [&](Kind kind, const std::string& heading, auto value, ColumnOptions options = {}) {
    options.forms = for_people;
    add(row("shown", kind, heading, value, std::move(options)));
  };
  const auto distance = [&](const char* name, const char* heading, double RollAxes::* value) {
    add(row(name, Kind::number, "", value));
    show(Kind::quantity, heading, [=](const RollAxes& axes) { return axes.*value < nanometre ? 0.0 : axes.*value; },
         {.unit = "m", .digits = 4});
  };
  add(row.lists("torque", "", "", {}, &RollAxes::torque));
  show(Kind::words, "moment about", [](const RollAxes& axes) { return modal::direction_words(axes.torque); });
  add(row.lists("torque_roll_axis", "", "", {}, &RollAxes::torque_roll_axis));
  show(Kind::words, "torque roll axis", [](const RollAxes& axes) { return triple(axes.torque_roll_axis); });
  add(row("elastic_roll_axis", Kind::words, "", elastic));
  show(Kind::words, "elastic roll axis", [](const RollAxes& a) { return triple(a.elastic_roll_axis.direction); });
  show(Kind::words, "through [" + length.unit + "]",
       [factor = length.factor](const RollAxes& a) { return triple(a.elastic_roll_axis.point, factor); });
  add(row("torsional_stiffness", Kind::number, "", &RollAxes::torsional_stiffness));
  add(row("angle", Kind::number, "", &RollAxes::angle));
  show(Kind::number, "angle [°]", [](const RollAxes& a) { return a.angle < 1e-8 ? 0.0 : a.angle / degree; },
       {.digits = 3});
  distance("shortest_distance", "apart", &RollAxes::shortest_distance);
  distance("distance_at_center_of_mass", "from centre of mass", &RollAxes::distance_at_centre);
  show(Kind::quantity, "torsional stiffness", &RollAxes::torsional_stiffness, {.unit = "N m/rad", .digits = 5});
  return table;
}

/// A mode of a body on its elements.
struct OwnMode : modal::BodyMode {
  std::string body;
};

Table decoupling_table(std::vector<OwnMode> modes) {
  constexpr double least = 5e-4;  // below, 0.0 %
  const bool heavy_elements =
      std::ranges::any_of(modes, [](const OwnMode& mode) { return std::abs(mode.in_elements) >= least; });
  const std::vector<std::string> coordinates(model::coordinate_names.begin(), model::coordinate_names.end());
  const Rows row(std::move(modes));
  Table table{.key = "modes",
              .title = "  kinetic energy of the modes by coordinate at the centre of mass, body axes",
              .rows = row.size(),
              .columns = {row("body", Kind::words, "", &OwnMode::body, {.forms = in_csv}),
                          row("angular_frequency", Kind::frequency, "ω", &OwnMode::angular_frequency, {.digits = 5}),
                          row.lists("kinetic_energy_share", "", "", coordinates, &OwnMode::kinetic_energy_share,
                                    {.forms = in_json | in_csv})},
              .csv = {"body",
                      "angular_frequency [rad/s]",
                      {"kinetic energy share {}", "kinetic_energy_share"},
                      {"in elements", "in_elements"},
                      "purest",
                      "decoupling"}};
  const auto add = [&](Column column) { table.columns.push_back(std::move(column)); };
  for (int i = 0; i < 6; ++i)
    add(row(
        "share", Kind::share, coordinates[static_cast<std::size_t>(i)],
        [i](const OwnMode& m) { return std::abs(m.kinetic_energy_share(i)) < least ? 0 : m.kinetic_energy_share(i); },
        {.forms = for_people}));
  add(row("in_elements", Kind::share, heavy_elements ? "in elements" : "", &OwnMode::in_elements));
  add(row("purest", Kind::words, "purest", [](const OwnMode& mode) { return model::coordinate_names[mode.purest]; }));
  add(row("decoupling", Kind::share, "decoupled", &OwnMode::decoupling));
  return table;
}

Document body_document(const model::Body& body, const BodySuspension& suspension, std::vector<OwnMode> modes,
                       const DisplayUnit& length) {
  Document document;
  document.add(Single{.name = "name", .value = body.name});
  document.add(Single{.name = "stiffness", .value = json::rows(suspension.stiffness)});
  document.add(Single{.name = "elastic", .value = elastic_json(suspension)});
  if (suspension.elastic) add_elastic(body.mass.centre, suspension, length, document);
  document.add(roll_table(suspension, length));
  document.add(decoupling_table(std::move(modes)));
  document.add(Words{.key = "notes", .list = suspension.notes});
  for (const std::string& note : suspension.notes)
    document.add(Sentence{.parts = {"note: " + note}, .place = Sentence::Place::note});
  return document;
}

Table separation_table(const study::SuspensionResult& found, const project::DisplayUnits& display) {
  using modal::FrequencySeparation;
  const Rows row(found.separation);
  std::vector<std::string> ratios;
  for (const double omega : found.excitations)
    ratios.push_back(shown_quantity({omega, "rad/s", Kind::frequency, 4}, display) + " / this");
  return {.key = "frequency_separation",
          .title = std::string("\nFrequency separation of the whole system") +
              (found.excitations.empty() ? "" : " (a mode isolates above √2)"),
          .rows = row.size(),
          .columns = {
              row("mode", Kind::number, "mode", &FrequencySeparation::mode),
              row("angular_frequency", Kind::frequency, "ω", &FrequencySeparation::angular_frequency, {.digits = 5}),
              row("ratio_to_next", Kind::number, "next / this", &FrequencySeparation::ratio_to_next, {.digits = 4}),
              row.lists("excitation_ratio", "excitation", "", std::move(ratios), &FrequencySeparation::excitation_ratio,
                        {.digits = 4})}};
}

}  // namespace

Document suspension_document(const project::Case& variant, const study::SuspensionResult& found) {
  Document document;
  for (const auto& problem : found.warnings.list())
    document.add(Sentence{.parts = {foundation::message(problem)}, .forms = on_page});
  Json bodies = Json::array();
  std::vector<OwnMode> modes;
  for (const BodySuspension& suspension : found.bodies) {
    const model::Body& body = variant.system.bodies()[suspension.body];
    std::vector<OwnMode> own;
    for (const modal::BodyMode& mode : suspension.modes) own.push_back({mode, body.name});
    modes.insert(modes.end(), own.begin(), own.end());
    document.add(Sentence{.parts = {(document.parts.empty() ? "" : "\n") + body.name + " on its elements" +
                                    (found.bodies.size() > 1 ? ", all other bodies held" : "") + "; body frame"}});
    Document shown = body_document(body, suspension, std::move(own), display_unit(variant.display, "m"));
    bodies.push_back(as_json(shown));
    for (Part& part : shown.parts) {
      if (auto* table = std::get_if<Table>(&part.content)) table->forms = for_people;
      else if (!std::holds_alternative<Sentence>(part.content)) continue;
      document.parts.push_back(std::move(part));
    }
  }
  document.add(Single{.name = "bodies", .value = std::move(bodies)});
  document.add(Single{.name = "excitations", .value = found.excitations});
  document.add(separation_table(found, variant.display));
  document.add(Single{.name = "warnings", .value = json::warnings(found.warnings)});
  Table& all_modes = document.add(decoupling_table(std::move(modes)));
  all_modes.file = "suspension.csv";
  all_modes.forms = in_csv;
  return document;
}

}  // namespace trivet::results
