// SPDX-License-Identifier: BSD-3-Clause
// Rigid solids by two methods: triangles against closed forms, with the order of their error; STEP files against
// triangles of them.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/matchers.h"
#include "support/step_shapes.h"
#include "support/stl_shapes.h"
#include "trivet/foundation/child_process.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/rigid_solid.h"

namespace rigid_solids_test {

using namespace trivet;
using namespace trivet::solids;
using std::numbers::pi;

constexpr double mm = 1e-3;

spatial::MassProperties properties(const Part& part) {
  const auto solid = rigid_solid({part});
  if (!solid) throw std::runtime_error(message(solid.error().list().front()));
  return solid->properties;
}

spatial::MassProperties of_triangles(const test::Triangles& triangles) {
  const foundation::TemporaryFolder folder;
  test::write_file(folder.path() / "part.stl", test::stl_text(triangles));
  return properties({"part", StlSolid{folder.path() / "part.stl", mm}, 1000});
}

/// Triangles of a torus about z, ring radius 30, section radius 10; equal angles give equal numbers.
test::Triangles torus(int around, int section) {
  return test::grid_surface(around, section, [=](int i, int j) {
    const double u = 2 * pi * (i % around) / around, v = 2 * pi * (j % section) / section;
    return Eigen::Vector3d((30 + 10 * std::cos(v)) * std::cos(u), (30 + 10 * std::cos(v)) * std::sin(u),
                           10 * std::sin(v));
  });
}

/// Triangles of a sphere of radius 20; those at the poles are degenerate.
test::Triangles sphere(int around) {
  return test::grid_surface(around, around / 2, [=](int i, int j) {
    const double u = 2 * pi * (i % around) / around, v = pi * j / (around / 2);
    const bool pole = j == 0 || j == around / 2;
    return pole ? Eigen::Vector3d(0, 0, j == 0 ? -20 : 20)
                : Eigen::Vector3d(20 * std::sin(v) * std::cos(u), 20 * std::sin(v) * std::sin(u), -20 * std::cos(v));
  });
}

TEST(StlSolid, TorusConvergesAtSecondOrder) {
  constexpr double higher_orders = 0.05, extrapolation = 1e-4;  // what second order leaves
  const double volume = 2 * pi * pi * 30 * 100 * 1e-9 * 1000;
  const double coarse = 1 - of_triangles(torus(60, 30)).mass / volume,
               fine = 1 - of_triangles(torus(120, 60)).mass / volume;
  EXPECT_GT(fine, 0) << "chords lie inside";
  EXPECT_NEAR(coarse / fine, 4, higher_orders);
  const double extrapolated = of_triangles(torus(120, 60)).mass * (1 + fine);  // to first order
  EXPECT_THAT(extrapolated, test::RelativelyNear(volume, extrapolation));
}

TEST(StlSolid, FineSphereAgreesWithTheSphere) {
  const spatial::MassProperties exact = properties({"ball", Sphere{40 * mm}, 1000}),
                                triangles = of_triangles(sphere(200));
  constexpr double faceted = 1e-3;            // volume 1 − (2π/200)²·0.5
  constexpr double of_moments = 2 * faceted;  // they grow with the fifth power of the radius, the volume with the third
  constexpr double round_off = 1e-15;         // m: opposite triangles cancel
  EXPECT_THAT(triangles.mass, test::RelativelyNear(exact.mass, faceted));
  EXPECT_LE(triangles.centre.norm(), round_off);
  EXPECT_LE((triangles.inertia_about_centre - exact.inertia_about_centre).norm(),
            of_moments * exact.inertia_about_centre.norm());
}

TEST(StepSolid, AgreesWithTheTrianglesThatGmshMakesOfIt) {
  const foundation::TemporaryFolder folder;
  const std::string bracket = R"(
    Box(1) = {0, 0, 0, 80, 40, 10}; Cylinder(2) = {60, 20, -1, 0, 0, 12, 9}; Box(3) = {0, 0, 0, 10, 40, 50};
    BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{3}; Delete; };
    BooleanDifference(5) = { Volume{4}; Delete; }{ Volume{2}; Delete; };)";
  test::write_step(folder.path() / "bracket.step", bracket);
  test::write_file(
      folder.path() / "mesh.geo",
      "SetFactory(\"OpenCASCADE\"); Geometry.OCCTargetUnit = \"MM\"; Merge \"bracket.step\"; Mesh.MeshSizeMax = 6; "
      "Mesh.MeshSizeFromCurvature = 200; Mesh.Binary = 1; Mesh 2; Save \"bracket.stl\";\n");
  const auto gmsh = foundation::program_on_path("gmsh");
  ASSERT_TRUE(gmsh);
  ASSERT_TRUE(foundation::run({.program = *gmsh, .arguments = {"mesh.geo", "-"}, .folder = folder.path()}).succeeded());
  const spatial::MassProperties exact = properties({"step", StepSolid{folder.path() / "bracket.step"}, 7850});
  const spatial::MassProperties triangles = properties({"stl", StlSolid{folder.path() / "bracket.stl", mm}, 7850});
  constexpr double faceted = 2e-5;  // a bore of 200 chords: (2π/200)²/6 of its 8 % of the volume
  EXPECT_THAT(triangles.mass, test::RelativelyNear(exact.mass, faceted));
  const double length = 0.08;  // m, of the bracket
  EXPECT_LE((triangles.centre - exact.centre).norm(), faceted * length);
  EXPECT_LE((triangles.inertia_about_centre - exact.inertia_about_centre).norm(),
            faceted * exact.inertia_about_centre.norm());
  EXPECT_GT(std::abs(exact.inertia_about_centre(0, 2)), 0.1 * exact.inertia_about_centre(1, 1))
      << "skew enough to test products of inertia";
}

}  // namespace rigid_solids_test
