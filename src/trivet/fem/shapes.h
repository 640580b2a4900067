// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <variant>
#include <vector>

#include "trivet/fem/condensation.h"
#include "trivet/fem/mesh.h"

namespace trivet::fem {

/// Plane mesh of nine-node quadrilaterals, their lattice 3×3 row by row, counter-clockwise.
struct Section {
  Eigen::Matrix2Xd points;  ///< [m]
  std::vector<std::array<int, 9>> quads;
  std::vector<int> inner, outer;  ///< nodes of the inner and outer circle of a ring
};

/// Ends, from 0 to 1, of `count` intervals that get shorter as tanh towards 1, down to the length `smallest`; equal
/// intervals if `smallest` is longer than these.
[[nodiscard]] std::vector<double> graded_to_one(int count, double smallest);
/// The same towards both ends; `count` is even.
[[nodiscard]] std::vector<double> graded_to_both(int count, double smallest);

/// Grid between the given lines, x and y [m].
[[nodiscard]] Section rectangle(const std::vector<double>& x, const std::vector<double>& y);
/// Bulged square of core × core quadrilaterals, of about 0.55 of the radius, and 4 · core columns around it; `to_rim`:
/// divisions from core (0) to rim (1).
[[nodiscard]] Section disc(double radius, int core, const std::vector<double>& to_rim);
/// `around` columns between two circles; `to_outside`: divisions from the inner (0) to the outer (1).
[[nodiscard]] Section ring(double inner_radius, double outer_radius, int around, const std::vector<double>& to_outside);

/// One layer of a stack along e3, bonded to its neighbours. A metal layer gets one element over its thickness, a rubber
/// layer a graded mesh.
struct Layer {
  double thickness = 0;  ///< [m] > 0
  int material = 0;      ///< index into the list of materials
  bool metal = false;
};

/// Cylinder about e3 from plate N at z = 0 to plate K at the total thickness of its layers: one layer is a disc,
/// several a sandwich.
struct Disc {
  double diameter = 0;  ///< [m] > 0
  std::vector<Layer> layers;
};
/// Block with sides along e1 and e2, centred on e3, plates as for a disc.
struct Block {
  double width = 0, depth = 0;  ///< along e1 and e2 [m] > 0
  std::vector<Layer> layers;
};
/// Sleeve about e3, its middle at the origin: bonded to the rigid inner tube N and the rigid outer tube K.
struct Bush {
  double inner_diameter = 0, outer_diameter = 0, length = 0;  ///< [m], 0 < inner < outer
  int material = 0;
};
using Shape = std::variant<Disc, Block, Bush>;

/// Rubber layers of equal thickness (material 0) with metal plates between them (material 1).
[[nodiscard]] std::vector<Layer> sandwich_layers(int rubber_count, double rubber_thickness, double metal_thickness);

/// Graded mesh of hexahedra; the number of elements grows about as level³. `level` ≥ 1; level 3 reproduces the bonded
/// cylinder within 0.1 %.
/// @throws InvalidInput for dimensions that are not > 0 or an inner diameter that is not below the outer
[[nodiscard]] Mesh mesh(const Shape& shape, int level);

/// Ends of the element: plate centres of disc and block, the middle of the bush for both ends.
[[nodiscard]] ElementFrame frame(const Shape& shape);

inline constexpr int default_level = 3;

/// Stiffness of a shape on a mesh of this level, the error is estimated from the next coarser one.
[[nodiscard]] SolidStiffness condense(const Shape& shape, const std::vector<Material>& materials,
                                      int level = default_level, const CondensationOptions& options = {},
                                      const foundation::Progress& progress = {});

}  // namespace trivet::fem
