// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/stl_shapes.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/closed_surface.h"
#include "trivet/solids/rigid_solid.h"
#include "trivet/spatial/rigid_motion.h"

namespace solids_test {

using namespace trivet;
using namespace trivet::solids;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double mm = 1e-3;
constexpr double round_off = 1e-13;  // some hundred operations on numbers of equal size

/// Messages of all problems of an outcome, one per line; empty without problems.
template <typename T>
std::string messages(const foundation::Expected<T>& outcome) {
  std::string text;
  if (!outcome)
    for (const foundation::Problem& problem : outcome.error().list()) text += message(problem) + "\n";
  return text;
}

foundation::Expected<RigidSolid> stl_solid(const test::Triangles& triangles) {
  const foundation::TemporaryFolder folder;
  test::write_file(folder.path() / "part.stl", test::stl_text(triangles));
  return rigid_solid({{"part", StlSolid{folder.path() / "part.stl", mm}, 1000}});
}

// ---- placing and adding

/// Mass, centre and inertia of two results.
void expect_equal(const spatial::MassProperties& a, const spatial::MassProperties& b) {
  constexpr double round_off = 1e-13;
  EXPECT_NEAR(a.mass, b.mass, round_off * b.mass);
  EXPECT_TRUE(a.centre.isApprox(b.centre, round_off)) << a.centre.transpose() << " and " << b.centre.transpose();
  EXPECT_TRUE(a.inertia_about_centre.isApprox(b.inertia_about_centre, round_off));
}

TEST(RigidSolid, AMassInsteadOfADensity) {
  const Part by_density{"box", Box{0.3, 0.2, 0.1}, 2700};
  Part by_mass{"box", Box{0.3, 0.2, 0.1}};
  by_mass.mass = 2700 * 0.3 * 0.2 * 0.1;
  expect_equal(rigid_solid({by_mass})->properties, rigid_solid({by_density})->properties);
}

TEST(RigidSolid, PartsWithoutAShapeAddTheirSteinerTerms) {
  const spatial::MassProperties lump{3, {0.2, 0, 0.4}, Eigen::Vector3d(0.1, 0.15, 0.2).asDiagonal()};
  Part box{"box", Box{0.3, 0.2, 0.1}};
  box.mass = 6;
  const spatial::MassProperties all = rigid_solid({box}, {.lumps = {lump}})->properties;
  const Eigen::Vector3d d = lump.centre;  // from the centre of the box; reduced mass 3·6/9 = 2 kg
  const Eigen::Matrix3d own =
      Eigen::Vector3d(6 * (0.04 + 0.01) / 12, 6 * (0.09 + 0.01) / 12, 6 * (0.09 + 0.04) / 12).asDiagonal();
  expect_equal(
      all,
      {9, d / 3,
       own + lump.inertia_about_centre + 2 * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose())});
}

TEST(RigidSolid, TheMassOfTheWholeIsSharedByTheRest) {
  const Part steel{"steel", Box{0.1, 0.1, 0.1}, 7800},
      light{"light", Box{0.1, 0.1, 0.2}, 2600, {{0.4, 0, 0}, Eigen::Matrix3d::Identity()}};
  const spatial::MassProperties lump{4, {0, 0, 0.3}, Eigen::Matrix3d::Zero()};
  // 7.8 kg and 5.2 kg by their densities; 26 kg are left of 30 kg: twice as much
  Part heavy = steel, heavier = light;
  heavy.density *= 2;
  heavier.density *= 2;
  expect_equal(rigid_solid({steel, light}, {.whole = 30, .lumps = {lump}})->properties,
               rigid_solid({heavy, heavier}, {.lumps = {lump}})->properties);
  // without densities by volume: one and two thirds
  const Part first{"first", steel.shape}, second{"second", light.shape, not_given, light.pose};
  const auto shared = rigid_solid({first, second}, {.whole = 30});
  EXPECT_NEAR(shared->parts[0].properties.mass, 10, 1e-13);
  EXPECT_NEAR(shared->parts[1].properties.mass, 20, 1e-13);
  EXPECT_THAT(messages(rigid_solid({steel, first}, {.whole = 30})), HasSubstr("of which 1 have a density"));
  EXPECT_THAT(messages(rigid_solid({steel}, {.whole = 3, .lumps = {lump}})), HasSubstr("have 4 kg"));
}

TEST(RigidSolid, ABoxInPiecesIsTheBox) {
  const Part whole{"whole", Box{0.3, 0.2, 0.1}, 2700, {{0.15, 0, 0}, Eigen::Matrix3d::Identity()}};
  const Part left{"left", Box{0.1, 0.2, 0.1}, 2700, {{0.05, 0, 0}, Eigen::Matrix3d::Identity()}};
  const Part right{"right", Box{0.2, 0.2, 0.1}, 2700, {{0.2, 0, 0}, Eigen::Matrix3d::Identity()}};
  const auto one = rigid_solid({whole}), two = rigid_solid({left, right});
  ASSERT_TRUE(one && two);
  EXPECT_THAT(two->properties.mass, test::RelativelyNear(one->properties.mass, round_off));
  EXPECT_THAT(two->properties.centre, test::NearVector(one->properties.centre, round_off));
  EXPECT_LE((two->properties.inertia_about_centre - one->properties.inertia_about_centre).norm(), round_off);
  EXPECT_THAT(two->parts, SizeIs(2));
  EXPECT_EQ(two->parts[1].name, "right");
}

TEST(RigidSolid, DensitiesWeighTheCentre) {
  const auto solid = rigid_solid({{"steel", Box{0.1, 0.1, 0.1}, 7800},
                                  {"light", Box{0.1, 0.1, 0.1}, 2600, {{0.4, 0, 0}, Eigen::Matrix3d::Identity()}}});
  ASSERT_TRUE(solid);
  EXPECT_THAT(solid->properties.mass, test::RelativelyNear(10.4, round_off));
  EXPECT_THAT(solid->properties.centre, test::NearVector(Eigen::Vector3d(0.1, 0, 0), round_off));
}

TEST(RigidSolid, ATurnedPartTurnsItsInertia) {
  const Eigen::Matrix3d turn = spatial::rotation_about({1, 2, -0.5}, 0.8);
  const Part straight{"part", Box{0.3, 0.2, 0.1}, 1000}, skew{"part", Box{0.3, 0.2, 0.1}, 1000, {{1, -2, 0.5}, turn}};
  const auto one = rigid_solid({straight}), two = rigid_solid({skew});
  ASSERT_TRUE(one && two);
  const Eigen::Matrix3d expected = turn * one->properties.inertia_about_centre * turn.transpose();
  EXPECT_LE((two->properties.inertia_about_centre - expected).norm(), round_off * expected.norm());
  EXPECT_THAT(two->properties.centre, test::NearVector(Eigen::Vector3d(1, -2, 0.5), round_off));
}

// ---- bad parts

TEST(RigidSolid, ReportsEveryProblemOfEveryPartAtOnce) {
  const auto solid = rigid_solid(
      {{"plate", Box{0.3, 0.2, -0.01}, -7850}, {"pipe", Tube{0.05, 0.06, 1}, 7850}, {"ball", Sphere{}, 1000}});
  ASSERT_FALSE(solid);
  EXPECT_THAT(messages(solid),
              AllOf(HasSubstr("plate.density: -7850 kg/m³"), HasSubstr("plate.length_z: -0.01 m"),
                    HasSubstr("pipe.inner_diameter: 0.06 m, outer_diameter = 0.05 m: wall -0.005 m"),
                    HasSubstr("ball.diameter: not given")));
}

TEST(RigidSolid, RejectsPartsWithoutVolume) {
  EXPECT_THAT(messages(rigid_solid({{"cone", Cone{0, 0, 0.1}, 1000}})), HasSubstr("both diameters are 0 m"));
  EXPECT_THAT(messages(rigid_solid({{"tube", Tube{0.1, 0.1, 0.1}, 1000}})), HasSubstr("wall 0 m"));
  EXPECT_THAT(messages(rigid_solid({{"grain", Sphere{1e-120}, 1000}})), HasSubstr("between 1 nm and 10 km"));
  EXPECT_THAT(messages(rigid_solid({{"box", Box{INFINITY, 1, 1}, 1000}})), HasSubstr("length_x: inf m"));
  EXPECT_THAT(messages(rigid_solid({})), HasSubstr("at least one part"));
}

TEST(RigidSolid, RejectsAnInvalidPose) {
  Part part{"box", Box{1, 1, 1}, 1000};
  part.pose.rotation(0, 0) = -1;
  EXPECT_THAT(messages(rigid_solid({part})), HasSubstr("box.orientation: is not a rotation"));
  part.pose = {{NAN, 0, 0}, Eigen::Matrix3d::Identity()};
  EXPECT_THAT(messages(rigid_solid({part})), HasSubstr("position"));
}

TEST(Primitives, AreRejectedIfACallerSkipsTheirCheck) {
  EXPECT_THROW((void)integrals(Cylinder{0.1, -1}), foundation::InvalidInput);
}

// ---- surfaces of triangles

TEST(ClosedSurface, TextAndBinaryFilesOfABoxAreExact) {
  const foundation::TemporaryFolder folder;
  const test::Triangles box = test::box_triangles({1, 2, 3}, {5, 5, 5});
  test::write_file(folder.path() / "text.stl", test::stl_text(box));
  test::write_file(folder.path() / "binary.stl", test::stl_binary(box));
  for (const char* name : {"text.stl", "binary.stl"}) {
    const auto solid = rigid_solid({{"box", StlSolid{folder.path() / name, mm}, 7800}});
    ASSERT_TRUE(solid) << messages(solid);
    EXPECT_THAT(solid->properties.mass, test::RelativelyNear(7800 * 24e-9, round_off));
    EXPECT_THAT(solid->properties.centre, test::NearVector(Eigen::Vector3d(3, 3.5, 4) * mm, round_off));
    const Eigen::Matrix3d exact = 7800 * 24e-9 / 12 * Eigen::Vector3d(9 + 4, 16 + 4, 16 + 9).asDiagonal() * mm * mm;
    EXPECT_LE((solid->properties.inertia_about_centre - exact).norm(), round_off * exact.norm());
  }
}

TEST(ClosedSurface, AHoleIsReportedWithItsPlaceAndItsOpenEdges) {
  test::Triangles box = test::box_triangles({0, 0, 0}, {10, 20, 30});
  box.erase(box.begin() + 2, box.begin() + 4);  // the lid at z = 30
  EXPECT_THAT(messages(stl_solid(box)),
              AllOf(HasSubstr("part.file"),
                    HasSubstr("hole 1 of 1: 4 open edges around (5, 10, 30), from (0, 0, 30) to (10, 20, 30)")));
}

TEST(ClosedSurface, TwoHolesAreTwoFindings) {
  test::Triangles boxes =
      test::together(test::box_triangles({0, 0, 0}, {1, 1, 1}), test::box_triangles({5, 0, 0}, {6, 1, 1}));
  boxes.erase(boxes.begin() + 12);
  boxes.erase(boxes.begin());
  EXPECT_THAT(
      messages(stl_solid(boxes)),
      AllOf(HasSubstr("hole 1 of 2: 3 open edges"), HasSubstr("hole 2 of 2: 3 open edges"), HasSubstr("(6, 1, 0)")));
}

TEST(ClosedSurface, ATurnedTriangleIsNotAHole) {
  test::Triangles box = test::box_triangles({0, 0, 0}, {1, 1, 1});
  std::swap(box[0][1], box[0][2]);
  EXPECT_THAT(
      messages(stl_solid(box)),
      AllOf(HasSubstr("3 edges between triangles that face opposite sides"), ::testing::Not(HasSubstr("hole"))));
}

TEST(ClosedSurface, AnInvertedSurfaceIsRejected) {
  EXPECT_THAT(messages(stl_solid(test::turned(test::box_triangles({0, 0, 0}, {1, 1, 1})))),
              HasSubstr("faces inwards: volume -1"));
  const auto beside = test::together(test::box_triangles({0, 0, 0}, {4, 4, 4}),
                                     test::turned(test::box_triangles({9, 0, 0}, {10, 1, 1})));
  EXPECT_THAT(messages(stl_solid(beside)), HasSubstr("from (9, 0, 0) to (10, 1, 1) in the file's units faces inwards"));
}

TEST(ClosedSurface, ACavityReducesTheVolume) {
  const auto hollow = test::together(test::box_triangles({0, 0, 0}, {4, 4, 4}),
                                     test::turned(test::box_triangles({1, 1, 1}, {2, 2, 2})));
  const auto solid = stl_solid(hollow);
  ASSERT_TRUE(solid) << messages(solid);
  EXPECT_THAT(solid->parts[0].volume, test::RelativelyNear(63e-9, round_off));
  EXPECT_THAT(solid->properties.centre,
              test::NearVector(Eigen::Vector3d::Constant((64 * 2 - 1.5) / 63 * mm), round_off));
}

TEST(ClosedSurface, AFlatSurfaceHasNoVolume) {
  EXPECT_THAT(messages(stl_solid(test::box_triangles({0, 0, 0}, {1, 1, 0}))),
              AllOf(HasSubstr("part.file"), HasSubstr("volume")));
}

TEST(ClosedSurface, DegenerateTrianglesGiveARemarkOnly) {
  test::Triangles box = test::box_triangles({0, 0, 0}, {1, 1, 1});
  box.push_back({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0)});
  const auto solid = stl_solid(box);
  ASSERT_TRUE(solid) << messages(solid);
  EXPECT_THAT(solid->parts[0].volume, test::RelativelyNear(1e-9, round_off));
  ASSERT_THAT(solid->remarks.list(), SizeIs(1));
  EXPECT_THAT(message(solid->remarks.list()[0]), HasSubstr("1 degenerate triangles"));
}

TEST(ClosedSurface, BoxesThatTouchInAnEdgeGiveARemarkAndAddUp) {
  const auto solid =
      stl_solid(test::together(test::box_triangles({0, 0, 0}, {1, 1, 1}), test::box_triangles({1, 1, 0}, {2, 2, 1})));
  ASSERT_TRUE(solid) << messages(solid);
  EXPECT_THAT(solid->parts[0].volume, test::RelativelyNear(2e-9, round_off));
  EXPECT_THAT(solid->remarks.list(), SizeIs(1));
}

// ---- rounding and repeated triangles

/// A box whose vertices at x = 0 are at −`noise` in every second triangle.
test::Triangles noisy_box(double noise, const Eigen::Vector3d& low = {0, 0, 0},
                          const Eigen::Vector3d& high = {10, 10, 20}) {
  test::Triangles box = test::box_triangles(low, high);
  for (std::size_t i = 0; i < box.size(); i += 2)
    for (Eigen::Vector3d& corner : box[i])
      if (corner.x() == low.x()) corner.x() -= noise;
  return box;
}

TEST(WeldedSurface, CoordinatesThatDifferByRoundingAreEqual) {
  for (const double noise : {3.06162e-17, 1e-7, 1e-4}) {  // 1e-4: the sixth digit of 20
    const auto solid = stl_solid(noisy_box(noise));
    ASSERT_TRUE(solid) << noise << messages(solid);
    EXPECT_THAT(solid->parts[0].volume, test::RelativelyNear(2000e-9, std::max(round_off, noise)));
    ASSERT_THAT(solid->remarks.list(), SizeIs(1)) << noise;
    EXPECT_THAT(message(solid->remarks.list()[0]), HasSubstr("vertices differ by rounding from another"));
  }
}

TEST(WeldedSurface, TheLastOfFixedDecimalsIsRounding) {
  const foundation::TemporaryFolder folder;
  const auto outcome = [&](double noise, int decimals) {
    std::string text = "solid\n";
    for (const test::Triangle& triangle : noisy_box(noise)) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const Eigen::Vector3d& p : triangle)
        text += fmt::format("vertex {:.{}f} {:.{}f} {:.{}f}\n", p.x(), decimals, p.y(), decimals, p.z(), decimals);
      text += "endloop\nendfacet\n";
    }
    test::write_file(folder.path() / "part.stl", text + "endsolid\n");
    return messages(rigid_solid({{"part", StlSolid{folder.path() / "part.stl", mm}, 1000}}));
  };
  EXPECT_EQ(outcome(1e-3, 3), "");
  EXPECT_EQ(outcome(1e-2, 2), "");
  EXPECT_THAT(outcome(3e-3, 3), HasSubstr("open edges"));  // three steps
  EXPECT_THAT(outcome(0.1, 1), HasSubstr("open edges"));   // a tenth of a millimetre of 24
}

TEST(WeldedSurface, AGapBeyondRoundingIsAHole) {
  EXPECT_THAT(messages(stl_solid(noisy_box(2e-3))), HasSubstr("open edges"));
  // Far from the origin six digits are coarse: at most 10⁻⁴ of the size counts as rounding.
  EXPECT_THAT(messages(stl_solid(noisy_box(0.01, {5e3, 0, 0}, {5010, 10, 20}))), HasSubstr("open edges"));
}

/// A box with one triangle of its top divided: around a small triangle with this edge, which is left out.
test::Triangles box_with_small_hole(double edge) {
  test::Triangles box = test::box_triangles({0, 0, 0}, {10, 10, 20});
  const test::Triangle top = box.back();
  box.pop_back();
  const Eigen::Vector3d middle = (top[0] + top[1] + top[2]) / 3;
  test::Triangle small;
  for (std::size_t i = 0; i < 3; ++i) small[i] = middle + edge / 10 * (top[i] - middle);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    box.push_back({top[i], top[next], small[next]});
    box.push_back({top[i], small[next], small[i]});
  }
  return box;
}

TEST(WeldedSurface, AMissingTriangleIsAHoleHoweverSmall) {
  for (const double edge : {1.0, 1e-2, 2e-4, 4e-5})  // 4e-5: a tenth of the distance that counts as rounding
    EXPECT_THAT(messages(stl_solid(box_with_small_hole(edge))), HasSubstr("3 open edges")) << edge;
}

TEST(WeldedSurface, ATriangleThatIsWrittenTwiceCountsOnce) {
  test::Triangles box = test::box_triangles({0, 0, 0}, {10, 10, 20});
  box.push_back({box[3][1], box[3][2], box[3][0]});
  const auto solid = stl_solid(box);
  ASSERT_TRUE(solid) << messages(solid);
  EXPECT_THAT(solid->parts[0].volume, test::RelativelyNear(2000e-9, round_off));
  ASSERT_THAT(solid->remarks.list(), SizeIs(1));
  EXPECT_THAT(message(solid->remarks.list()[0]), HasSubstr("1 triangle is written twice"));
  // Facing the other way, it is no repetition.
  box.back() = {box[3][0], box[3][2], box[3][1]};
  const std::string said = messages(stl_solid(box));
  EXPECT_THAT(said, HasSubstr("one triangle is there twice, facing opposite sides"));
  EXPECT_THAT(said, testing::Not(HasSubstr("hole")));
}

TEST(WeldedSurface, AnInvertedTriangleIsStillRejected) {
  test::Triangles box = noisy_box(1e-9);
  std::swap(box[5][0], box[5][1]);
  EXPECT_THAT(messages(stl_solid(box)), HasSubstr("face opposite sides"));
}

TEST(StlFile, BytesAfterTheLastTriangleAreIgnored) {
  const foundation::TemporaryFolder folder;
  const test::Triangles box = test::box_triangles({0, 0, 0}, {1, 2, 3});
  const std::pair<std::string, std::size_t> files[] = {{test::stl_binary(box) + "COLOR=", 1},
                                                       {test::stl_text(box) + std::string(100, '\0'), 0},
                                                       {test::stl_text(box) + "\x1A", 0}};
  for (const auto& [bytes, remarks] : files) {
    test::write_file(folder.path() / "part.stl", bytes);
    const auto solid = rigid_solid({{"part", StlSolid{folder.path() / "part.stl", mm}, 1000}});
    ASSERT_TRUE(solid) << messages(solid);
    EXPECT_THAT(solid->parts[0].volume, test::RelativelyNear(6e-9, round_off));
    EXPECT_THAT(solid->remarks.list(), SizeIs(remarks));
  }
}

// ---- invalid files

TEST(StlFile, ReportsWhatIsWrong) {
  const foundation::TemporaryFolder folder;
  const auto messages_for = [&](const std::string& bytes) {
    test::write_file(folder.path() / "part.stl", bytes);
    return messages(rigid_solid({{"part", StlSolid{folder.path() / "part.stl", mm}, 1000}}));
  };
  const test::Triangles box = test::box_triangles({0, 0, 0}, {1, 1, 1});
  EXPECT_THAT(messages_for(""), HasSubstr("0 bytes"));
  EXPECT_THAT(messages_for("hello"), HasSubstr("5 bytes, neither text nor a binary STL file"));
  EXPECT_THAT(messages_for("solid nothing\nendsolid\n"), HasSubstr("contains no triangle"));
  EXPECT_THAT(messages_for(test::stl_binary(box).substr(0, 400)),
              HasSubstr("400 bytes; a binary file of 12 triangles, as stated in its header, has 684"));
  EXPECT_THAT(messages_for(test::stl_text(box).substr(0, 400)), HasSubstr("cut off"));
  EXPECT_THAT(messages_for("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 zero\n"),
              AllOf(HasSubstr("line 4"), HasSubstr("three finite numbers")));
  EXPECT_THAT(messages_for("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 nan\n"),
              HasSubstr("three finite numbers"));
  EXPECT_THAT(messages_for("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nendloop\n"),
              HasSubstr("a loop of 1 vertices"));
  EXPECT_THAT(messages_for("solid\nfaçade\n"), HasSubstr("unexpected 'façade'"));
  std::string with_nan = test::stl_binary(box);
  with_nan.replace(84 + 12, 4, "\xff\xff\xff\x7f");
  EXPECT_THAT(messages_for(with_nan), HasSubstr("triangle 1 of 12 has a coordinate that is not a finite number"));
  EXPECT_THAT(messages(rigid_solid({{"part", StlSolid{folder.path() / "missing.stl", mm}, 1000}})),
              HasSubstr("cannot be read"));
  EXPECT_THAT(messages(rigid_solid({{"part", StlSolid{folder.path(), mm}, 1000}})), HasSubstr("cannot be read"));
  EXPECT_THAT(messages(rigid_solid({{"part", StlSolid{folder.path() / "part.stl"}, 1000}})),
              HasSubstr("part.unit: not given"));
}

}  // namespace solids_test
