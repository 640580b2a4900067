// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/project/elements/condensed_solid.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/rubber_shape.h"

namespace trivet::project {
namespace {

int read_mesh_level(TableReader& reader) {
  constexpr int finest = 8;
  const auto level = reader.number("mesh_level", Quantity::pure);
  if (level && !(*level >= 1 && *level <= finest && *level == std::floor(*level))) {
    reader.error("mesh_level", fmt::format("{:.6g}", *level),
                 fmt::format("a whole number from 1 to {}; the number of finite elements grows with its cube", finest),
                 "3 is the default");
    return fem::default_level;
  }
  return level ? static_cast<int>(*level) : fem::default_level;
}

std::string description(const fem::Shape& shape) {
  const auto layers = [](const std::vector<fem::Layer>& list) {
    std::string text;
    for (const fem::Layer& layer : list)
      text += fmt::format(" {:.17g}/{}/{}", layer.thickness, layer.material, layer.metal);
    return text;
  };
  if (const auto* disc = std::get_if<fem::Disc>(&shape))
    return fmt::format("disc {:.17g}{}", disc->diameter, layers(disc->layers));
  if (const auto* block = std::get_if<fem::Block>(&shape))
    return fmt::format("block {:.17g} {:.17g}{}", block->width, block->depth, layers(block->layers));
  const auto& bush = std::get<fem::Bush>(shape);
  return fmt::format("bush {:.17g} {:.17g} {:.17g}", bush.inner_diameter, bush.outer_diameter, bush.length);
}

/// Thickness of all rubber along e3; of a bush that of its wall.
double rubber_thickness(const fem::Shape& shape) {
  const auto sum = [](const std::vector<fem::Layer>& layers) {
    double thickness = 0;
    for (const fem::Layer& layer : layers) thickness += layer.metal ? 0 : layer.thickness;
    return thickness;
  };
  if (const auto* disc = std::get_if<fem::Disc>(&shape)) return sum(disc->layers);
  if (const auto* block = std::get_if<fem::Block>(&shape)) return sum(block->layers);
  const auto& bush = std::get<fem::Bush>(shape);
  return (bush.outer_diameter - bush.inner_diameter) / 2;
}

ElementLength shape_by_elements(TableReader& reader, RubberShape& shape, model::Element& element) {
  const std::size_t before = reader.errors();
  const int level = read_mesh_level(reader);
  if (const auto* disc = std::get_if<elements::RubberDisc>(&shape.formulas); disc && disc->hole_radius > 0)
    reader.error("hole_diameter", "a disc with a hole", "the parametric mesh has no hole",
                 "use closed formulas, or a STEP file");
  if (const auto* sandwich = std::get_if<elements::Sandwich>(&shape.formulas))
    if (const auto* disc = std::get_if<elements::RubberDisc>(&sandwich->layer); disc && disc->hole_radius > 0)
      reader.error("hole_diameter", "a sandwich with a hole", "the parametric mesh has no hole",
                   "use closed formulas, or a STEP file");
  read_large_strain(reader, shape.materials[0]);
  const auto compression = read_compression(reader);
  const double rubber = rubber_thickness(shape.solid);
  const auto stroke = std::holds_alternative<fem::Bush>(shape.solid) ? read_stroke_of_bush(reader, rubber)
                                                                     : read_stroke(reader, rubber);
  if (reader.errors() > before) return std::nullopt;
  const std::string key =
      solid_key(fmt::format("{} level {} {} {}", description(shape.solid), level, constants_text(shape.materials[0]),
                            constants_text(shape.materials[1])));
  const ElementLength moved = condensed(
      reader, key,
      [&] {
        Solid solid{fem::mesh(shape.solid, level), std::nullopt, static_cast<double>(level) / (level - 1.0),
                    shape.materials, fem::frame(shape.solid)};
        if (level > 1) solid.coarse = fem::mesh(shape.solid, level - 1);
        return solid;
      },
      compression, stroke, element);
  return moved ? moved : ElementLength(shape.length);
}

/// Findings of a shape; for finite elements without those on the range of the formulas.
foundation::Problems findings_of(const RubberShape& shape, bool by_elements) {
  foundation::Problems result;
  const foundation::Problems all = check(shape);
  const auto* bush = std::get_if<elements::RubberBush>(&shape.formulas);
  for (const foundation::Problem& problem : all.list()) {
    const bool of_formulas =
        problem.severity == foundation::Severity::warning || (bush && bush->length > 0 && problem.subject == "length");
    if (!by_elements || !of_formulas) result.add(problem);
  }
  return result;
}

ElementLength read_rubber_mount(TableReader& reader, const std::string& kind, model::Element& element) {
  const bool by_elements = reader.choice("method", {"formulas", "finite_elements"}) == "finite_elements";
  reader.also_known({"mesh_level", "mooney_rivlin", "yeoh", "preload", "nonlinear", "range"});
  auto shape = read_rubber_shape(reader, kind);
  if (!by_elements)
    for (const char* key : {"mesh_level", "mooney_rivlin", "yeoh", "preload", "nonlinear", "range"}) {
      if (reader.has(key))
        reader.error(key, std::string(key) + " with closed formulas", "it belongs to finite elements",
                     "add method = \"finite_elements\", or remove it");
    }
  if (!shape) return std::nullopt;
  const foundation::Problems findings = findings_of(*shape, by_elements);
  reader.add(findings, shape_keys());
  if (findings.has_errors()) return std::nullopt;
  if (by_elements) return shape_by_elements(reader, *shape, element);
  element.law.nominal_stiffness = stiffness_by_formulas(*shape);
  const bool textbook = reader.has("formulas") && reader.text("formulas") == "textbook";
  element.facts.push_back(
      {"found by",
       textbook ? "textbook formulas of bonded rubber; 3 to 40 % from finite elements, see docs/elements/rubber.md"
                : "closed formulas of bonded rubber, mostly within 5 % of finite elements"});
  element.facts.push_back(
      {"shear modulus",
       fmt::format("{:.6g} Pa at rest; compounds of one hardness scatter by 20 %", 2 * shape->materials[0].c10)});
  return shape->length;
}

/// Marks all keys as known: without a shape, the valid keys are not known.
void know_all_keys(TableReader& reader) {
  reader.also_known({"step",           "shape",          "mesh_size", "rim_size", "rim_distance", "plate_n",
                     "plate_k",        "step_axis",      "materials", "material", "mesh_level",   "mooney_rivlin",
                     "yeoh",           "preload",        "nonlinear", "range",    "diameter",     "hole_diameter",
                     "thickness",      "formulas",       "width_x",   "width_y",  "layers",       "plate_thickness",
                     "inner_diameter", "outer_diameter", "length"});
}

ElementLength read_rubber_disc(TableReader& reader, model::Element& element) {
  return read_rubber_mount(reader, "disc", element);
}
ElementLength read_rubber_block(TableReader& reader, model::Element& element) {
  return read_rubber_mount(reader, "block", element);
}
ElementLength read_rubber_bush(TableReader& reader, model::Element& element) {
  return read_rubber_mount(reader, "bush", element);
}
ElementLength read_sandwich(TableReader& reader, model::Element& element) {
  return read_rubber_mount(reader, "sandwich", element);
}

ElementLength read_solid_mount(TableReader& reader, model::Element& element) {
  if (reader.has("step") == reader.has("shape")) {
    reader.error(
        reader.has("step") ? "shape" : "step", reader.has("step") ? "step and shape" : "neither step nor shape",
        "a solid_mount is made from a STEP file or from a shape",
        "give step = \"mount.step\", or shape = \"disc\", \"block\", \"bush\" or \"sandwich\" with its dimensions");
    know_all_keys(reader);
    return std::nullopt;
  }
  if (reader.has("step")) return read_step_mount(reader, element);
  const auto kind = reader.choice("shape", {"disc", "block", "bush", "sandwich"});
  if (!kind) {
    know_all_keys(reader);
    return std::nullopt;
  }
  reader.also_known({"mesh_level", "mooney_rivlin", "yeoh", "preload", "nonlinear", "range"});
  auto shape = read_rubber_shape(reader, *kind);
  if (!shape) return std::nullopt;
  const foundation::Problems findings = findings_of(*shape, true);
  reader.add(findings, shape_keys());
  if (findings.has_errors()) return std::nullopt;
  return shape_by_elements(reader, *shape, element);
}

}  // namespace

const ElementLaw rubber_disc_law = {
    .type = "rubber_disc",
    .sized = read_rubber_disc,
    .keys = R"json({"with": ["disc", "layer", "rubber", "method", "large_strain"]})json",
};
const ElementLaw rubber_block_law = {
    .type = "rubber_block",
    .sized = read_rubber_block,
    .keys = R"json({"with": ["block", "layer", "rubber", "method", "large_strain"]})json",
};
const ElementLaw rubber_bush_law = {
    .type = "rubber_bush",
    .sized = read_rubber_bush,
    .keys = R"json({"with": ["bush", "rubber", "method", "large_strain"]})json",
};

const ElementLaw sandwich_law = {.type = "sandwich", .sized = read_sandwich, .keys = R"json([
 {"with": ["disc", "layer", "layers", "rubber", "method", "large_strain"]},
 {"with": ["block", "layer", "layers", "rubber", "method", "large_strain"]}])json"};

const ElementLaw solid_mount_law = {.type = "solid_mount", .sized = read_solid_mount, .keys = R"json([
 {"with": ["large_strain"],
  "properties": {
   "step": {"type": "string", "description": "STEP file, relative to the project file"},
   "mesh_size": {"$ref": "#/$defs/number", "description": "size of the finite elements, m, > 0"},
   "rim_size": {"$ref": "#/$defs/number",
     "description": "size of the finite elements at bonded rims, m (default: mesh_size/4)"},
   "rim_distance": {"$ref": "#/$defs/number",
     "description": "distance from a rim at which the full size is reached, m (default: 2 mesh_size)"},
   "plate_n": {"$ref": "#/$defs/plate", "description": "faces on the plate of end N (default: furthest along -z)"},
   "plate_k": {"$ref": "#/$defs/plate", "description": "faces on the plate of end K (default: furthest along z)"},
   "step_axis": {"$ref": "#/$defs/direction", "description": "e3 in the axes of the file (default: z)"},
   "material": {"$ref": "#/$defs/rubber"},
   "materials": {"type": "array", "items": {"anyOf": [{"$ref": "#/$defs/rubber"}, {"$ref": "#/$defs/metal"}]},
     "minItems": 1, "description": "one per solid, in the order of the file"}},
  "required": ["step", "mesh_size"],
  "oneOf": [{"required": ["material"]}, {"required": ["materials"]}]},
 {"properties": {"shape": {"const": "disc",
   "description": "with the keys of rubber_disc, rubber_block, rubber_bush or sandwich; or step"}}, "required": ["shape"], "with": ["disc", "layer", "rubber",
   "large_strain"]},
 {"properties": {"shape": {"const": "block"}}, "required": ["shape"], "with": ["block", "layer", "rubber",
   "large_strain"]},
 {"properties": {"shape": {"const": "bush"}}, "required": ["shape"], "with": ["bush", "rubber", "large_strain"]},
 {"properties": {"shape": {"const": "sandwich"}}, "required": ["shape"], "with": ["disc", "layer", "layers",
   "rubber", "large_strain"]},
 {"properties": {"shape": {"const": "sandwich"}}, "required": ["shape"], "with": ["block", "layer", "layers",
   "rubber", "large_strain"]}])json"};

}  // namespace trivet::project
