// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/results/design/map_json.h"
#include "trivet/study/map/design_map.h"

namespace map_json_test {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

TEST(DesignMap, WritesOneCsvRowPerDesign) {
  const project::Project project =
      test::project(mapped_machine("map = {" + two_axes + ", no_peak = \"coordinates\"}\n"));
  const std::string csv = results::map_csv(study::design_map(project, project.base(), *project.base().analyses.map));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 21);
  EXPECT_THAT(csv,
              testing::StartsWith(
                  "elements.spring.scale,elements.spring.damping.proportional [s],margin,governing,kept\n0.5,0.01,"));
}

}  // namespace map_json_test
