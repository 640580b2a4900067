// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/study/map/design_map.h"

namespace map_marks_test {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

/// A pad measured from 5 to 100 Hz, a typical range of rigs.
std::string measured_pad(const foundation::TemporaryFolder& folder) {
  const std::string file = (folder.path() / "pad.csv").string();
  std::ofstream(file) << "frequency_hz,k_z,k_z_loss\n5,800,80\n20,900,150\n100,1200,300\n";
  return "[elements.pad]\ntype = \"table\"\non = \"machine\"\nat = [0, 0, 0]\naxis = \"z\"\nfile = '" + file + "'\n";
}

TEST(MapMarks, MarksCasesThatAreDesignsOfTheMap) {
  const project::Project project = test::project(
      mapped_machine("map = {" + two_axes + ", no_peak = \"coordinates\"}\n",
                     "[cases.stiff]\nelements.spring.scale = 1.5\nelements.spring.damping.proportional = 0.1\n"
                     "[cases.nominal]\nelements.spring.scale = 1.5\nelements.spring.damping = {proportional = 0.1, of "
                     "= \"nominal\"}\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  ASSERT_EQ(map.marks.size(), 3u);
  EXPECT_EQ(map.marks[0].name, "");  // the file has no scale, so it is 1
  EXPECT_DOUBLE_EQ(*map.marks[0].x, 1);
  EXPECT_TRUE(map.marks[0].of_this_model);
  EXPECT_TRUE(map.marks[1].of_this_model);
  EXPECT_FALSE(map.marks[2].of_this_model);  // it has another damping
}

TEST(MapMarks, JudgesAndPlacesCasesWithATableThatBeginsAboveOneRadianPerSecond) {
  const foundation::TemporaryFolder folder;
  const project::Project project = test::project(
      mapped_machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"1 mm\"}, band = [\"6 Hz\", \"50 Hz\"]}\n",
                     measured_pad(folder) +
                         "[cases.stiff]\nelements.spring.scale = 1.5\n[cases.heavy]\nelements.spring.scale = "
                         "1.2\nbodies.machine.mass = 20\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  ASSERT_EQ(map.marks.size(), 3u);
  for (const study::MapMark& mark : map.marks) EXPECT_TRUE(mark.judged) << mark.name << ": " << mark.failure;
  EXPECT_TRUE(map.marks[0].of_this_model);
  EXPECT_TRUE(map.marks[1].of_this_model);
  EXPECT_FALSE(map.marks[2].of_this_model);
}

/// Natural frequencies of 10⁷ and 10⁻⁶ rad/s.
TEST(MapMarks, DistinguishesModelsAtExtremeFrequencies) {
  for (const double stiffness : {1e15, 1e-11}) {
    std::string text = mapped_machine("map = {" + two_axes + ", no_peak = \"coordinates\"}\n",
                                      fmt::format(R"(
[cases.same]
elements.spring.scale = 1.5
[cases.heavier]
elements.spring.scale = 1.4
bodies.machine.mass = 10.001
[cases.stiffer]
elements.spring.scale = 1.3
elements.spring.translation = [{0}, {0}, {1}]
)",
                                                  stiffness, 1.001 * stiffness));
    const std::string usual = "translation = [1000, 1000, 1000]";
    text.replace(text.find(usual), usual.size(), fmt::format("translation = [{0}, {0}, {0}]", stiffness));
    const project::Project project = test::project(text);
    const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
    for (const study::MapMark& mark : map.marks)
      EXPECT_EQ(mark.of_this_model, mark.name.empty() || mark.name == "same") << mark.name << " " << stiffness;
  }
}

TEST(MapMarks, PlacesCasesWhoseTableBeginsAboveAllNaturalFrequencies) {
  const foundation::TemporaryFolder folder;
  const project::Project project =
      test::project(mapped_machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"1 mm\"}}\n",
                                   measured_pad(folder) + "[cases.stiff]\nelements.spring.scale = 1.5\n"));
  for (const study::MapMark& mark : study::design_map(project, project.base(), *project.base().analyses.map).marks)
    EXPECT_TRUE(mark.of_this_model) << mark.name;
}

}  // namespace map_marks_test
