// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "support/projects.h"
#include "trivet/elements/friction.h"
#include "trivet/judging/read_project.h"

namespace law_readers_test {

using namespace trivet;

elements::LuGreFriction bristles(const std::string& laws) {
  const project::Project file = test::project(R"(trivet = 1
[bodies.m]
mass = 10
free = ["x"]
[elements.strap]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [1000, 0, 0]
laws.x = )" + laws + "\n");
  return std::get<elements::LuGreFriction>(file.base().system.elements().at(0).nonlinear_parts.at(0).laws.at(0));
}

TEST(LawReaders, ReadBristlesWithinFrictionAndBesideIt) {
  const std::string law =
      R"(lugre = {stiffness = "200 N/mm", slip = 20, breakaway = 28, stribeck_velocity = "60 mm/s", damping = 90, viscous = 40})";
  for (const std::string& laws : {"{" + law + "}", "{friction = {" + law + "}}"}) {
    const elements::LuGreFriction found = bristles(laws);
    EXPECT_EQ(found.stiffness, 2e5) << laws;
    EXPECT_EQ(found.slip, 20) << laws;
    EXPECT_EQ(found.breakaway, 28) << laws;
    EXPECT_EQ(found.stribeck_velocity, 0.06) << laws;
    EXPECT_EQ(found.damping, 90) << laws;
    EXPECT_EQ(found.viscous, 40) << laws;
  }
}

std::string with_gap_stop(const std::string& axis, const std::string& dissipation) {
  return "trivet = 1\n[bodies.m]\nmass = 10\ninertia = {about = \"center_of_mass\", xx = 1, yy = 1, zz = "
         "1}\n[elements.mount]\ntype = "
         "\"bushing\"\non = \"m\"\nat = [0, 0, 0]\ntranslation = [1000, 1000, 1000]\nrotation = [10, 10, 10]\nlaws." +
      axis + " = {gap_stop = {gap = 0.002, stiffness = 2e5, dissipation = " + dissipation + "}}\n";
}

TEST(LawReaders, ReadTheDissipationOfAStopWithItsUnit) {
  for (const auto& [axis, dissipation] :
       {std::pair{"x", "0.4"}, {"x", "\"0.4 s/m\""}, {"x", "\"4e-4 s/mm\""}, {"rx", "0.4"}, {"rx", "\"0.4 s/rad\""}}) {
    const project::Project file = test::project(with_gap_stop(axis, dissipation));
    const elements::ScalarLaw& law = file.base().system.elements().at(0).nonlinear_parts.at(0).laws.at(0);
    EXPECT_DOUBLE_EQ(std::get<elements::GapStop>(std::get<elements::ElasticForce>(law)).dissipation, 0.4)
        << axis << " " << dissipation;
  }
  for (const auto& [axis, dissipation] : {std::pair{"x", "\"0.4 s/rad\""}, {"rx", "\"0.4 s/m\""}})
    EXPECT_FALSE(judging::project_from_text(with_gap_stop(axis, dissipation), "p.toml")) << axis << " " << dissipation;
}

}  // namespace law_readers_test
