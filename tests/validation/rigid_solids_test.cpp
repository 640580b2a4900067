// SPDX-License-Identifier: BSD-3-Clause
// Rigid solids against closed forms that the code does not use.
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "support/matchers.h"
#include "support/step_shapes.h"
#include "support/stl_shapes.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/rigid_solid.h"

namespace rigid_solids_test {

using namespace trivet;
using namespace trivet::solids;
using std::numbers::pi;

constexpr double round_off = 1e-13;     // some hundred operations on numbers of equal size
constexpr double step_accuracy = 1e-9;  // required; Gauss quadrature over the exact surfaces is far more accurate
constexpr double mm = 1e-3, steel = 7850;

/// Largest difference of mass, centre and inertia, relative to mass, `size` and mass · size².
double difference(const spatial::MassProperties& a, const spatial::MassProperties& b, double size) {
  return std::max({std::abs(a.mass - b.mass) / b.mass, (a.centre - b.centre).norm() / size,
                   (a.inertia_about_centre - b.inertia_about_centre).cwiseAbs().maxCoeff() / (b.mass * size * size)});
}

spatial::MassProperties properties(const Part& part) {
  const auto solid = rigid_solid({part});
  if (!solid) throw std::runtime_error(message(solid.error().list().front()));
  return solid->properties;
}

spatial::MassProperties diagonal(double mass, const Eigen::Vector3d& centre, double xx, double yy, double zz) {
  return {mass, centre, Eigen::Vector3d(xx, yy, zz).asDiagonal()};
}

// Textbook moments of inertia: e.g. J. L. Meriam, L. G. Kraige: Engineering Mechanics, Dynamics, table D/4.
TEST(Primitives, HaveTheMomentsOfTheTextbook) {
  const double a = 0.3, b = 0.2, c = 0.1, m_box = steel * a * b * c;
  EXPECT_LE(difference(properties({"", Box{a, b, c}, steel}),
                       diagonal(m_box, {0, 0, 0}, m_box * (b * b + c * c) / 12, m_box * (a * a + c * c) / 12,
                                m_box * (a * a + b * b) / 12),
                       a),
            round_off);
  const double r = 0.07, l = 0.4, m_cylinder = steel * pi * r * r * l;
  EXPECT_LE(difference(properties({"", Cylinder{2 * r, l}, steel}),
                       diagonal(m_cylinder, {0, 0, 0}, m_cylinder * (3 * r * r + l * l) / 12,
                                m_cylinder * (3 * r * r + l * l) / 12, m_cylinder * r * r / 2),
                       l),
            round_off);
  const double i = 0.05, m_tube = steel * pi * (r * r - i * i) * l;
  EXPECT_LE(difference(properties({"", Tube{2 * r, 2 * i, l}, steel}),
                       diagonal(m_tube, {0, 0, 0}, m_tube * (3 * (r * r + i * i) + l * l) / 12,
                                m_tube * (3 * (r * r + i * i) + l * l) / 12, m_tube * (r * r + i * i) / 2),
                       l),
            round_off);
  const double m_sphere = steel * 4 / 3 * pi * r * r * r, j_sphere = 0.4 * m_sphere * r * r;
  EXPECT_LE(difference(properties({"", Sphere{2 * r}, steel}),
                       diagonal(m_sphere, {0, 0, 0}, j_sphere, j_sphere, j_sphere), r),
            round_off);
}

TEST(Primitives, AConeHasItsCentreAQuarterAboveItsBase) {
  const double r = 0.06, h = 0.2, m = steel * pi * r * r * h / 3;
  const double across = m * (3.0 / 20 * r * r + 3.0 / 80 * h * h);
  EXPECT_LE(difference(properties({"", Cone{2 * r, 0, h}, steel}),
                       diagonal(m, {0, 0, -h / 4}, across, across, 0.3 * m * r * r), h),
            round_off);
  EXPECT_LE(difference(properties({"", Cone{0, 2 * r, h}, steel}),
                       diagonal(m, {0, 0, h / 4}, across, across, 0.3 * m * r * r), h),
            round_off);
}

TEST(Primitives, AFrustumIsAConeWithoutItsTip) {
  const double h = 0.3, r = 0.09;  // the tip is the upper third
  const Part cone{"cone", Cone{2 * r, 0, h}, steel},
      tip{"tip", Cone{2 * r / 3, 0, h / 3}, steel, {{0, 0, h / 3}, Eigen::Matrix3d::Identity()}},
      frustum{"frustum", Cone{2 * r, 2 * r / 3, 2 * h / 3}, steel, {{0, 0, -h / 6}, Eigen::Matrix3d::Identity()}};
  const auto together = rigid_solid({frustum, tip});
  ASSERT_TRUE(together);
  EXPECT_LE(difference(together->properties, properties(cone), h), round_off);
}

TEST(Primitives, ATubeIsTheDifferenceOfTwoCylinders) {
  const VolumeIntegrals tube = integrals(Tube{0.2, 0.15, 0.5}), outer = integrals(Cylinder{0.2, 0.5}),
                        inner = integrals(Cylinder{0.15, 0.5});
  EXPECT_THAT(tube.volume, test::RelativelyNear(outer.volume - inner.volume, round_off));
  EXPECT_LE((tube.second_moment - (outer.second_moment - inner.second_moment)).norm(),
            round_off * outer.second_moment.norm());
}

/// Two boxes, 3 × 1 × 1 along x and 1 × 1 × 1 on its end at y = 1: V = 4, centre (1.25, 0.75, 0.5), ∫xy dm = −0.75
/// about the centre.
spatial::MassProperties l_block(double length, double density) {
  const double m = 4 * std::pow(length, 3) * density;
  spatial::MassProperties p{m, length * Eigen::Vector3d(1.25, 0.75, 0.5), {}};
  p.inertia_about_centre << 17.0 / 12, 0.75, 0, 0.75, 41.0 / 12, 0, 0, 0, 25.0 / 6;
  p.inertia_about_centre *= m * length * length / 4;
  return p;
}

/// Surface of the L-block: its outline extruded along z, and its two faces.
test::Triangles l_block_surface() {
  const std::vector<Eigen::Vector2d> outline{{0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}};
  const auto at = [&](std::size_t i, double z) { return Eigen::Vector3d(outline[i % 8].x(), outline[i % 8].y(), z); };
  test::Triangles surface;
  for (std::size_t i = 0; i < 8; ++i) {
    surface.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 1)});
    surface.push_back({at(i, 0), at(i + 1, 1), at(i, 1)});
  }
  for (const auto& [a, b, c] : {std::array{0, 1, 4}, {0, 4, 7}, {1, 2, 3}, {1, 3, 4}, {7, 4, 5}, {7, 5, 6}}) {
    const auto i = to_size(a), j = to_size(b), k = to_size(c);
    surface.push_back({at(i, 1), at(j, 1), at(k, 1)});
    surface.push_back({at(i, 0), at(k, 0), at(j, 0)});
  }
  return surface;
}

TEST(StlSolid, LBlockIsExactWithItsProductOfInertia) {
  const foundation::TemporaryFolder folder;
  test::write_file(folder.path() / "l.stl", test::stl_binary(l_block_surface()));
  EXPECT_LE(difference(properties({"", StlSolid{folder.path() / "l.stl", mm}, steel}), l_block(mm, steel), 3 * mm),
            round_off);
}

TEST(StepSolid, LBlockIsExactWithItsProductOfInertia) {
  const foundation::TemporaryFolder folder;
  test::write_step(folder.path() / "l.step", R"(Box(1) = {0, 0, 0, 3, 1, 1}; Box(2) = {0, 0, 0, 1, 2, 1};
    BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };)");
  EXPECT_LE(difference(properties({"", StepSolid{folder.path() / "l.step"}, steel}), l_block(mm, steel), 3 * mm),
            step_accuracy);
}

TEST(StepSolid, CylinderSphereTorusAndConeAreExact) {
  const foundation::TemporaryFolder folder;
  test::write_step(folder.path() / "round.step", R"(
    Cylinder(1) = {0, 0, 0, 0, 0, 25, 25};
    Sphere(2) = {100, 0, 0, 20};
    Torus(3) = {0, 100, 0, 30, 10};
    Cone(4) = {0, 0, 100, 0, 0, 40, 15, 5};)");
  const std::filesystem::path file = folder.path() / "round.step";
  const auto solid = [&](int number) { return properties({"", StepSolid{file, {number}}, steel}); };
  const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();
  EXPECT_LE(
      difference(solid(1), properties({"", Cylinder{50 * mm, 25 * mm}, steel, {{0, 0, 12.5 * mm}, straight}}), 50 * mm),
      step_accuracy);
  EXPECT_LE(difference(solid(2), properties({"", Sphere{40 * mm}, steel, {{100 * mm, 0, 0}, straight}}), 40 * mm),
            step_accuracy);
  EXPECT_LE(difference(solid(4), properties({"", Cone{30 * mm, 10 * mm, 40 * mm}, steel, {{0, 0, 120 * mm}, straight}}),
                       40 * mm),
            step_accuracy);
  const double c = 30 * mm, a = 10 * mm,
               m = steel * 2 * pi * pi * c * a * a;  // ring: J = m(c² + 3a²/4), m(c²/2 + 5a²/8)
  EXPECT_LE(difference(solid(3),
                       diagonal(m, {0, 100 * mm, 0}, m * (c * c / 2 + 5 * a * a / 8), m * (c * c / 2 + 5 * a * a / 8),
                                m * (c * c + 0.75 * a * a)),
                       80 * mm),
            step_accuracy);
}

TEST(StepSolid, UsesTheLengthUnitOfItsFile) {
  const foundation::TemporaryFolder folder;
  test::write_step(folder.path() / "box.step", "Box(1) = {0, 0, 0, 10, 20, 30};");
  std::ifstream stream(folder.path() / "box.step");
  std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::size_t unit = text.find("SI_UNIT(.MILLI.,.METRE.)");
  ASSERT_NE(unit, std::string::npos);
  text.replace(unit, 24, "SI_UNIT(.CENTI.,.METRE.)");
  test::write_file(folder.path() / "box.step", text);
  EXPECT_THAT(properties({"", StepSolid{folder.path() / "box.step"}, 1000}).mass,
              test::RelativelyNear(6.0, step_accuracy));
}

}  // namespace rigid_solids_test
