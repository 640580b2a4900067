// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "trivet/results/format/axis_words.h"

namespace axis_words_test {

using namespace trivet;

project::DesignAxis axis(const std::string& path, double from, double to, project::Quantity quantity) {
  project::DesignAxis axis;
  axis.parameter = axis.name = path;
  axis.from = from;
  axis.to = to;
  axis.quantity = quantity;
  return axis;
}

TEST(AxisUnit, IsTheGivenOneOrThatOfABareNumber) {
  project::DesignAxis damping = axis("elements.d.coefficient", 1, 2, project::Quantity::damping_force_per_length);
  EXPECT_EQ(results::axis_unit(damping), "N s/m");
  damping.unit = "kN s/m";
  EXPECT_EQ(results::axis_unit(damping), "kN s/m");
  EXPECT_EQ(results::axis_unit(axis("bodies.m.inertia.xx", 1, 2, project::Quantity::inertia)), "kg m²");
  EXPECT_EQ(results::axis_unit(axis("elements.s.scale", 1, 2, project::Quantity::pure)), "");
}

TEST(AxisName, SaysWhatIsChanged) {
  const auto name = [](const std::string& path) { return results::axis_name(axis(path, 1, 2, {})); };
  EXPECT_EQ(name("elements.s.scale"), "stiffness scale of s");
  EXPECT_EQ(name("elements.\"front left\".at.y"), "place y of front left");
  EXPECT_EQ(name("elements.s.translation.z"), "stiffness z of s");
  EXPECT_EQ(name("elements.s.damping.translation.z"), "damping translation z of s");
  EXPECT_EQ(name("elements.s.damping.proportional"), "proportional damping δ of s");
  EXPECT_EQ(name("excitations.ground.translation.z"), "translation z of ground");
  EXPECT_EQ(name("bodies.m.points.seat.z"), "seat z of m");
  EXPECT_EQ(name("bodies.m.inertia.xx"), "moment of inertia xx of m");
  EXPECT_EQ(name("bodies.m.inertia_about_center.xy"), "inertia factor xy of m");
  EXPECT_EQ(name("gravity.z"), "gravity z");
}

TEST(AxisValue, HasEnoughDigitsToDistinguishDesigns) {
  EXPECT_EQ(results::axis_value(1.3, axis("elements.s.scale", 1, 2, project::Quantity::pure)), "1.3");
  project::DesignAxis fine = axis("elements.s.scale", 1, 1.0000000001, project::Quantity::pure);
  fine.points = 9;
  EXPECT_EQ(results::axis_value(1.00000000005, fine), "1.00000000005");
  project::DesignAxis damping = axis("elements.s.damping.proportional", 0.01, 0.5, project::Quantity::time);
  damping.logarithmic = true;
  EXPECT_EQ(results::axis_value(0.12, damping), "0.12 s");
}

}  // namespace axis_words_test
