// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <functional>
#include <stdexcept>

#include "trivet/judging/read_project.h"
#include "trivet/project/project.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"

namespace default_number_test {

using namespace trivet;
using project::Quantity;

project::Case base_of(const std::string& text) {
  auto read = judging::project_from_text(text, "machine.toml");
  if (!read) throw std::runtime_error(read.error().list().front().finding);
  return read->base();
}

const char* const machine = R"(trivet = 1
gravity = [0, 0, -9.81]
[bodies.m]
mass = 120
inertia = {about = "center_of_mass", xx = 4, yy = 5, zz = 6}
points = {seat = [0.1, 0.2, "300 mm"]}
[element_types.mount]
type = "bushing"
translation = [4e4, 5e4, 9e4]
damping = {proportional = "2 ms"}
[elements.a]
type = "mount"
on = "m"
at = [0, 0, -0.2]
[elements.b]
type = "bushing"
on = "m"
at = [0, 0, -0.2]
translation = [4e4, 5e4, 9e4]
rotation = [4e3, 5e3, 9e3]
[excitations.fan]
type = "unbalance"
on = "m"
at = [0, 0, 0]
axis = "x"
mass_eccentricity = "3 g mm"
)";

TEST(QuantityOfANumber, IsThatAsWhichItIsRead) {
  const project::Case base = base_of(machine);
  const auto quantity = [&](const std::string& path) {
    return project::quantity_at(base.document, project::path_keys(path));
  };
  EXPECT_EQ(quantity("bodies.m.mass"), Quantity::mass);
  EXPECT_EQ(quantity("bodies.m.inertia.xx"), Quantity::inertia);
  EXPECT_EQ(quantity("bodies.m.points.seat.z"), Quantity::length);
  EXPECT_EQ(quantity("elements.a.damping.proportional"), Quantity::time);
  EXPECT_EQ(quantity("element_types.mount.damping.proportional"), Quantity::time);
  EXPECT_EQ(quantity("element_types.mount.translation.z"), Quantity::force_per_length);
  EXPECT_EQ(quantity("elements.b.rotation.x"), Quantity::moment_per_angle);
  EXPECT_EQ(quantity("excitations.fan.mass_eccentricity"), Quantity::mass_length);
  EXPECT_EQ(quantity("gravity.z"), Quantity::acceleration);
}

TEST(QuantityOfANumber, IsKnownForKeysThatAreNotWritten) {
  const project::Case base = base_of(machine);
  const auto quantity = [&](const std::string& path) {
    return project::quantity_at(base.document, project::path_keys(path));
  };
  EXPECT_EQ(quantity("elements.a.scale"), Quantity::pure);
  EXPECT_EQ(quantity("element_types.mount.scale"), Quantity::pure);
  EXPECT_EQ(quantity("elements.a.moved.x"), Quantity::length);
  EXPECT_EQ(quantity("bodies.m.inertia_about_center.xx"), Quantity::pure);
  EXPECT_EQ(quantity("bodies.m.nothing"), std::nullopt);
  EXPECT_EQ(quantity("bodies.m.points"), std::nullopt);
}

/// Every number of the bodies, elements and excitations of the examples has a quantity, unless it counts something.
TEST(QuantityOfANumber, IsKnownInTheExamples) {
  for (const char* example : {"paper/corrected.toml", "genset/genset.toml", "two_stage/pump_on_raft.toml"}) {
    const auto read = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/" + example);
    ASSERT_TRUE(read) << example;
    std::vector<std::string> unknown;
    const std::function<void(const project::Node&, const std::string&)> look = [&](const project::Node& node,
                                                                                   const std::string& path) {
      const bool is_number = node.kind == project::Node::Kind::real || node.kind == project::Node::Kind::integer;
      if (is_number && !node.quantity) unknown.push_back(path);
      for (std::size_t i = 0; i < node.items.size(); ++i)
        look(node.items[i], path + "." + (i < node.keys.size() ? node.keys[i] : std::to_string(i)));
    };
    for (const char* table : {"bodies", "elements", "excitations"})
      if (const project::Node* parts = read->base().document.find(table)) look(*parts, table);
    EXPECT_THAT(unknown, testing::IsEmpty()) << example;
  }
}

}  // namespace default_number_test
