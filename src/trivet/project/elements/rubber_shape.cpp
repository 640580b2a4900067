// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/rubber_shape.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/project/elements/material_reader.h"

namespace trivet::project {
namespace {

using elements::LayerFormulas;

elements::RubberDisc read_disc(TableReader& reader) {
  elements::RubberDisc disc;
  disc.radius = reader.required_number("diameter", Quantity::length) / 2;
  disc.hole_radius = reader.number("hole_diameter", Quantity::length).value_or(0) / 2;
  return disc;
}

elements::RubberBlock read_block(TableReader& reader) {
  elements::RubberBlock block;
  block.width_1 = reader.required_number("width_x", Quantity::length);
  block.width_2 = reader.required_number("width_y", Quantity::length);
  return block;
}

LayerFormulas read_formulas(TableReader& reader) {
  return reader.choice("formulas", {"measured", "textbook"}) == "textbook" ? LayerFormulas::textbook
                                                                           : LayerFormulas::measured;
}

/// Metal plates are rigid compared with rubber: from 70 GPa up, the modulus does not change the first twelve digits.
fem::Material plate_metal() { return fem::linear_elastic(206e9, 0.3); }

}  // namespace

std::optional<RubberShape> read_rubber_shape(TableReader& reader, const std::string& kind) {
  const std::size_t before = reader.errors();
  RubberShape shape;
  if (kind == "bush") {
    elements::RubberBush bush;
    bush.inner_radius = reader.required_number("inner_diameter", Quantity::length) / 2;
    bush.outer_radius = reader.required_number("outer_diameter", Quantity::length) / 2;
    bush.length = reader.required_number("length", Quantity::length);
    shape.formulas = bush;
    shape.solid = fem::Bush{2 * bush.inner_radius, 2 * bush.outer_radius, bush.length, 0};
  } else {
    // A sandwich has the outline of a block if it has widths, of a disc otherwise.
    const bool rectangular =
        kind == "block" || (kind == "sandwich" && (reader.has("width_x") || reader.has("width_y")));
    const double thickness = reader.required_number("thickness", Quantity::length);
    std::vector<fem::Layer> layers = {{thickness, 0, false}};
    shape.length = thickness;
    elements::Sandwich sandwich;
    if (kind == "sandwich") {
      const double count = reader.required_number("layers", Quantity::pure);
      if (reader.has("layers") && reader.errors() == before && count != std::floor(count))
        reader.error("layers", fmt::format("{:.6g}", count), "rubber layers are counted in whole numbers",
                     "give the number of rubber layers");
      sandwich.layers = count >= 1 && count <= 1000 && count == std::floor(count) ? static_cast<int>(count) : 0;
      sandwich.plate_thickness = reader.required_number("plate_thickness", Quantity::length);
      if (sandwich.layers > 0) layers = fem::sandwich_layers(sandwich.layers, thickness, sandwich.plate_thickness);
      shape.length = sandwich.layers * thickness + (sandwich.layers - 1) * sandwich.plate_thickness;
    }
    const LayerFormulas formulas = read_formulas(reader);
    if (rectangular) {
      elements::RubberBlock block = read_block(reader);
      block.thickness = thickness;
      block.formulas = formulas;
      sandwich.layer = block;
      shape.formulas = block;
      shape.solid = fem::Block{block.width_1, block.width_2, layers};
    } else {
      elements::RubberDisc disc = read_disc(reader);
      disc.thickness = thickness;
      disc.formulas = formulas;
      sandwich.layer = disc;
      shape.formulas = disc;
      shape.solid = fem::Disc{2 * disc.radius, layers};
    }
    if (kind == "sandwich") shape.formulas = sandwich;
  }
  const auto rubber = read_rubber(reader);
  if (rubber)
    std::visit(
        [&](auto& law) {
          if constexpr (std::is_same_v<std::decay_t<decltype(law)>, elements::Sandwich>)
            std::visit([&](auto& layer) { layer.rubber = *rubber; }, law.layer);
          else law.rubber = *rubber;
        },
        shape.formulas);
  if (reader.errors() > before) {
    reader.add(check(shape), shape_keys());  // of the values that could be read
    return std::nullopt;
  }
  shape.materials = {fem::Material{.c10 = rubber->shear_modulus / 2, .bulk_modulus = rubber->bulk_modulus},
                     plate_metal()};
  return shape;
}

const TableReader::Names& shape_keys() {
  static const TableReader::Names names = {{"radius", "diameter"},
                                           {"hole_radius", "hole_diameter"},
                                           {"inner_radius", "inner_diameter"},
                                           {"outer_radius", "outer_diameter"},
                                           {"width_1", "width_x"},
                                           {"width_2", "width_y"},
                                           {"shear_modulus", "material"},
                                           {"bulk_modulus", "material"}};
  return names;
}

foundation::Problems check(const RubberShape& shape) {
  return std::visit([](const auto& law) { return elements::check(law); }, shape.formulas);
}

elements::Matrix12 stiffness_by_formulas(const RubberShape& shape) {
  if (const auto* disc = std::get_if<elements::RubberDisc>(&shape.formulas)) return elements::rubber_disc(*disc);
  if (const auto* block = std::get_if<elements::RubberBlock>(&shape.formulas)) return elements::rubber_block(*block);
  if (const auto* bush = std::get_if<elements::RubberBush>(&shape.formulas)) return elements::rubber_bush(*bush);
  return elements::sandwich(std::get<elements::Sandwich>(shape.formulas));
}

}  // namespace trivet::project
