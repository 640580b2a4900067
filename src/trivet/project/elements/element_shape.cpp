// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/element_shape.h"

#include <string>

#include "trivet/project/elements/rubber_shape.h"

namespace trivet::project {
namespace {

ElementShape rubber_form(TableReader& reader, const std::string& kind) {
  const std::optional<RubberShape> shape = read_rubber_shape(reader, kind);
  if (!shape) return {};
  RubberForm form{shape->solid};
  const auto* disc = std::get_if<elements::RubberDisc>(&shape->formulas);
  if (const auto* sandwich = std::get_if<elements::Sandwich>(&shape->formulas))
    disc = std::get_if<elements::RubberDisc>(&sandwich->layer);
  if (disc) form.hole_diameter = 2 * disc->hole_radius;
  return form;
}

ElementShape section_form(const Node& section) {
  foundation::Problems reported_before;
  TableReader reader(section, "section", reported_before);
  SectionForm form;
  if (const auto round = reader.number("round", Quantity::length)) form.outer = *round;
  else if (const auto tube = reader.numbers("tube", Quantity::length); tube && tube->size() == 2) {
    form.outer = (*tube)[0];
    form.inner = (*tube)[1];
  } else if (const auto sides = reader.numbers("rectangle", Quantity::length); sides && sides->size() == 2) {
    form.sides = {(*sides)[0], (*sides)[1]};
  } else {
    return {};
  }
  return form;
}

}  // namespace

ElementShape element_shape(const Node& element) {
  const Node* type = element.find("type");
  if (!type) return {};
  foundation::Problems reported_before;
  TableReader reader(element, "element", reported_before);
  const std::string& law = type->text;
  if (law == "coil_spring") return read_coil(reader);
  if (law == "rubber_disc") return rubber_form(reader, "disc");
  if (law == "rubber_block") return rubber_form(reader, "block");
  if (law == "rubber_bush") return rubber_form(reader, "bush");
  if (law == "sandwich") return rubber_form(reader, "sandwich");
  if (const Node* shape = element.find("shape"); law == "solid_mount" && shape) return rubber_form(reader, shape->text);
  if (const Node* section = element.find("section"); law == "beam" && section && section->kind == Node::Kind::table)
    return section_form(*section);
  return {};
}

}  // namespace trivet::project
