// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "trivet/fem/mesh_checks.h"
#include "trivet/fem/preload.h"
#include "trivet/fem/step_mesh.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/element_cache.h"
#include "trivet/study/element_parts.h"
#include "trivet/study/material_reader.h"
#include "trivet/study/rubber_shape.h"

namespace trivet::study {
namespace {

/// Raised whenever meshes or kernels change, so that no older result is taken out of the cache.
constexpr const char* method = "finite elements 1";

/// A solid between its plates, whatever it was made from.
struct Solid {
  fem::Mesh mesh;
  std::optional<fem::Mesh> coarse;   ///< for the error estimate of hexahedra
  double refinement = 1.5;           ///< element sizes of the coarse mesh over those of the fine one
  std::vector<fem::Material> materials;
  fem::ElementFrame frame;
};

/// Axial compression before vibration [m], or the force that causes it [N].
struct Compression {
  double value = 0;
  bool is_force = false;
};

std::optional<Compression> read_compression(TableReader& reader) {
  const Node* table = reader.table("preload");
  if (!table) return std::nullopt;
  TableReader preload(*table, reader.path() + ".preload", reader.problems());
  const auto by = preload.number("compression", Quantity::length), with = preload.number("force", Quantity::force);
  if (preload.has("compression") == preload.has("force"))
    preload.error("force", preload.has("force") ? "compression and force" : "neither compression nor force", "the preload is one of them, positive in compression", "give one");
  preload.finish();
  if (with) return Compression{*with, true};
  if (by) return Compression{*by, false};
  return std::nullopt;
}

std::vector<double> numbers_of(const fem::SolidStiffness& s) {
  std::vector<double> numbers(s.stiffness.data(), s.stiffness.data() + 144);
  numbers.insert(numbers.end(), s.relative_error.data(), s.relative_error.data() + 144);
  numbers.insert(numbers.end(), {s.rigid_residual, double(s.unknowns), double(s.elements)});
  return numbers;
}

fem::SolidStiffness solid_stiffness(const std::vector<double>& numbers) {
  fem::SolidStiffness s;
  s.stiffness = Eigen::Map<const elements::Matrix12>(numbers.data());
  s.relative_error = Eigen::Map<const elements::Matrix12>(numbers.data() + 144);
  s.rigid_residual = numbers[288];
  s.unknowns = static_cast<int>(numbers[289]);
  s.elements = static_cast<int>(numbers[290]);
  return s;
}

std::vector<double> numbers_of(const fem::PreloadedStiffness& p) {
  std::vector<double> numbers(p.stiffness.data(), p.stiffness.data() + 144);
  numbers.insert(numbers.end(), p.preload.data(), p.preload.data() + 12);
  numbers.insert(numbers.end(), p.arm.data(), p.arm.data() + 3);
  numbers.insert(numbers.end(), {p.motion(2), double(p.negative_eigenvalues)});
  return numbers;
}

/// Computes, or takes the numbers of an earlier run.
template <typename Make, typename Compute>
std::vector<double> remembered(const std::string& key, std::size_t count, const Make& make, const Compute& numbers) {
  if (const auto kept = cached_numbers(key); kept && kept->size() == count) return *kept;
  std::vector<double> found = numbers(make());
  keep_numbers(key, found);
  return found;
}

void add_error_facts(const fem::SolidStiffness& s, model::Element& element) {
  element.facts.push_back({"found by", fmt::format("finite elements: {} elements, {} unknowns", s.elements, s.unknowns)});
  if (s.relative_error.isZero(0)) {
    element.facts.push_back({"estimated error of the mesh", "not estimated: level 1 has no coarser mesh beside it"});
    return;
  }
  std::string errors;
  static constexpr std::array<const char*, 6> words = {"shear x", "shear y", "axial", "tilt x", "tilt y", "torsion"};
  for (int j = 0; j < 6; ++j) errors += fmt::format("{}{} {:.2g} %", j ? ", " : "", words[static_cast<std::size_t>(j)], 100 * s.relative_error(6 + j, 6 + j));
  element.facts.push_back({"estimated error of the mesh", errors});
  const elements::Vector12 scale = s.stiffness.diagonal().cwiseSqrt();
  element.evidence = model::Evidence{s.relative_error.cwiseProduct(scale * scale.transpose()), "estimated error of the mesh", {}};
}

/// Stiffness, preloaded or not, of the solid that `make` builds. Returns the distance of the plates in that state.
template <typename Make>
LengthOf condensed(TableReader& reader, const std::string& key, const Make& make, const std::optional<Compression>& compression, model::Element& element) {
  const std::size_t before = reader.errors();
  try {
    std::optional<Solid> solid;  // meshed once, and only if something is not remembered
    const auto meshed = [&]() -> const Solid& {
      if (!solid) solid = make();
      return *solid;
    };
    if (!compression) {
      const fem::SolidStiffness s = solid_stiffness(remembered(key + "-free", 291, [&] {
        const Solid& it = meshed();
        return it.coarse ? fem::condense(it.mesh, *it.coarse, it.refinement, it.materials, it.frame) : fem::condense(it.mesh, it.materials, it.frame);
      }, [](const fem::SolidStiffness& found) { return numbers_of(found); }));
      element.law.nominal_stiffness = s.stiffness;
      add_error_facts(s, element);
      return std::nullopt;
    }
    const std::string preload_key = content_key(fmt::format("{} preload {:.17g} {}", key, compression->value, compression->is_force));
    const std::vector<double> p = remembered(preload_key, 161, [&] {
      const Solid& it = meshed();
      fem::Preload load;
      load.value(2) = -compression->value;
      load.is_load[2] = compression->is_force;
      fem::PreloadedStiffness found = fem::preloaded_stiffness(it.mesh, it.materials, it.frame, load);
      if (!found.converged) throw foundation::NotComputable(found.why_not);
      return found;
    }, [](const fem::PreloadedStiffness& found) { return numbers_of(found); });
    element.law.nominal_stiffness = Eigen::Map<const elements::Matrix12>(p.data());
    element.law.preload = elements::Vector12(Eigen::Map<const elements::Vector12>(p.data() + 144));
    element.facts.push_back({"found by", "finite elements, linearised about its preload"});
    element.facts.push_back({"compressed by", fmt::format("{:.6g} m", -p[159])});
    element.facts.push_back({"preload", fmt::format("{:.6g} N of compression", -(*element.law.preload)(8))});
    if (p[160] > 0)
      reader.error("preload", fmt::format("{} negative pivots", p[160]), "a mount that has buckled between its plates carries nothing", "lower the preload");
    return p[158];
  } catch (const foundation::InvalidInput& reason) {
    if (reader.errors() == before)  // the mesher tells more
      reader.error(reader.has("step") ? "step" : "type", reason.what(), "the solid cannot be condensed", "mend the solid, its plates or its mesh");
  } catch (const foundation::NotComputable& reason) {
    reader.error(compression ? "preload" : "type", reason.what(), "the static state must exist", "lower the preload, or look at the solid and its plates");
  }
  return std::nullopt;
}

int read_mesh_level(TableReader& reader) {
  constexpr int finest = 8;
  const auto level = reader.number("mesh_level", Quantity::pure);
  if (level && !(*level >= 1 && *level <= finest && *level == std::floor(*level))) {
    reader.error("mesh_level", fmt::format("{:.6g}", *level), fmt::format("a whole number from 1 to {}; the elements grow as its cube", finest), "3 is the default");
    return fem::default_level;
  }
  return level ? static_cast<int>(*level) : fem::default_level;
}

/// Material of hyperelastic solids: {G, bulk_modulus, law = "neo_hookean" | {mooney_rivlin = [c10, c01]} | {yeoh = [c10, c20, c30]}}.
void read_large_strain(TableReader& reader, fem::Material& material) {
  const auto mooney = reader.numbers("mooney_rivlin", Quantity::pressure), yeoh = reader.numbers("yeoh", Quantity::pressure);
  const double bulk = material.bulk_modulus;
  if (mooney && mooney->size() == 2) material = {.c10 = (*mooney)[0], .c01 = (*mooney)[1], .bulk_modulus = bulk};
  else if (mooney) reader.error("mooney_rivlin", fmt::format("{} numbers", mooney->size()), "it has two constants: [c10, c01]", "give two");
  if (yeoh && yeoh->size() == 3) material = {.c10 = (*yeoh)[0], .c20 = (*yeoh)[1], .c30 = (*yeoh)[2], .bulk_modulus = bulk};
  else if (yeoh) reader.error("yeoh", fmt::format("{} numbers", yeoh->size()), "it has three constants: [c10, c20, c30]", "give three");
  if (mooney && yeoh) reader.error("yeoh", "mooney_rivlin and yeoh", "a rubber has one law", "keep one of them");
  reader.add(fem::check(material), {{"shear_modulus", mooney ? "mooney_rivlin" : yeoh ? "yeoh" : "material"}, {"bulk_modulus", "material"}});
}

std::string words(const fem::Material& m) { return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g}", m.c10, m.c01, m.c20, m.c30, m.bulk_modulus); }

std::string words(const fem::Shape& shape) {
  const auto layers = [](const std::vector<fem::Layer>& list) {
    std::string text;
    for (const fem::Layer& layer : list) text += fmt::format(" {:.17g}/{}/{}", layer.thickness, layer.material, layer.metal);
    return text;
  };
  if (const auto* disc = std::get_if<fem::Disc>(&shape)) return fmt::format("disc {:.17g}{}", disc->diameter, layers(disc->layers));
  if (const auto* block = std::get_if<fem::Block>(&shape)) return fmt::format("block {:.17g} {:.17g}{}", block->width, block->depth, layers(block->layers));
  const auto& bush = std::get<fem::Bush>(shape);
  return fmt::format("bush {:.17g} {:.17g} {:.17g}", bush.inner_diameter, bush.outer_diameter, bush.length);
}

LengthOf shape_by_elements(TableReader& reader, RubberShape& shape, model::Element& element) {
  const std::size_t before = reader.errors();
  const int level = read_mesh_level(reader);
  if (const auto* disc = std::get_if<elements::RubberDisc>(&shape.formulas); disc && disc->hole_radius > 0)
    reader.error("hole_diameter", "a disc with a hole", "the parametric mesh has none", "use closed formulas, or a STEP file");
  if (const auto* sandwich = std::get_if<elements::Sandwich>(&shape.formulas))
    if (const auto* disc = std::get_if<elements::RubberDisc>(&sandwich->layer); disc && disc->hole_radius > 0)
      reader.error("hole_diameter", "a sandwich with a hole", "the parametric mesh has none", "use closed formulas, or a STEP file");
  read_large_strain(reader, shape.materials[0]);
  const auto compression = read_compression(reader);
  if (reader.errors() > before) return std::nullopt;
  const std::string key = content_key(fmt::format("{} {} level {} {} {}", method, words(shape.solid), level, words(shape.materials[0]), words(shape.materials[1])));
  const LengthOf moved = condensed(reader, key, [&] {
    Solid solid{fem::mesh(shape.solid, level), std::nullopt, static_cast<double>(level) / (level - 1.0), shape.materials, fem::frame(shape.solid)};
    if (level > 1) solid.coarse = fem::mesh(shape.solid, level - 1);
    return solid;
  }, compression, element);
  return moved ? moved : LengthOf(shape.length);
}

/// Finite elements do not care for the range of the formulas.
foundation::Problems findings_of(const RubberShape& shape, bool by_elements) {
  foundation::Problems result;
  const foundation::Problems all = check(shape);
  const auto* bush = std::get_if<elements::RubberBush>(&shape.formulas);
  for (const foundation::Problem& problem : all.list()) {
    const bool of_formulas = problem.severity == foundation::Severity::warning || (bush && bush->length > 0 && problem.subject == "length");
    if (!by_elements || !of_formulas) result.add(problem);
  }
  return result;
}

LengthOf read_rubber_mount(TableReader& reader, const std::string& kind, model::Element& element) {
  const bool by_elements = reader.choice("method", {"formulas", "finite_elements"}) == "finite_elements";
  reader.also_known({"mesh_level", "mooney_rivlin", "yeoh", "preload"});
  auto shape = read_rubber_shape(reader, kind);
  if (!by_elements)
    for (const char* key : {"mesh_level", "mooney_rivlin", "yeoh", "preload"}) {
      if (reader.has(key)) reader.error(key, std::string(key) + " with closed formulas", "it belongs to finite elements", "add method = \"finite_elements\", or remove it");
    }
  if (!shape) return std::nullopt;
  const foundation::Problems findings = findings_of(*shape, by_elements);
  reader.add(findings, shape_keys());
  if (findings.has_errors()) return std::nullopt;
  if (by_elements) return shape_by_elements(reader, *shape, element);
  element.law.nominal_stiffness = stiffness_by_formulas(*shape);
  const bool textbook = reader.text("formulas") == "textbook";
  element.facts.push_back({"found by", textbook ? "textbook formulas of bonded rubber; 3 to 40 % from finite elements, see docs/elements/rubber.md"
                                                : "closed formulas of bonded rubber, mostly within 5 % of finite elements"});
  element.facts.push_back({"shear modulus", fmt::format("{:.6g} Pa at rest; compounds of one hardness scatter by 20 %", 2 * shape->materials[0].c10)});
  return shape->length;
}

/// "top", "bottom" and their like, {cylinder = radius, point, axis}, {faces = [1, 4]}, {low, high}.
std::optional<fem::FaceSelection> read_plate(TableReader& reader, const std::string& key) {
  const Node* node = reader.node(key);
  if (!node) return std::nullopt;
  if (node->kind != Node::Kind::table) {
    const auto direction = reader.direction(key);
    return direction ? std::optional<fem::FaceSelection>(fem::FurthestFaces{*direction}) : std::nullopt;
  }
  TableReader plate(*node, reader.path() + "." + key, reader.problems());
  std::optional<fem::FaceSelection> selection;
  if (const auto faces = plate.numbers("faces", Quantity::pure)) {
    fem::FacesByNumber numbers;
    for (const double face : *faces) {
      if (face >= 1 && face < 1e9 && face == std::floor(face)) numbers.numbers.push_back(static_cast<int>(face));
      else plate.error("faces", fmt::format("{:.6g}", face), "faces are numbered from 1 in the order of the file", "give whole numbers");
    }
    selection = numbers;
  } else if (const auto diameter = plate.number("cylinder", Quantity::length)) {
    if (!(*diameter > 0)) plate.error("cylinder", fmt::format("{:.6g} m", *diameter), "the diameter of a cylinder is > 0", "mend the value or its unit");
    fem::FacesOnCylinder cylinder{*diameter / 2};
    cylinder.point = plate.vector("point", Quantity::length).value_or(Eigen::Vector3d::Zero());
    cylinder.axis = plate.direction("axis").value_or(Eigen::Vector3d::UnitZ());
    selection = cylinder;
  } else if (plate.has("low") || plate.has("high")) {
    const auto low = plate.vector("low", Quantity::length), high = plate.vector("high", Quantity::length);
    if (low && high) selection = fem::FacesInBox{*low, *high};
    else plate.error("low", "one corner", "a box of faces has two corners", "give low and high");
  } else {
    reader.error(key, "no selection", "faces are chosen by a direction (\"-z\": the furthest plane face), {faces}, {cylinder}, or {low, high}", "give one of them");
  }
  plate.finish();
  return selection;
}

/// One material for all solids of the file, or one per solid in its order: a rubber table or the name of a metal.
std::vector<fem::Material> read_solid_materials(TableReader& reader) {
  const Node* list = reader.node("materials");
  if (!list) {
    const auto rubber = read_rubber(reader);
    if (!rubber) return {};
    fem::Material material{.c10 = rubber->shear_modulus / 2, .bulk_modulus = rubber->bulk_modulus};
    read_large_strain(reader, material);
    return {material};
  }
  std::vector<fem::Material> materials;
  for (const char* key : {"material", "mooney_rivlin", "yeoh"})
    if (reader.node(key)) reader.error(key, std::string(key) + " beside materials", "materials holds all there is about them", "remove one of the two");
  if (list->kind != Node::Kind::array || list->items.empty()) {
    reader.error("materials", list->kind == Node::Kind::array ? "an empty list" : words(list->kind), "it is a list, one material per solid of the file", "write materials = [{G = \"0.7 MPa\"}, \"steel\"]");
    return {};
  }
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    Node one;
    one.keys = {"material"};
    one.items = {list->items[i]};
    one.origin = list->items[i].origin;
    TableReader single(one, fmt::format("{}.materials[{}]", reader.path(), i), reader.problems());
    if (list->items[i].kind == Node::Kind::text) {
      if (const auto metal = read_metal(single)) materials.push_back(fem::linear_elastic(metal->young_modulus, metal->young_modulus / (2 * metal->shear_modulus) - 1));
    } else if (const auto rubber = read_rubber(single)) {
      if (list->items[i].find("stiffening"))
        reader.error("materials", "stiffening of one material among several", "it applies to the mount as a whole", "multiply G of this material by it, or leave it out");
      materials.push_back({.c10 = rubber->shear_modulus / 2, .bulk_modulus = rubber->bulk_modulus});
      single.add(fem::check(materials.back()), {{"shear_modulus", "material"}, {"bulk_modulus", "material"}});
    }
  }
  return materials;
}

LengthOf read_step_mount(TableReader& reader, model::Element& element) {
  const std::size_t before = reader.errors();
  const auto file = read_file_name(reader, "step");
  fem::StepMeshOptions options;
  const std::size_t before_size = reader.errors();
  options.size = reader.required_number("mesh_size", Quantity::length);
  if (reader.errors() == before_size && !(options.size > 0)) reader.error("mesh_size", fmt::format("{:.6g} m", options.size), "the edge of the elements is > 0", "mend the value or its unit");
  options.rim_size = reader.number("rim_size", Quantity::length).value_or(0);
  options.rim_distance = reader.number("rim_distance", Quantity::length).value_or(0);
  if (const auto plate = read_plate(reader, "plate_n")) options.plate_n = *plate;
  if (const auto plate = read_plate(reader, "plate_k")) options.plate_k = *plate;
  const auto axis = reader.direction("step_axis").value_or(Eigen::Vector3d::UnitZ());
  const std::vector<fem::Material> materials = read_solid_materials(reader);
  const auto compression = read_compression(reader);
  if (reader.errors() > before) return std::nullopt;
  std::string words_of_all = fmt::format("{} step {:.17g} {:.17g} {:.17g}", method, options.size, options.rim_size, options.rim_distance);
  for (const fem::Material& material : materials) words_of_all += " " + words(material);
  for (const char* key : {"plate_n", "plate_k", "step_axis"})
    if (const Node* node = reader.node(key)) words_of_all += fmt::format(" {} {}", key, canonical(*node));
  const std::string key = content_key(words_of_all, {file->string()});
  double distance = 0;
  const auto make = [&] {
    auto meshed = fem::mesh_step(*file, options);
    if (!meshed) {
      reader.add(meshed.error(), {{"file", "step"}, {"size", "mesh_size"}});
      throw foundation::InvalidInput("the STEP file gives no mesh");
    }
    if (materials.size() != 1 && materials.size() != static_cast<std::size_t>(meshed->solids)) {
      reader.error("materials", fmt::format("{} materials", materials.size()), fmt::format("the file holds {} solids", meshed->solids), "give one for all, or one per solid in the order of the file");
      throw foundation::InvalidInput("materials and solids differ in number");
    }
    Solid solid{std::move(meshed->mesh), std::nullopt, 1, materials, {meshed->centre_n, meshed->centre_k, spatial::axes_along(axis)}};
    if (materials.size() == 1) std::fill(solid.mesh.material.begin(), solid.mesh.material.end(), 0);
    distance = axis.dot(meshed->centre_k - meshed->centre_n);
    const double aside = (meshed->centre_k - meshed->centre_n - distance * axis).norm();
    if (aside > 1e-6 * std::abs(distance) && aside > 1e-9)
      throw foundation::InvalidInput(fmt::format("the centres of plates N and K lie {:.6g} m aside of each other across step_axis", aside));
    keep_numbers(key + "-length", {distance});
    return solid;
  };
  const LengthOf moved = condensed(reader, key, make, compression, element);
  if (moved) return moved;
  if (const auto kept = cached_numbers(key + "-length"); kept && kept->size() == 1) distance = (*kept)[0];
  return distance;
}

/// Which keys belong here is not known without a shape.
void know_all_keys(TableReader& reader) {
  reader.also_known({"step", "shape", "mesh_size", "rim_size", "rim_distance", "plate_n", "plate_k", "step_axis", "materials", "material", "mesh_level", "mooney_rivlin", "yeoh",
                     "preload", "diameter", "hole_diameter", "thickness", "formulas", "width_x", "width_y", "layers", "plate_thickness", "inner_diameter", "outer_diameter", "length"});
}

/// Rubber is stiffer in vibration than at rest: found with the static moduli, the element then moves with `stiffening` times the stiffness of
/// its deformations; what a preload does in a rigid motion stays.
LengthOf stiffened(TableReader& reader, LengthOf length, model::Element& element) {
  const Node* material = reader.has("material") ? reader.node("material") : nullptr;
  const Node* given = material ? material->find("stiffening") : nullptr;
  if (!length || !given || given->number == 1) return length;
  const Eigen::Matrix<double, 12, 6> rigid = elements::rigid_motions({0, 0, *length}, Eigen::Matrix3d::Identity());
  const elements::Matrix6 metric = rigid.transpose() * rigid;
  const elements::Matrix12 deformation = elements::Matrix12::Identity() - rigid * metric.inverse() * rigid.transpose();
  const elements::Matrix12 at_rest = element.law.nominal_stiffness;
  element.law.nominal_stiffness += (given->number - 1) * deformation.transpose() * at_rest * deformation;
  if (element.evidence) element.evidence->uncertainty *= given->number;
  element.stiffening = given->number;
  element.facts.push_back({"stiffening", fmt::format("in vibration {:.4g} times as stiff as at rest; the 12×12 is that of vibration", given->number)});
  return length;
}

}  // namespace

LengthOf read_rubber_disc(TableReader& reader, model::Element& element) { return stiffened(reader, read_rubber_mount(reader, "disc", element), element); }
LengthOf read_rubber_block(TableReader& reader, model::Element& element) { return stiffened(reader, read_rubber_mount(reader, "block", element), element); }
LengthOf read_rubber_bush(TableReader& reader, model::Element& element) { return stiffened(reader, read_rubber_mount(reader, "bush", element), element); }
LengthOf read_sandwich(TableReader& reader, model::Element& element) { return stiffened(reader, read_rubber_mount(reader, "sandwich", element), element); }

LengthOf read_solid_mount(TableReader& reader, model::Element& element) {
  if (reader.has("step") == reader.has("shape")) {
    reader.error(reader.has("step") ? "shape" : "step", reader.has("step") ? "step and shape" : "neither step nor shape",
                 "a solid_mount is made from a STEP file or from a shape", "give step = \"mount.step\", or shape = \"disc\", \"block\", \"bush\" or \"sandwich\" with its dimensions");
    know_all_keys(reader);
    return std::nullopt;
  }
  if (reader.has("step")) return stiffened(reader, read_step_mount(reader, element), element);
  const auto kind = reader.choice("shape", {"disc", "block", "bush", "sandwich"});
  if (!kind) {
    know_all_keys(reader);
    return std::nullopt;
  }
  reader.also_known({"mesh_level", "mooney_rivlin", "yeoh", "preload"});
  auto shape = read_rubber_shape(reader, *kind);
  if (!shape) return std::nullopt;
  const foundation::Problems findings = findings_of(*shape, true);
  reader.add(findings, shape_keys());
  if (findings.has_errors()) return std::nullopt;
  return stiffened(reader, shape_by_elements(reader, *shape, element), element);
}

}  // namespace trivet::study
