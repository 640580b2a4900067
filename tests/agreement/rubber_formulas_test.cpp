// SPDX-License-Identifier: BSD-3-Clause
// Closed formulas of bonded rubber against the finite elements of this library, over the range of validity of the
// formulas.
#include <gmock/gmock.h>

#include <cmath>

#include "trivet/elements/rubber_layer.h"
#include "trivet/elements/rubber_mounts.h"
#include "trivet/fem/shapes.h"

namespace rubber_formulas_test {

using namespace trivet;

/// Accuracy of the default formulas as docs/elements/rubber.md states it; the mesh adds half a per cent.
struct Promise {
  double axial, shear, tilt, torsion;
};
constexpr double mesh = 0.005;
constexpr int mesh_level = 2;

double apart(double formula, double elements) { return std::abs(formula / elements - 1); }

/// Tilting stiffness of plate K against N about the middle of the layer, without the part of shear.
double bending(const elements::Matrix12& k, int axis, double thickness) {
  const int shear = axis == 0 ? 7 : 6;
  return k(9 + axis, 9 + axis) - k(shear, shear) * thickness * thickness / 4;
}

void compare(const elements::Matrix12& formula, const elements::Matrix12& elements, double thickness,
             const Promise& promise, const std::string& what) {
  EXPECT_LE(apart(formula(8, 8), elements(8, 8)), promise.axial + mesh) << what << " axial";
  EXPECT_LE(apart(formula(6, 6), elements(6, 6)), promise.shear + mesh) << what << " shear along e1";
  EXPECT_LE(apart(formula(7, 7), elements(7, 7)), promise.shear + mesh) << what << " shear along e2";
  EXPECT_LE(apart(bending(formula, 0, thickness), bending(elements, 0, thickness)), promise.tilt + mesh)
      << what << " tilt about e1";
  EXPECT_LE(apart(bending(formula, 1, thickness), bending(elements, 1, thickness)), promise.tilt + mesh)
      << what << " tilt about e2";
  EXPECT_LE(apart(formula(11, 11), elements(11, 11)), promise.torsion + mesh) << what << " torsion";
}

TEST(RubberFormulas, DiscsAgreeWithFiniteElements) {
  const elements::Rubber rubber{1e6, 2e9};
  for (const double shape_factor : {0.25, 0.5, 1.25, 2.5, 5.0, 10.0, 20.0}) {
    elements::RubberDisc disc;
    disc.rubber = rubber;
    disc.radius = 0.025;
    disc.thickness = disc.radius / (2 * shape_factor);
    const auto solid = fem::condense(fem::Disc{2 * disc.radius, {{disc.thickness, 0, false}}},
                                     {fem::neo_hookean(1e6, 2e9)}, mesh_level);
    compare(elements::rubber_disc(disc), solid.stiffness, disc.thickness,
            {.axial = 0.005, .shear = 0.005, .tilt = 0.012, .torsion = 0.001}, "S = " + std::to_string(shape_factor));
  }
}

TEST(RubberFormulas, BlocksAgreeWithFiniteElements) {
  for (const double ratio : {1.0, 2.0, 4.0})
    for (const double thickness : {0.012, 0.03, 0.06}) {
      elements::RubberBlock block;
      block.rubber = {1e6, 2e9};
      block.width_1 = 0.06;
      block.width_2 = 0.06 * ratio;
      block.thickness = thickness;
      const auto solid = fem::condense(fem::Block{block.width_1, block.width_2, {{thickness, 0, false}}},
                                       {fem::neo_hookean(1e6, 2e9)}, mesh_level);
      compare(elements::rubber_block(block), solid.stiffness, thickness,
              {.axial = 0.016, .shear = 0.039, .tilt = 0.046, .torsion = 0.048},
              "1 : " + std::to_string(ratio) + ", " + std::to_string(thickness) + " m");
    }
}

TEST(RubberFormulas, BushesAgreeWithFiniteElements) {
  constexpr Promise promise{.axial = 0.032, .shear = 0.043, .tilt = 0.072, .torsion = 0.001};
  for (const double outer : {1.3, 2.0, 3.0})
    for (const double length : {1.0, 2.0, 5.0}) {
      elements::RubberBush bush;
      bush.rubber = {1e6, 2e9};
      bush.inner_radius = 0.015;
      bush.outer_radius = 0.015 * outer;
      bush.length = length * (bush.outer_radius - bush.inner_radius);
      const auto solid = fem::condense(fem::Bush{2 * bush.inner_radius, 2 * bush.outer_radius, bush.length, 0},
                                       {fem::neo_hookean(1e6, 2e9)}, mesh_level);
      const elements::Matrix12 formula = elements::rubber_bush(bush);
      const std::string what = "ro/ri = " + std::to_string(outer) + ", L/t = " + std::to_string(length);
      EXPECT_LE(apart(formula(8, 8), solid.stiffness(8, 8)), promise.axial + mesh) << what << " axial";
      EXPECT_LE(apart(formula(6, 6), solid.stiffness(6, 6)), promise.shear + mesh) << what << " radial";
      EXPECT_LE(apart(formula(9, 9), solid.stiffness(9, 9)), promise.tilt + mesh) << what << " tilt";
      EXPECT_LE(apart(formula(11, 11), solid.stiffness(11, 11)), promise.torsion + mesh) << what << " torsion";
    }
}

}  // namespace rubber_formulas_test
