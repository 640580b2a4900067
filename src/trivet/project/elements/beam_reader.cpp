// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/elements/beam.h"
#include "trivet/elements/checks.h"
#include "trivet/foundation/part_size.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/material_reader.h"

namespace trivet::project {
namespace {

using elements::Section;

/// section = {round = d}, {tube = [outer, inner]}, {rectangle = [x, y]} or {area, moment_x, moment_y, torsion,
/// shear_factor_x, shear_factor_y}.
std::optional<Section> read_section(TableReader& reader, const elements::Metal& metal) {
  const Node* node = reader.table("section");
  if (!node) {
    if (!reader.has("section"))
      reader.missing("section", "give section = {round = \"20 mm\"}, {tube = [outer, inner]} or {rectangle = [x, y]}");
    return std::nullopt;
  }
  const std::size_t before = reader.errors();
  TableReader section(*node, reader.path() + ".section", reader.problems());
  Section result;
  const auto sides = [&](const char* key) -> std::optional<std::vector<double>> {
    auto numbers = section.numbers(key, Quantity::length);
    if (numbers && numbers->size() != 2) {
      section.error(key, fmt::format("{} numbers", numbers->size()), "two lengths are expected",
                    "tube = [outer, inner], rectangle = [x, y]");
      return std::nullopt;
    }
    return numbers;
  };
  const auto positive = [&](const char* key, double value) {
    if (!(value > 0))
      section.error(key, fmt::format("{:.6g} m", value), "a length of the section must be > 0",
                    "correct the value or its unit");
    else if (!foundation::is_part_size(value))
      section.error(key, fmt::format("{:.6g} m", value), foundation::part_size_rule,
                    "check the unit and the power of ten");
    return foundation::is_part_size(value);
  };
  std::string shapes;
  for (const char* key : {"round", "tube", "rectangle", "area"})
    if (section.has(key)) shapes += (shapes.empty() ? "" : " and ") + std::string(key);
  if (shapes.empty() || shapes.find(' ') != std::string::npos) {
    section.also_known(
        {"round", "tube", "rectangle", "area", "moment_x", "moment_y", "torsion", "shear_factor_x", "shear_factor_y"});
    section.finish();
    if (reader.errors() == before)
      reader.error("section", shapes.empty() ? "no shape" : shapes,
                   "a section is one of {round}, {tube}, {rectangle}, {area, moment_x, moment_y, torsion}",
                   "give one of them");
    return std::nullopt;
  }
  if (section.has("round")) {
    if (const auto diameter = section.number("round", Quantity::length); diameter && positive("round", *diameter))
      result = elements::round_section(*diameter, metal);
  } else if (section.has("tube")) {
    if (const auto d = sides("tube"); d && positive("tube", (*d)[0]) && positive("tube", (*d)[1])) {
      if ((*d)[0] > (*d)[1]) result = elements::tube_section((*d)[0], (*d)[1], metal);
      else
        section.error("tube", fmt::format("outer {:.6g} m, inner {:.6g} m", (*d)[0], (*d)[1]),
                      "the outer diameter must exceed the inner one", "order: [outer, inner]");
    }
  } else if (section.has("rectangle")) {
    if (const auto w = sides("rectangle"); w && positive("rectangle", (*w)[0]) && positive("rectangle", (*w)[1]))
      result = elements::rectangular_section((*w)[0], (*w)[1], metal);
  } else {
    // Areas and second moments are SI numbers without units.
    result.area = section.required_number("area", Quantity::pure);
    result.moment_1 = section.required_number("moment_x", Quantity::pure);
    result.moment_2 = section.required_number("moment_y", Quantity::pure);
    result.torsion_constant = section.required_number("torsion", Quantity::pure);
    result.shear_factor_1 = section.number("shear_factor_x", Quantity::pure).value_or(1);
    result.shear_factor_2 = section.number("shear_factor_y", Quantity::pure).value_or(1);
  }
  section.finish();
  return reader.errors() == before ? std::optional(result) : std::nullopt;
}

ElementLength read_beam(TableReader& reader, model::Element& element) {
  const std::size_t before = reader.errors();
  const double length = reader.required_number("length", Quantity::length);
  const std::string level = reader.choice("level", {"quasi_static", "with_mass"}).value_or("with_mass");
  auto metal = read_metal(reader);
  const auto section = read_section(reader, metal.value_or(elements::metals().front()));
  if (metal && std::isnan(metal->density)) {
    if (level == "with_mass")
      reader.error("material", "no density", "a beam with mass needs one", "add density, or level = \"quasi_static\"");
    metal->density = 0;  // massless
  }
  foundation::Problems findings;
  if (metal && section) findings = elements::check(elements::Beam{*metal, *section, length});
  else static_cast<void>(elements::check_length(findings, "length", length));
  reader.add(findings,
             {{"area", "section.area"},
              {"moment_1", "section.moment_x"},
              {"moment_2", "section.moment_y"},
              {"torsion_constant", "section.torsion"},
              {"shear_factor", "section"},
              {"young_modulus", "material"},
              {"shear_modulus", "material"},
              {"density", "material"}});
  if (reader.errors() > before) return std::nullopt;
  const elements::Beam beam{*metal, *section, length};
  element.law.nominal_stiffness = elements::beam_stiffness(beam);
  element.law.per_tension = elements::beam_stiffness_per_tension(beam);
  if (level == "with_mass") {
    element.law.inertia = elements::Inertia{elements::beam_mass(beam), Eigen::MatrixXd(12, 0), Eigen::VectorXd(0)};
    element.facts.push_back({"own mass", fmt::format("{:.6g} kg", metal->density * section->area * length)});
  }
  element.facts.push_back(
      {"axial stiffness EA/L", foundation::prefixed_exactly(metal->young_modulus * section->area / length, "N/m", 6)});
  element.facts.push_back({"found by", "Timoshenko's beam, clamped to both bodies"});
  return length;
}

ElementLength read_link(TableReader& reader, model::Element& element) {
  const std::size_t before = reader.errors();
  elements::Link link;
  link.length = reader.required_number("length", Quantity::length);
  link.axial_stiffness = reader.required_number("stiffness", Quantity::force_per_length);
  link.tension = reader.number("tension", Quantity::force).value_or(0);
  reader.add(elements::check(link), {{"axial_stiffness", "stiffness"}});
  if (reader.errors() > before) return std::nullopt;
  element.law.nominal_stiffness = elements::link_stiffness(link);
  element.law.per_tension = elements::link_stiffness_per_tension(link.length);
  if (link.tension != 0) element.law.preload = elements::link_preload(link);
  element.facts.push_back({"found by", "a rod between two ball joints"});
  return link.length;
}

}  // namespace

const ElementLaw beam_law = {.type = "beam", .sized = read_beam, .keys = R"json({"properties": {
   "length": {"$ref": "#/$defs/number", "description": "m, > 0 (default: between its ends, if both are given)"},
   "section": {"$ref": "#/$defs/section"},
   "material": {"$ref": "#/$defs/metal"},
   "level": {"enum": ["quasi_static", "with_mass"], "description": "without or with the inertia of the beam (default: with_mass)"}},
  "required": ["section", "material"]})json"};

/// Two names of one law: a rod between two ball joints.
constexpr const char* link_keys = R"json({"properties": {
   "length": {"$ref": "#/$defs/number", "description": "between its two ball joints, m, > 0 (default: between its ends, if both are given)"},
   "stiffness": {"$ref": "#/$defs/number", "description": "axial, N/m, >= 0"},
   "tension": {"$ref": "#/$defs/number", "description": "static, N (default: 0)"}},
  "required": ["stiffness"]})json";
const ElementLaw link_law = {.type = "link", .sized = read_link, .keys = link_keys};
const ElementLaw stay_law = {.type = "stay", .sized = read_link, .keys = link_keys};

}  // namespace trivet::project
