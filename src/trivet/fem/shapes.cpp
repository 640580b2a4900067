// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/fem/element_kernel.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/part_size.h"

namespace trivet::fem {
namespace {

/// Smallest element at a bonded rim / smallest dimension of the rubber there, at level 1. With 1/level² the error at
/// the singular edge decreases at least as fast as the error inside.
constexpr double rim_fraction = 0.3;

/// Limit for one shape: about a million unknowns, minutes of computing time and a few gigabytes.
constexpr double most_hexahedra = 40'000;

double rim_size(int level) { return rim_fraction / (level * level); }

void require_positive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw foundation::InvalidInput(fmt::format("{} = {} m; it must be > 0", name, value));
  if (!foundation::is_part_size(value))
    throw foundation::InvalidInput(fmt::format("{} = {:.6g} m; {}", name, value, foundation::part_size_rule));
}

double thinnest_rubber(const std::vector<Layer>& layers) {
  double thinnest = 1e300;
  for (const Layer& layer : layers) {
    require_positive("thickness", layer.thickness);
    if (!layer.metal) thinnest = std::min(thinnest, layer.thickness);
  }
  if (thinnest == 1e300) throw foundation::InvalidInput("layers: no rubber layer; a mount needs at least one");
  return thinnest;
}

/// Checks the number of elements before the mesh is made.
void require_enough_memory(double quads, double intervals) {
  if (quads * intervals > most_hexahedra)
    throw foundation::InvalidInput(
        fmt::format("{:.3g} finite elements ({} over the section, {} over the height); at most {:.0f} are allowed: "
                    "lower mesh_level, use fewer layers, or use the closed formulas",
                    quads * intervals, quads, intervals, most_hexahedra));
}

/// Number of elements from the middle to a free edge at `distance`: more for thin rubber, so that sizes grow by a
/// factor of at most about 2.
int toward_edge(int level, double distance, double thickness) {
  return level + static_cast<int>(std::ceil(0.5 * level * std::log2(std::max(1.0, 0.5 * distance / thickness))));
}

/// In rubber this thin relative to its half width the pressure dominates: a parabola across the width, constant over
/// the thickness. The elements are placed across the width; one or two quadratic elements over half the thickness
/// represent the parabola of the flow.
bool is_thin(double half_width, double thickness) { return half_width > 4 * thickness; }

struct Levels {
  std::vector<double> z;      ///< ends of the elements [m]
  std::vector<int> material;  ///< per interval
};

Levels along_axis(const std::vector<Layer>& layers, int level, double half_width) {
  Levels levels{{0.0}, {}};
  for (const Layer& layer : layers) {
    const double start = levels.z.back(),
                 smallest = rim_size(level) * std::min(layer.thickness, half_width) / layer.thickness;
    const auto places = layer.metal
        ? std::vector<double>{0, 1}
        : graded_to_both(2 * (is_thin(half_width, layer.thickness) ? (level + 1) / 2 : level), smallest);
    for (std::size_t i = 1; i < places.size(); ++i) {
      levels.z.push_back(start + places[i] * layer.thickness);
      levels.material.push_back(layer.material);
    }
  }
  return levels;
}

Mesh extruded(const Section& section, const Levels& levels) {
  const int points = static_cast<int>(section.points.cols()), count = static_cast<int>(levels.material.size());
  require_enough_memory(static_cast<double>(section.quads.size()), count);
  Mesh mesh;
  mesh.nodes.resize(3, to_index(points) * (2 * count + 1));
  for (int l = 0; l <= 2 * count; ++l) {
    const auto below = to_size(l / 2);
    const double z = l % 2 == 0 ? levels.z[below] : 0.5 * (levels.z[below] + levels.z[below + 1]);
    for (int p = 0; p < points; ++p) mesh.nodes.col(p + points * l) << section.points.col(p), z;
  }
  mesh.elements.resize(27, count * to_index(section.quads.size()));
  Eigen::Index e = 0;
  for (int layer = 0; layer < count; ++layer)
    for (const auto& quad : section.quads) {
      for (std::size_t a = 0; a < 27; ++a) {
        const auto [i, j, k] = Hex27::lattice()[a];
        mesh.elements(to_index(a), e) = quad[i + 3 * j] + points * (2 * layer + k);
      }
      mesh.material.push_back(levels.material[layer]);
      ++e;
    }
  return mesh;
}

void bond_ends(Mesh& mesh, const Section& section) {
  const int points = static_cast<int>(section.points.cols()), top = static_cast<int>(mesh.nodes.cols()) - points;
  for (int p = 0; p < points; ++p) {
    mesh.plate_n.push_back(p);
    mesh.plate_k.push_back(top + p);
  }
}

Mesh mesh_of(const Disc& shape, int level) {
  require_positive("diameter", shape.diameter);
  const double radius = shape.diameter / 2, thin = thinnest_rubber(shape.layers);
  const int count = toward_edge(level, radius, thin);
  const Section section = disc(radius, is_thin(radius, thin) ? 2 * level : level,
                               graded_to_one(count, 2 * rim_size(level) * std::min(thin / radius, 1.0)));
  Mesh result = extruded(section, along_axis(shape.layers, level, radius));
  bond_ends(result, section);
  return result;
}

std::vector<double> across(double width, double thin, int level) {
  const int count = toward_edge(level, width / 2, thin);
  std::vector<double> places = graded_to_both(2 * count, rim_size(level) * std::min(thin / width, 0.5));
  for (double& x : places) x = (x - 0.5) * width;
  return places;
}

Mesh mesh_of(const Block& shape, int level) {
  require_positive("width", shape.width);
  require_positive("depth", shape.depth);
  const double thin = thinnest_rubber(shape.layers);
  const Section section = rectangle(across(shape.width, thin, level), across(shape.depth, thin, level));
  Mesh result = extruded(section, along_axis(shape.layers, level, std::min(shape.width, shape.depth) / 2));
  bond_ends(result, section);
  return result;
}

Mesh mesh_of(const Bush& shape, int level) {
  require_positive("inner_diameter", shape.inner_diameter);
  require_positive("outer_diameter", shape.outer_diameter);
  require_positive("length", shape.length);
  if (!(shape.inner_diameter < shape.outer_diameter))
    throw foundation::InvalidInput(
        fmt::format("inner_diameter = {} m, outer_diameter = {} m; the inner must be the smaller", shape.inner_diameter,
                    shape.outer_diameter));
  const double wall = (shape.outer_diameter - shape.inner_diameter) / 2;
  const Section section = ring(shape.inner_diameter / 2, shape.outer_diameter / 2, 4 + 2 * level,
                               graded_to_both(2 * level, rim_size(level)));
  Levels levels{across(shape.length, wall, level), {}};
  levels.material.assign(levels.z.size() - 1, shape.material);
  Mesh result = extruded(section, levels);
  const int points = static_cast<int>(section.points.cols());
  for (int first = 0; first < static_cast<int>(result.nodes.cols()); first += points) {
    for (const int p : section.inner) result.plate_n.push_back(first + p);
    for (const int p : section.outer) result.plate_k.push_back(first + p);
  }
  return result;
}

double total_thickness(const std::vector<Layer>& layers) {
  double sum = 0;
  for (const Layer& layer : layers) sum += layer.thickness;
  return sum;
}

}  // namespace

std::vector<Layer> sandwich_layers(int rubber_count, double rubber_thickness, double metal_thickness) {
  if (rubber_count < 1)
    throw foundation::InvalidInput(fmt::format("{} rubber layers; a sandwich needs at least one", rubber_count));
  std::vector<Layer> layers{{.thickness = rubber_thickness, .material = 0}};
  for (int i = 1; i < rubber_count; ++i) {
    layers.push_back({.thickness = metal_thickness, .material = 1, .metal = true});
    layers.push_back({.thickness = rubber_thickness, .material = 0});
  }
  return layers;
}

Mesh mesh(const Shape& shape, int level) {
  if (level < 1) throw foundation::InvalidInput(fmt::format("mesh level {}; it must be ≥ 1", level));
  return std::visit([&](const auto& s) { return mesh_of(s, level); }, shape);
}

ElementFrame frame(const Shape& shape) {
  ElementFrame result;
  if (const auto* disc = std::get_if<Disc>(&shape)) result.point_k.z() = total_thickness(disc->layers);
  if (const auto* block = std::get_if<Block>(&shape)) result.point_k.z() = total_thickness(block->layers);
  return result;
}

SolidStiffness condense(const Shape& shape, const std::vector<Material>& materials, int level,
                        const CondensationOptions& options, const foundation::Progress& progress) {
  const Mesh fine = mesh(shape, level);
  if (level == 1) return condense(fine, materials, frame(shape), options, progress);
  return condense(fine, mesh(shape, level - 1), static_cast<double>(level) / (level - 1), materials, frame(shape),
                  options, progress);
}

}  // namespace trivet::fem
