// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/judging/read_project.h"
#include "trivet/results/design/map_json.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/study/map/design_map.h"

namespace design_evaluation_test {

using namespace trivet;
using test::mapped_machine;
using test::two_axes;

TEST(DesignEvaluation, ReportsWhyADesignHasNoModelAndContinues) {
  const project::Project project =
      test::project(mapped_machine("map = {x = {parameter = \"bodies.machine.mass\", from = -5, to = 15, points = 5}, "
                                   "y = {parameter = \"elements.spring.scale\", from = 1, to = 2, "
                                   "points = 2}, no_peak = \"coordinates\"}\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.unknown, 4u);  // −5 and 0 kg
  ASSERT_FALSE(map.report.missing.empty());
  EXPECT_THAT(map.report.missing.front().words, testing::HasSubstr("mass = -5 kg; a mass must be > 0"));
  EXPECT_FALSE(map.outcomes[0].feasible());
}

/// A body with an inertia that violates the triangle inequality, with different numbers in each design.
TEST(DesignEvaluation, GroupsDesignsWithoutAModelByKind) {
  const project::Project project =
      test::project(test::mapped_block("{parameter = \"bodies.block.inertia.xx\", from = 1, to = 9, points = 9}",
                                       "{parameter = \"bodies.block.mass\", from = -10, to = 20, points = 7}"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  std::size_t missing = 0;
  for (const design::MissingReason& reason : map.report.missing) missing += reason.designs;
  EXPECT_EQ(missing, map.unknown);
  EXPECT_GT(map.unknown, 20u);
  EXPECT_LE(map.report.missing.size(), 3u);
}

TEST(DesignEvaluation, JudgesDesignsWithLossFactorsByPolesAndResidues) {
  const std::string text = mapped_machine(
      "map = {x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 3}, y = {parameter = "
      "\"bodies.machine.mass\", from = 5, to = 20, points = 3}, "
      "no_peak = \"coordinates\"}\n");
  const project::Project project = test::project(text, {"elements.spring.damping={loss_factor=0.1}"});
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.report.proven, 9u);
  EXPECT_EQ(map.report.assembled_separately, 0u);
}

/// With heavy damping the acceleration rises to F/m = 1 m/s² in every design, and reaches it only at infinity.
TEST(DesignEvaluation, MeetsALimitThatEveryDesignReachesExactly) {
  const project::Project project =
      test::project(mapped_machine("map = {x = {parameter = \"elements.spring.scale\", from = 0.5, to = 4, points = "
                                   "15}, y = {parameter = \"elements.spring.damping.proportional\", from = "
                                   "0.3, to = 0.9, points = 13}, limits = {\"machine.z\" = \"1 m/s2\"}}\n",
                                   "[cases.heavy]\nelements.spring.damping.proportional = 0.5\n"));
  for (const bool fast : {true, false}) {
    const study::DesignMap map =
        study::design_map(project, project.base(), *project.base().analyses.map, {0, 0, {0, fast}});
    EXPECT_EQ(map.feasible_designs, map.outcomes.size());
    for (const design::DesignOutcome& outcome : map.outcomes) EXPECT_EQ(outcome.margin, 1);
    EXPECT_THAT(results::verdict_words(map, map.marks.at(1)),
                testing::ElementsAre("least margin 1: machine.z ≤ 1 m/s² 0-p"));
  }
}

/// Displacements under a constant acceleration of the ground grow towards ω = 0. No kernel for many designs has such
/// curves.
std::string machine_on_moving_ground(const std::string& cases = "") {
  return mapped_machine(
      "map = {" + two_axes + ", limits = {\"machine.z\" = \"65 mm\"}, band = [6, 30]}\n",
      "[excitations.ground]\ntype = \"base\"\nquantity = \"acceleration\"\ntranslation = [0, 0, 2]\n" + cases);
}

TEST(DesignEvaluation, ReportsThatResultsGrowWithoutBound) {
  const project::Project project = test::project(machine_on_moving_ground());
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.report.assembled_separately, 20u);
  EXPECT_THAT(map.report.summary(), testing::HasSubstr("machine.z grows without bound"));
}

/// Accelerations on a ground that moves through dampers grow with ω, but not beyond a band that ends.
TEST(DesignEvaluation, ResultsThatGrowBeyondTheBandAreJudgedByTheFamily) {
  const project::Project project =
      test::project(mapped_machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"2 m/s2\"}, band = [0, 30]}\n",
                                   "[excitations.ground]\ntype = \"base\"\ntranslation = [0, 0, 1e-3]\n"));
  std::vector<std::vector<design::DesignOutcome>> outcomes;
  for (const bool fast : {true, false}) {
    const study::DesignMap map =
        study::design_map(project, project.base(), *project.base().analyses.map, {0, 0, {0, fast}});
    if (fast) {
      EXPECT_GT(map.report.proven, 15u);
    }
    outcomes.push_back(map.outcomes);
  }
  constexpr double single_precision = 1e-6;
  for (std::size_t i = 0; i < outcomes[0].size(); ++i)
    EXPECT_NEAR(outcomes[0][i].margin, outcomes[1][i].margin, single_precision * outcomes[1][i].margin) << i;
}

/// Eighteen coordinates, more than kernels have lanes for; no design is assembled.
TEST(DesignEvaluation, JudgesThreeBodiesWithViscousDampingWithoutTheirModels) {
  std::string text = "trivet = 1\n";
  for (int body = 0; body < 3; ++body) {
    text +=
        fmt::format("[bodies.b{0}]\nmass = {1}\ninertia = {{about = \"center_of_mass\", xx = 1, yy = 2, zz = 1.5}}\n",
                    body, 10 + body);
    text += fmt::format(
        "[elements.e{0}]\ntype = \"bushing\"\non = \"b{0}\"\n{1}at = [0, 0.1, 0]\ntranslation = [900, 1100, 1300]\n"
        "rotation = [90, 80, 70]\ndamping = {{translation = [3, 4, 5], rotation = [1, 1, 1]}}\n",
        body, body > 0 ? fmt::format("from = \"b{}\"\n", body - 1) : "");
  }
  text +=
      "[excitations.force]\ntype = \"harmonic\"\non = \"b2\"\nat = [0, 0, 0.1]\nforce = [1, 0, 2]\n[analyses.map]\n"
      "x = {parameter = \"elements.e0.scale\", from = 0.5, to = 2, points = 3}\n"
      "y = {parameter = \"bodies.b1.mass\", from = 8, to = 16, points = 3}\nlimits = {\"b2.z\" = \"30 mm\"}\n"
      "no_peak = \"b0.x\"\n";
  const project::Project project = test::project(text);
  std::vector<std::vector<design::DesignOutcome>> outcomes;
  for (const bool fast : {true, false}) {
    const study::DesignMap map =
        study::design_map(project, project.base(), *project.base().analyses.map, {0, 0, {0, fast}});
    EXPECT_EQ(map.report.assembled_separately, fast ? 0u : 9u) << map.report.no_family;
    outcomes.push_back(map.outcomes);
  }
  constexpr double single_precision = 1e-6;
  for (std::size_t i = 0; i < outcomes[0].size(); ++i) {
    EXPECT_EQ(outcomes[0][i].governing, outcomes[1][i].governing) << i;
    EXPECT_NEAR(outcomes[0][i].margin, outcomes[1][i].margin, single_precision * outcomes[1][i].margin) << i;
  }
}

TEST(DesignEvaluation, CountsDesignsByTheMethodThatJudgedThem) {
  const project::Project project = *judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/map.toml");
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map, {30, 30, {}});
  EXPECT_EQ(map.report.proven + map.report.fallback + map.report.assembled_separately, 900u);
  EXPECT_GT(map.report.proven, 800u);
}

TEST(DesignEvaluation, IsTheSameOnAnyNumberOfThreadsAndReportsProgress) {
  std::string cases;
  for (int k = 0; k < 12; ++k) cases += fmt::format("[cases.c{}]\nelements.spring.scale = {}\n", k, 0.6 + 0.1 * k);
  const project::Project project = test::project(machine_on_moving_ground(cases));
  std::vector<std::string> tasks, texts;
  const foundation::Progress progress = [&](std::string_view task, double) { tasks.emplace_back(task); };
  for (const int threads : {1, 4}) {
    const study::DesignMap map =
        study::design_map(project, project.base(), *project.base().analyses.map, {0, 0, {threads, true}}, progress);
    EXPECT_EQ(map.report.assembled_separately, 20u);
    std::string text;
    results::write_map_json(map, {}, [&](std::string_view piece) { text += piece; });
    texts.push_back(text);
  }
  EXPECT_EQ(texts[0], texts[1]);
  for (const char* task : {"designs", "boundary", "cases"}) EXPECT_THAT(tasks, testing::Contains(task));
  EXPECT_GE(std::ranges::count(tasks, "designs"), 20);  // with one thread, after each design
}

}  // namespace design_evaluation_test
