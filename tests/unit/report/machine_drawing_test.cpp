// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/machine_drawing.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/excited_machine.h"
#include "trivet/report/drawing/label_placement.h"
#include "trivet/report/drawing/seen_surface.h"
#include "trivet/report/drawing/view_projection.h"

namespace machine_drawing_test {

using namespace trivet;
using report::Box;
using report::PixelPoint;
using testing::HasSubstr;

constexpr double round_off = 1e-12;  // a few operations on numbers near 1

TEST(FourViews, HavePaperAxesThatAreNotMirrored) {
  for (const report::View& view : report::four_views()) {
    EXPECT_NEAR(view.right.norm(), 1, round_off) << view.name;
    EXPECT_NEAR(view.up.norm(), 1, round_off) << view.name;
    EXPECT_NEAR(view.right.dot(view.up), 0, round_off) << view.name;
  }
  const auto& [front, side, top, isometric] = report::four_views();
  EXPECT_NEAR((front.towards() + Eigen::Vector3d::UnitY()).norm(), 0, round_off);
  EXPECT_NEAR((side.towards() - Eigen::Vector3d::UnitX()).norm(), 0, round_off);
  EXPECT_NEAR((top.towards() - Eigen::Vector3d::UnitZ()).norm(), 0, round_off);
  EXPECT_NEAR((isometric.towards() - Eigen::Vector3d(1, -1, 1) / std::sqrt(3.0)).norm(), 0, round_off);
}

TEST(Projection, DrawsTheIsometricAxesEquallyLong) {
  const report::Projection projection{report::four_views()[3], 100, Eigen::Vector3d::Zero(), {50, 60}};
  for (int axis = 0; axis < 3; ++axis) {
    const PixelPoint p = projection.at(Eigen::Vector3d::Unit(axis));
    EXPECT_NEAR(std::hypot(p.x - 50, p.y - 60), 100 * std::sqrt(2.0 / 3), 100 * round_off);
  }
}

TEST(EquivalentBox, OfAHomogeneousBoxIsThatBox) {
  const double m = 12, a = 0.3, b = 0.2, c = 0.1;  // half lengths
  spatial::MassProperties mass{m, {1, 2, 3}, Eigen::Matrix3d::Zero()};
  mass.inertia_about_centre.diagonal() << m / 3 * (b * b + c * c), m / 3 * (a * a + c * c), m / 3 * (a * a + b * b);
  report::Bounds bounds;
  for (const Eigen::Vector3d& v : results::equivalent_box(mass).surface().vertices) bounds.include(v);
  EXPECT_NEAR((bounds.low - Eigen::Vector3d(0.7, 1.8, 2.9)).norm(), 0, 10 * round_off);
  EXPECT_NEAR((bounds.high - Eigen::Vector3d(1.3, 2.2, 3.1)).norm(), 0, 10 * round_off);
}

TEST(SeenSurface, OfAPlateWithoutThicknessIsALineFromTheFront) {
  const auto front =
      report::seen(results::box_surface({1, 2, 0}), {report::four_views()[0], 1, Eigen::Vector3d::Zero(), {}});
  EXPECT_TRUE(front.faces.empty());
  EXPECT_FALSE(front.lines.empty());
}

TEST(SeenSurface, OfABoxHasOneFaceFromTheFrontAndThreeIsometrically) {
  const results::SolidSurface box = results::box_surface({1, 2, 3});
  const auto faces = [&](std::size_t view) {
    return report::seen(box, {report::four_views()[view], 1, Eigen::Vector3d::Zero(), {}});
  };
  EXPECT_EQ(faces(0).faces.size(), 1u);
  EXPECT_EQ(faces(0).lines.size(), 4u);
  EXPECT_EQ(faces(3).faces.size(), 3u);
  EXPECT_EQ(faces(3).lines.size(), 9u);
}

TEST(PlacedLabels, OfNearbyPlacesDoNotOverlapAndStayInTheArea) {
  const Box area{0, 0, 460, 330};
  std::vector<report::Label> labels;
  std::vector<Box> marks;
  for (int i = 0; i < 40; ++i) {
    const PixelPoint place{130.0 + 22 * (i % 10), 120.0 + 24 * (i / 10)};
    labels.push_back({"mount " + std::to_string(i), place});
    marks.push_back({place.x - 5, place.y - 5, place.x + 5, place.y + 5});
  }
  const auto placed = report::placed_labels(labels, area, {marks}, 11);
  int written = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (!placed[i]) continue;
    ++written;
    EXPECT_TRUE(area.contains(placed[i]->box)) << i;
    for (const Box& mark : marks) EXPECT_FALSE(placed[i]->box.overlaps(mark)) << i;
    for (std::size_t j = 0; j < placed.size(); ++j) {
      if (i == j || !placed[j]) continue;
      EXPECT_FALSE(placed[i]->box.overlaps(placed[j]->box)) << i << " over " << j;
      EXPECT_FALSE(report::crosses(placed[i]->box, labels[j].place, placed[j]->leader)) << i << " on line " << j;
    }
  }
  EXPECT_GE(written, 20);
}

TEST(PlacedLabels, KeepOffTheOutlinesOfBodiesIfThereIsRoomNearby) {
  const Box area{0, 0, 400, 300};
  const std::vector<report::Label> labels = {{"rear right", {100, 100}}, {"middle right", {200, 100}}};
  const std::vector<Box> marks = {{94, 94, 106, 106}, {194, 94, 206, 106}};
  const std::vector<std::pair<PixelPoint, PixelPoint>> edge = {{{60, 97}, {340, 103}}};
  const auto placed = report::placed_labels(labels, area, {marks, edge}, 11);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    ASSERT_TRUE(placed[i]) << i;
    EXPECT_FALSE(report::crosses(placed[i]->box, edge[0].first, edge[0].second)) << i;
  }
  std::vector<std::pair<PixelPoint, PixelPoint>> everywhere;
  for (double y = 0; y < area.bottom; y += 5) everywhere.push_back({{0, y}, {area.right, y}});
  EXPECT_TRUE(report::placed_labels(labels, area, {marks, everywhere}, 11)[0]);
}

TEST(MachineDrawing, NamesBodiesAndElements) {
  const project::Case machine{.system = model::System::checked(test::machine_on_four_mounts()).value()};
  const std::string svg = report::machine_drawing(machine);
  for (const char* view : {"front", "side", "top", "isometric"}) EXPECT_THAT(svg, HasSubstr(view));
  for (const model::Element& element : machine.system.elements()) EXPECT_THAT(svg, HasSubstr(element.name));
  EXPECT_THAT(svg, HasSubstr(machine.system.bodies().front().name));
}

TEST(MachineDrawing, OverAGivenDesignNamesIt) {
  const project::Case machine{.system = model::System::checked(test::machine_on_four_mounts()).value()};
  EXPECT_THAT(report::machine_drawing(machine, machine), HasSubstr("given design"));
}

}  // namespace machine_drawing_test
