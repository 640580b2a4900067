// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/fem/mesh.h"
#include "trivet/fem/step_mesh.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/thread_progress.h"
#include "trivet/project/elements/condensed_solid.h"
#include "trivet/project/elements/element_cache.h"
#include "trivet/project/elements/material_reader.h"
#include "trivet/project/text/source_file.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::project {
namespace {

/// A direction such as "-z", {cylinder = diameter, point, axis}, {faces = [1, 4]} or {low, high}.
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
      else
        plate.error("faces", fmt::format("{:.6g}", face), "faces are numbered from 1 in the order of the file",
                    "give whole numbers");
    }
    selection = numbers;
  } else if (const auto diameter = plate.number("cylinder", Quantity::length)) {
    if (!(*diameter > 0))
      plate.error("cylinder", fmt::format("{:.6g} m", *diameter), "the diameter of a cylinder is > 0",
                  "correct the value or its unit");
    fem::FacesOnCylinder cylinder{*diameter / 2};
    cylinder.point = plate.vector("point", Quantity::length).value_or(Eigen::Vector3d::Zero());
    cylinder.axis = plate.direction("axis").value_or(Eigen::Vector3d::UnitZ());
    selection = cylinder;
  } else if (plate.has("low") || plate.has("high")) {
    const auto low = plate.vector("low", Quantity::length), high = plate.vector("high", Quantity::length);
    if (low && high) selection = fem::FacesInBox{*low, *high};
    else plate.error("low", "one corner", "a box of faces has two corners", "give low and high");
  } else {
    reader.error(
        key, "no selection",
        "faces are chosen by a direction (\"-z\": the furthest plane face), {faces}, {cylinder}, or {low, high}",
        "give one of them");
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
    if (reader.node(key))
      reader.error(key, std::string(key) + " together with materials", "materials has all data of the materials",
                   "remove one of the two");
  if (list->kind != Node::Kind::array || list->items.empty()) {
    reader.error("materials", list->kind == Node::Kind::array ? "an empty list" : kind_name(list->kind),
                 "it is a list, one material per solid of the file",
                 "write materials = [{G = \"0.7 MPa\"}, \"steel\"]");
    return {};
  }
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    Node one;
    one.keys = {"material"};
    one.items = {list->items[i]};
    one.origin = list->items[i].origin;
    TableReader single(one, fmt::format("{}.materials[{}]", reader.path(), i), reader.problems());
    if (list->items[i].kind == Node::Kind::text) {
      if (const auto metal = read_metal(single))
        materials.push_back(
            fem::linear_elastic(metal->young_modulus, metal->young_modulus / (2 * metal->shear_modulus) - 1));
    } else if (const auto rubber = read_rubber(single)) {
      if (list->items[i].find("stiffening"))
        reader.error("materials", "stiffening of one material among several", "it applies to the mount as a whole",
                     "multiply G of this material by it, or remove it");
      if (list->items[i].find("creep"))
        reader.error("materials", "creep of one material among several", "it applies to the mount as a whole",
                     "remove it");
      materials.push_back({.c10 = rubber->shear_modulus / 2, .bulk_modulus = rubber->bulk_modulus});
      single.add(fem::check(materials.back()), {{"shear_modulus", "material"}, {"bulk_modulus", "material"}});
    }
  }
  return materials;
}

}  // namespace

ElementLength read_step_mount(TableReader& reader, model::Element& element) {
  const std::size_t before = reader.errors();
  const auto file = read_file_name(reader, "step");
  fem::StepMeshOptions options;
  const std::size_t before_size = reader.errors();
  options.size = reader.required_number("mesh_size", Quantity::length);
  if (reader.errors() == before_size && !(options.size > 0))
    reader.error("mesh_size", fmt::format("{:.6g} m", options.size), "the size of the finite elements is > 0",
                 "correct the value or its unit");
  options.rim_size = reader.number("rim_size", Quantity::length).value_or(0);
  options.rim_distance = reader.number("rim_distance", Quantity::length).value_or(0);
  if (const auto plate = read_plate(reader, "plate_n")) options.plate_n = *plate;
  if (const auto plate = read_plate(reader, "plate_k")) options.plate_k = *plate;
  const auto axis = reader.direction("step_axis").value_or(Eigen::Vector3d::UnitZ());
  const std::vector<fem::Material> materials = read_solid_materials(reader);
  const auto compression = read_compression(reader);
  const auto stroke = read_stroke(reader, std::nullopt);
  if (reader.errors() > before) return std::nullopt;
  std::string words_of_all =
      fmt::format("step {:.17g} {:.17g} {:.17g}", options.size, options.rim_size, options.rim_distance);
  for (const fem::Material& material : materials) words_of_all += " " + constants_text(material);
  for (const char* key : {"plate_n", "plate_k", "step_axis"})
    if (const Node* node = reader.node(key)) words_of_all += fmt::format(" {} {}", key, canonical(*node));
  const std::string key = solid_key(words_of_all, {file->string()});
  std::optional<double> distance;
  const auto make = [&] {
    auto meshed = fem::mesh_step(*file, options, foundation::thread_progress());
    if (!meshed) {
      reader.add(meshed.error(), {{"file", "step"}, {"size", "mesh_size"}});
      throw foundation::InvalidInput("the STEP file gives no mesh");
    }
    if (materials.size() != 1 && materials.size() != to_size(meshed->solids)) {
      reader.error("materials", fmt::format("{} materials", materials.size()),
                   fmt::format("the file holds {} solids", meshed->solids),
                   "give one for all, or one per solid in the order of the file");
      throw foundation::InvalidInput("materials and solids differ in number");
    }
    Solid solid{std::move(meshed->mesh),
                std::nullopt,
                1,
                materials,
                {meshed->centre_n, meshed->centre_k, spatial::axes_along(axis)}};
    if (materials.size() == 1) std::ranges::fill(solid.mesh.material, 0);
    const Eigen::Vector3d across = meshed->centre_k - meshed->centre_n;
    distance = axis.dot(across);
    const double aside = (across - *distance * axis).norm();
    if (aside > 1e-6 * std::abs(*distance) && aside > 1e-9)
      throw foundation::InvalidInput(
          fmt::format("the centres of plates N and K are {:.6g} m apart perpendicular to step_axis", aside));
    keep_numbers(key + "-length", {*distance});
    return solid;
  };
  const ElementLength moved = condensed(reader, key, make, compression, stroke, element);
  if (moved || reader.errors() > before) return moved;
  if (!distance)
    if (const auto kept = cached_numbers(key + "-length"); kept && kept->size() == 1) distance = (*kept)[0];
  try {
    if (!distance) static_cast<void>(make());  // only the stiffness was in the cache
  } catch (const foundation::InvalidInput& reason) {
    if (reader.errors() == before)
      reader.error("step", reason.what(), "the mesh determines the distance of the plates",
                   "correct the solid, its plates or its mesh");
  }
  return distance;
}

}  // namespace trivet::project
