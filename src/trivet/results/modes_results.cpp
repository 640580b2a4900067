// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/stored_energy.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Undamped modes.
namespace trivet::results {
namespace json {
namespace {

Json body_names(const project::Case& variant) {
  Json names = Json::array();
  for (const auto& body : variant.system.bodies()) names.push_back(body.name);
  return names;
}

Json element_names(const project::Case& variant) {
  Json names = Json::array();
  for (const auto& element : variant.system.elements()) names.push_back(element.name);
  return names;
}

Json screws(const std::vector<spatial::Screw>& list_of_screws) {
  Json result = Json::array();
  for (const spatial::Screw& screw : list_of_screws) {
    Json one{
        {"direction", list(screw.direction)}, {"point", nullptr}, {"pitch", nullptr}, {"rotation", screw.rotation}};
    if (!screw.pure_translation) {
      one["point"] = list(screw.point);
      one["pitch"] = screw.pitch;
    }
    result.push_back(std::move(one));
  }
  return result;
}

Json mode(const modal::Mode& m) {
  return {{"number", m.number},
          {"eigenvalue_squared", m.eigenvalue_squared},
          {"angular_frequency", optional(m.angular_frequency)},
          {"frequency_hz", m.angular_frequency ? Json(*m.angular_frequency / foundation::two_pi) : Json(nullptr)},
          {"modal_mass", m.modal_mass},
          {"repeated", m.repeated},
          {"shape", list(m.shape)},
          {"shape_at_center_of_mass", list(m.shape_at_centre)},
          {"kinetic_energy_share", list(m.kinetic_energy_share)},
          {"principal_kinetic_energy_share", list(m.principal_kinetic_energy_share)},
          {"element_kinetic_energy_share", list(m.element_kinetic_energy_share)},
          {"strain_energy_share", m.strain_energy_share ? list(*m.strain_energy_share) : Json(nullptr)},
          {"screws", screws(m.screws)},
          {"name", m.name}};
}

Json modes(const project::Case& variant, const study::Answers& answers) {
  Json result{{"bodies", body_names(variant)},
              {"elements", element_names(variant)},
              {"modes", Json::array()},
              {"free_motions", answers.free_motions},
              {"warnings", warnings(answers.warnings)}};
  for (const modal::Mode& m : answers.modes.list) result["modes"].push_back(mode(m));
  return result;
}

}  // namespace
}  // namespace json

namespace {

using foundation::two_pi;

std::string modes_csv(const project::Case& variant, const study::Answers& answers) {
  std::string text = "mode,eigenvalue_squared [rad2/s2],angular_frequency [rad/s],frequency [Hz],name";
  for (const auto& body : variant.system.bodies())
    for (const char* coordinate : model::coordinate_names)
      text += "," + csv_field(fmt::format("shape {}.{}", body.name, coordinate));
  for (const auto& element : variant.system.elements()) text += "," + csv_field("strain energy share " + element.name);
  text += "\n";
  for (const modal::Mode& mode : answers.modes.list) {
    text += fmt::format(
        "{},{},{},{},{}", mode.number, csv_number(mode.eigenvalue_squared), csv_number(mode.angular_frequency),
        mode.angular_frequency ? csv_number(*mode.angular_frequency / two_pi) : "", csv_field(mode.name));
    for (const double component : mode.shape) append_csv_number(text, component);
    for (std::size_t e = 0; e < variant.system.elements().size(); ++e)
      text += "," + (mode.strain_energy_share ? csv_number((*mode.strain_energy_share)(to_index(e))) : std::string());
    text += "\n";
  }
  return text;
}

std::string strain_words(const project::Case& variant, const modal::Mode& mode) {
  const auto most = modal::most_strained(mode);
  if (!most) return "–";
  return variant.system.elements()[most->element].name + " " + percent(most->share) +
      modal::given_back_words(most->given_back);
}

std::string modes_text(const project::Case& variant, const study::Answers& answers) {
  const std::vector<std::string> units = frequency_units(variant.display);
  std::vector<std::string> header = {"mode"};
  for (const std::string& unit : units) header.push_back(frequency_heading(variant.display, unit));
  for (const char* name : {"ω² [rad²/s²]", "most strain energy in", "motion"}) header.emplace_back(name);
  TextTable table(header);
  for (const modal::Mode& mode : answers.modes.list) {
    const double omega = mode.angular_frequency.value_or(nothing);
    std::vector<std::string> row = {std::to_string(mode.number)};
    for (const std::string& unit : units)
      row.push_back(number_text(shown_frequency(variant.display, omega, unit), unit == "Hz" ? 7 : 9));
    row.push_back(number_text(mode.eigenvalue_squared, 9));
    row.push_back(strain_words(variant, mode));
    row.push_back(mode.name + (mode.repeated ? " (repeated root: one vector of an orthonormal basis)" : ""));
    table.add(row);
  }
  const std::string which = answers.lowest_modes > 0 ? fmt::format(", the lowest {}", answers.lowest_modes) : "";
  return "Undamped modes" + which + "\n" + table.text();
}

void modes_arrays(const project::Case& variant, const study::Answers& answers, LabelledArrays& list) {
  using modal::Mode;
  const std::vector<Mode>& modes = answers.modes.list;
  const std::size_t coordinates = 6 * variant.system.bodies().size(), elements = variant.system.elements().size();
  list.column("mode", "1", "mode", modes, &Mode::number);
  list.field("eigenvalue_squared", "rad²/s²", "mode", modes, &Mode::eigenvalue_squared);
  list.column("angular_frequency", "rad/s", "mode", modes, &Mode::angular_frequency);
  list.column("frequency", "Hz", "mode", modes,
              [](const Mode& mode) { return mode.angular_frequency.value_or(nothing) / two_pi; });
  list.texts("name", "mode", modes, &Mode::name);
  list.field("modal_mass", "1", "mode", modes, &Mode::modal_mass);
  list.column("repeated", "1", "mode", modes, &Mode::repeated);
  add_shape_coordinates(variant, {"1/√kg", "rad/(m √kg)"}, list);
  list.lists("shape", unit_of_the_row, {"mode", "coordinate"}, coordinates, modes, &Mode::shape);
  list.lists("shape_at_center_of_mass", unit_of_the_row, {"mode", "coordinate"}, coordinates, modes,
             &Mode::shape_at_centre);
  list.lists("kinetic_energy_share", "1", {"mode", "coordinate"}, coordinates, modes, &Mode::kinetic_energy_share);
  list.texts("element", "element", variant.system.elements(), &model::Element::name);
  list.lists("element_kinetic_energy_share", "1", {"mode", "element"}, elements, modes,
             &Mode::element_kinetic_energy_share);
  list.lists("strain_energy_share", "1", {"mode", "element"}, elements, modes,
             [](const Mode& mode) { return mode.strain_energy_share.value_or(Eigen::VectorXd()); });
}

}  // namespace

void add_shape_coordinates(const project::Case& variant, const ShapeUnits& shape, LabelledArrays& list) {
  std::vector<std::string> names, units;
  for (const model::Body& body : variant.system.bodies())
    for (std::size_t j = 0; j < 6; ++j) {
      names.push_back(body.name + "." + model::coordinate_names[j]);
      units.emplace_back(j < 3 ? shape.translation : shape.rotation);
    }
  list.texts("coordinate", "coordinate", std::move(names));
  list.texts("coordinate.unit", "coordinate", std::move(units));
}

const AnswerWriter modes_results = {
    .has_answer = [](const project::Case& variant, const study::Answers&) { return variant.analyses.modes; },
    .json = json::modes,
    .tables = {{"modes.csv", modes_csv}},
    .text = modes_text,
    .arrays = modes_arrays,
};

}  // namespace trivet::results
