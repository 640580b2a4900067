// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/fem/preload.h"
#include "trivet/fem/shapes.h"
#include "trivet/modal/modes.h"
#include "trivet/response/steady/static_response.h"

/// A rubber mount that finds its own compression under its machine against the same mount with that preload.
namespace nonlinear_mount_test {

using namespace trivet;
using test::RelativelyNear;

std::string on_rubber(const std::string& state) {
  return R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 150
inertia = {about = "center_of_mass", xx = 3, yy = 3, zz = 3}
[elements.mount]
type = "rubber_disc"
on = "m"
at = [0, 0, 0]
axis = "z"
diameter = "50 mm"
thickness = "25 mm"
material = {G = "1 MPa", bulk_modulus = "500 MPa"}
method = "finite_elements"
mesh_level = 2
)" + state;
}

TEST(NonlinearMount, AtRestIsTheOnePreloadedByItsLoad) {
  constexpr double load = 150 * 9.80665;
  const project::Case nonlinear = test::project(on_rubber("nonlinear = true\n")).base(),
                      preloaded =
                          test::project(on_rubber("preload = {force = \"" + std::to_string(load) + " N\"}\n")).base();
  const auto sag = [](const project::Case& one) {
    const assembly::Assembled assembled = assembly::assemble(one.system);
    return response::static_response(one.system, assembled, {"m.z", "mount.force.z"});
  };
  const auto at_rest = sag(nonlinear);
  constexpr double between_states = 1e-3;  // five states over a quarter of the height
  EXPECT_THAT(at_rest.values[1].value, RelativelyNear(-load, 1e-9));
  // The preloaded mount moves no farther under the weight that it carries; its own compression is in its facts.
  std::string compressed;
  for (const model::Fact& fact : preloaded.system.elements()[0].facts)
    if (fact.what == "compressed by") compressed = fact.value;
  ASSERT_THAT(compressed, testing::HasSubstr(" mm"));
  EXPECT_THAT(-at_rest.values[0].value, RelativelyNear(1e-3 * std::stod(compressed), between_states));
  const elements::Matrix12 found = elements::stiffness(nonlinear.system.elements()[0].law),
                           expected = elements::stiffness(preloaded.system.elements()[0].law);
  for (const int direction : {6, 7, 8, 11})  // the others depend on the distance of the ends
    EXPECT_THAT(found(direction, direction), RelativelyNear(expected(direction, direction), between_states))
        << direction;
  const modal::Modes ours = modal::modes(nonlinear.system), theirs = modal::modes(preloaded.system);
  ASSERT_EQ(ours.list.size(), 6u);
  constexpr double lever = 0.08;  // the ends keep their distance, which a preload makes shorter
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_THAT(*ours.list[i].angular_frequency, RelativelyNear(*theirs.list[i].angular_frequency, lever)) << i;
}

/// Beside a strut that pulls across it, whose force turns as the mount is displaced.
TEST(NonlinearMount, RestsBesideAStrutWhereTheirForcesAreInBalance) {
  std::string text = on_rubber("nonlinear = true\n") + R"([elements.strut]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = ["-80 mm", 0, 0]
free_length = "50 mm"
stiffness = "30 N/mm"
)";
  text.replace(text.find("mass = 150"), 10, "mass = 150\nfree = [\"x\", \"z\"]");
  const project::Case rest = test::project(text).base();
  const model::Element &mount = rest.system.elements()[0], &strut = rest.system.elements()[1];
  const model::DistancePart& pulls = strut.distance_parts[0];
  const Eigen::Vector3d line = pulls.law.offset + pulls.at_rest;
  const double along = line.dot(pulls.law.offset.normalized()), length = line.norm(), pull = 3e4 * (length - 0.05);
  constexpr double of_newton = 1e-8;
  EXPECT_THAT(std::sqrt(length * length - along * along),
              RelativelyNear(std::abs(mount.nonlinear_parts[0].at_rest), of_newton));
  EXPECT_THAT(elements::stiffness(mount.law)(6, 6) * (0.08 - along), RelativelyNear(pull * along / length, of_newton));
}

/// A bush under its machine against the same solid with that force across its axis.
TEST(NonlinearMount, ABushAtRestIsTheSolidUnderItsLoad) {
  constexpr double mass = 400, load = mass * 9.80665;
  const project::Case machine = test::project(R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 400
inertia = {about = "center_of_mass", xx = 9, yy = 9, zz = 9}
[elements.bush]
type = "rubber_bush"
on = "m"
at = [0, 0, 0]
orientation = {matrix = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]}
inner_diameter = "24 mm"
outer_diameter = "60 mm"
length = "50 mm"
material = {G = "0.8 MPa", bulk_modulus = "500 MPa"}
method = "finite_elements"
mesh_level = 1
nonlinear = true
)")
                                    .base();
  const fem::Shape shape = fem::Bush{.inner_diameter = 0.024, .outer_diameter = 0.06, .length = 0.05};
  fem::Preload weight;  // e1 is upwards
  weight.value(0) = -load;
  weight.is_load[0] = true;
  const fem::PreloadedStiffness solid = fem::preloaded_stiffness(
      fem::mesh(shape, 1), {fem::Material{.c10 = 0.4e6, .bulk_modulus = 500e6}}, fem::frame(shape), weight);
  ASSERT_TRUE(solid.converged);
  const assembly::Assembled assembled = assembly::assemble(machine.system);
  const auto at_rest = response::static_response(machine.system, assembled, {"m.z", "m.x", "bush.force.z"});
  constexpr double between_states = 1e-4, smallest = 1e-9;
  EXPECT_THAT(at_rest.values[0].value, RelativelyNear(solid.motion(0), between_states));
  EXPECT_NEAR(at_rest.values[1].value, 0, smallest * std::abs(solid.motion(0)));
  EXPECT_THAT(at_rest.values[2].value, RelativelyNear(-load, smallest));
  const model::Element& bush = machine.system.elements()[0];
  const elements::Matrix12 found = elements::stiffness(bush.law);
  constexpr double of_interpolation = 1e-3;  // of entries that change by a few percent between the states
  for (const int direction : {6, 7, 8, 9, 10, 11})
    EXPECT_THAT(found(direction, direction), RelativelyNear(solid.stiffness(direction, direction), of_interpolation))
        << direction;
  // About the state, with its ends at one point, a rigid rotation turns the force and does nothing else.
  const double force = -load, deflection = bush.nonlinear_parts[0].at_rest;
  elements::Vector12 preload = elements::Vector12::Zero();
  preload(6) = force;
  preload(0) = -force;
  const Eigen::Matrix<double, 12, 6> moved =
      bush.over_deflection->at(deflection, force) * elements::rigid_motions({0, 0, 0}, Eigen::Matrix3d::Identity());
  EXPECT_LT((moved - elements::turned_preload(preload, Eigen::Matrix3d::Identity())).norm(), 1e-6 * load);
}

}  // namespace nonlinear_mount_test
