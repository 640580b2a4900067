// SPDX-License-Identifier: BSD-3-Clause
// A mass without inertia against closed forms: at the end of a cantilever its rotations follow the bending without
// inertia, so the stiffness is 3EI/L³ and not the 12EI/L³ of a guided end.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/judging/read_project.h"
#include "trivet/model/nodes.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/whole_study.h"

namespace point_mass_test {

using namespace trivet;
using test::RelativelyNear;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double of_solves = 1e-10;  // round-off: condition 1e4 of the bar's stiffness
constexpr double mass = 100, length = 0.8, area = 36e-6, inertia = 492e-12, young = 200e9, shear = 79.3e9,
                 shear_factor = 5.0 / 6;

std::string on_a_bar(const std::string& more) {
  return fmt::format(R"(trivet = 1
[bodies.tip]
mass = {}
inertia = {{about = "center_of_mass", xx = 0, yy = 0, zz = 0}}
position = [0, 0, {}]
[elements.bar]
type = "beam"
level = "quasi_static"
on = "tip"
at = [0, 0, 0]
from_at = [0, 0, 0]
section = {{area = {}, moment_x = {}, moment_y = {}, torsion = 1e-9, shear_factor_x = {}, shear_factor_y = {}}}
material = {{E = {}, G = {}, density = 7850}}
[excitations.push]
type = "harmonic"
on = "tip"
at = [0, 0, 0]
force = [5, 0, 0]
[excitations.load]
type = "constant"
on = "tip"
at = [0, 0, 0]
force = [5, 0, 0]
)",
                     mass, length, area, inertia, inertia, shear_factor, shear_factor, young, shear) +
      more;
}

/// Compliance of the tip under a lateral force: bending and shear.
double lateral() { return length * length * length / (3 * young * inertia) + length / (shear_factor * area * shear); }

study::CaseResults results_of(const std::string& text) {
  const project::Project project = test::project(text);
  return study::case_results(project.base(), project.base().analyses);
}

TEST(PointMass, OnACantileverHasThreeModes) {
  const modal::Modes modes = results_of(on_a_bar("[analyses]\nmodes = {}\nroots = {}\n")).modes;
  ASSERT_EQ(modes.list.size(), 3);
  const double bending = 1 / std::sqrt(mass * lateral()), axial = std::sqrt(young * area / length / mass);
  EXPECT_THAT(*modes.list[0].angular_frequency, RelativelyNear(bending, of_solves));
  EXPECT_THAT(*modes.list[1].angular_frequency, RelativelyNear(bending, of_solves));
  EXPECT_THAT(*modes.list[2].angular_frequency, RelativelyNear(axial, of_solves));
}

TEST(PointMass, TurnsWithTheEndOfTheBarAtRestAndInTheResponse) {
  const study::CaseResults found = results_of(
      on_a_bar("[analyses]\nstatic = {of = [\"tip\"]}\nresponse = {of = [\"tip.x\", \"tip.ry\"], at = [2]}\n"));
  double x = 0, ry = 0;
  for (const response::StaticValue& value : found.statics->values) {
    if (value.name == "tip.x") x = value.value;
    if (value.name == "tip.ry") ry = value.value;
  }
  const double slope = length * length / (2 * young * inertia);
  EXPECT_THAT(x, RelativelyNear(5 * lateral(), of_solves));
  EXPECT_THAT(ry, RelativelyNear(5 * slope, of_solves));
  const double factor = 1 / (1 - mass * 4 * lateral());
  const auto& curves = found.response->curves.curves;
  EXPECT_THAT(curves[0].value(0).real(), RelativelyNear(5 * lateral() * factor, of_solves));
  EXPECT_THAT(curves[1].value(0).real(), RelativelyNear(5 * slope * factor, of_solves));
}

/// Rotations that nothing touches are left out, and are no rigid-body modes.
TEST(PointMass, OnSpringsAtItsPoleHasNoRotations) {
  const std::string text = R"(trivet = 1
[bodies.m]
mass = 2
inertia = {about = "pole", xx = 0, yy = 0, zz = 0}
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [800, 1800, 3200]
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [1, 0, 0]
[analyses]
modes = {}
)";
  const project::Project project = test::project(text);
  EXPECT_THAT(model::left_out_notes(project.base().system.description()),
              ElementsAre("point mass m: rotation about x, y, z are held by no element and left out"));
  const modal::Modes modes = study::case_results(project.base(), project.base().analyses).modes;
  ASSERT_EQ(modes.list.size(), 3);
  for (const auto& [i, omega] : {std::pair{0, 20.0}, {1, 30.0}, {2, 40.0}})
    EXPECT_THAT(*modes.list[static_cast<std::size_t>(i)].angular_frequency, RelativelyNear(omega, of_solves));
  for (const study::CheckLine& line : study::check_lines(project.base())) EXPECT_TRUE(line.passed) << line.what;
  const auto turned = judging::project_from_text(text +
                                                     "[excitations.moment]\ntype = \"harmonic\"\non = \"m\"\nat = [0, "
                                                     "0, 0]\nforce = [0, 0, 0]\nmoment = [1, 0, 0]\n",
                                                 "test.toml");
  ASSERT_FALSE(turned.has_value());
  EXPECT_THAT(foundation::message(turned.error().list().front()), HasSubstr("rotation about x of point mass"));
}

/// explain changes copies of the model that may be unphysical; a point mass is not.
TEST(PointMass, IsNotUnphysicalForModalDamping) {
  std::string text = on_a_bar("[damping]\nmodal = 0.02\n[analyses]\nmodes = {}\n");
  text.replace(text.find("inertia ="), 0, "allow_unphysical = true\n");
  EXPECT_EQ(results_of(text).modes.list.size(), 3);
}

/// The same as a body whose inertia is far too small to matter below its own frequencies.
TEST(PointMass, IsTheLimitOfASmallInertiaInAStep) {
  const std::string in_time =
      "[excitations.step]\ntype = \"time\"\non = \"tip\"\nat = [0, 0, 0]\nforce = [1, 0, 0]\nhistory = {step = "
      "{amplitude = 5}}\n[damping]\nrayleigh = {mass = 1}\n[analyses]\ntransient = {of = [\"tip.x\"], to = 1}\n";
  const auto largest = [&](const std::string& value) {
    std::string text = on_a_bar(in_time);
    for (const char* key : {"xx = 0", "yy = 0", "zz = 0"})
      text.replace(text.find(key), 6, std::string(key).substr(0, 5) + value);
    const study::CaseResults found = results_of(text);
    return found.transient->response.curves.front().largest.value;
  };
  constexpr double share_of_inertia = 1e-5;  // of the frequency of the mass, with 1e-6 kg m² beside m L² = 64 kg m²
  EXPECT_THAT(largest("0"), RelativelyNear(largest("1e-6"), share_of_inertia));
}

}  // namespace point_mass_test
