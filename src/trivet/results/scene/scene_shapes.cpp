// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/scene/scene_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "trivet/documents/integer_list.h"
#include "trivet/project/elements/element_shape.h"
#include "trivet/results/format/in_documents.h"

/// Shapes of elements and bodies as numbers.
namespace trivet::results {
namespace {

using json::Json;

std::string kind_of_law(const model::Element& element) {
  static const std::map<std::string, std::string> kinds = {{"coil_spring", "coil"},
                                                           {"rubber_disc", "rubber"},
                                                           {"rubber_block", "rubber"},
                                                           {"sandwich", "rubber"},
                                                           {"rubber_bush", "bush"},
                                                           {"solid_mount", "rubber"},
                                                           {"hydromount", "mount"},
                                                           {"beam", "beam"},
                                                           {"link", "rod"},
                                                           {"stay", "rod"},
                                                           {"strut", "strut"},
                                                           {"stop", "stop"},
                                                           {"damper", "damper"},
                                                           {"air_spring", "air_spring"},
                                                           {"wire_rope", "wire_rope"}};
  if (element.rating) return "mount";
  const auto found = kinds.find(element.type);
  return found == kinds.end() ? "matrix" : found->second;
}

struct Dimensions {
  ShownElement& shown;

  void operator()(std::monostate) const {}
  void operator()(const elements::CoilSpring& coil) const {
    shown.key = "coil";
    const auto* round = std::get_if<elements::RoundWire>(&coil.wire);
    const auto* rectangular = std::get_if<elements::RectangularWire>(&coil.wire);
    const double width = round ? round->diameter : rectangular->radial_width,
                 height = round ? round->diameter : rectangular->axial_height;
    shown.diameter = coil.mean_diameter + width;
    shown.dimensions = {{"wire", json::list(std::array{width, height})},
                        {"round", round != nullptr},
                        {"mean_diameter", coil.mean_diameter},
                        {"turns", coil.active_coils},
                        {"dead_turns", json::list(std::array{coil.dead_coils_n, coil.dead_coils_k})},
                        {"left_handed", coil.hand == elements::Hand::left},
                        {"start_angle", coil.start_angle}};
  }
  void operator()(const project::RubberForm& rubber) const {
    shown.key = "rubber";
    std::visit([&](const auto& solid) { add(solid, rubber.hole_diameter); }, rubber.solid);
  }
  void operator()(const project::SectionForm& section) const {
    shown.key = "section";
    if (section.outer > 0) {
      shown.diameter = section.outer;
      shown.dimensions = {{"outer_diameter", section.outer}, {"inner_diameter", section.inner}};
    } else {
      shown.diameter = std::max(section.sides[0], section.sides[1]);
      shown.dimensions = {{"widths", json::list(section.sides)}};
    }
  }

 private:
  static Json layers(const std::vector<fem::Layer>& list) {
    Json result = Json::array();
    for (const fem::Layer& layer : list) result.push_back({{"thickness", layer.thickness}, {"metal", layer.metal}});
    return result;
  }
  void add(const fem::Disc& disc, double hole) const {
    shown.diameter = disc.diameter;
    shown.dimensions = {{"diameter", disc.diameter}, {"hole_diameter", hole}, {"layers", layers(disc.layers)}};
  }
  void add(const fem::Block& block, double) const {
    shown.diameter = std::max(block.width, block.depth);
    shown.dimensions = {{"widths", json::list(std::array{block.width, block.depth})}, {"layers", layers(block.layers)}};
  }
  void add(const fem::Bush& bush, double) const {
    shown.kind = "bush";
    shown.length = bush.length;
    shown.diameter = bush.outer_diameter;
    shown.dimensions = {
        {"inner_diameter", bush.inner_diameter}, {"outer_diameter", bush.outer_diameter}, {"length", bush.length}};
  }
};

std::size_t count_of_triangles(const SolidSurface& surface) {
  std::size_t count = 0;
  for (const std::vector<int>& face : surface.faces) count += face.size() - 2;
  return count;
}

}  // namespace

ShownElement shown_element(const project::Case& variant, std::size_t element) {
  const model::Element& given = variant.system.elements()[element];
  const auto& bodies = variant.system.bodies();
  ShownElement shown{
      .kind = kind_of_law(given),
      .length =
          (model::end_in_ground(bodies, given.k).position - model::end_in_ground(bodies, given.n).position).norm()};
  const project::Node* table = variant.document.find("elements");
  const project::Node* written = table ? table->find(given.name) : nullptr;
  if (written) std::visit(Dimensions{shown}, project::element_shape(*written));
  return shown;
}

json::Json mesh_json(const SolidSurface& surface, double size) {
  constexpr std::size_t most = 20000;
  constexpr double digits = 7;
  const std::size_t given = count_of_triangles(surface);
  const SolidSurface fewer = given > most ? coarsened(surface, most) : surface;
  const double step = std::pow(10.0, digits - std::ceil(std::log10(size)));
  std::vector<double> vertices;
  for (const Eigen::Vector3d& v : fewer.vertices)
    for (const double x : v) vertices.push_back(std::round(x * step) / step);
  std::vector<int> triangles;
  for (const std::vector<int>& face : fewer.faces)
    for (std::size_t i = 2; i < face.size(); ++i) triangles.insert(triangles.end(), {face[0], face[i - 1], face[i]});
  json::Json result{{"vertices", json::list(vertices)}, {"triangles", json::integer_list(triangles)}};
  if (given > most) result["triangles_given"] = given;
  return result;
}

}  // namespace trivet::results
