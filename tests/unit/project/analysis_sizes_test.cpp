// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_sizes.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "support/projects.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/text/admissible_range.h"

namespace analysis_sizes_test {

using namespace trivet;
using testing::HasSubstr;

/// Free bodies one above the other, each on one mount.
model::Description tower(std::size_t count) {
  model::Description description;
  for (std::size_t i = 0; i < count; ++i) description.bodies.emplace_back().name = fmt::format("body {}", i);
  return description;
}

std::string messages(const foundation::Problems& problems) {
  std::string text;
  for (const foundation::Problem& problem : problems.list()) text += foundation::message(problem) + "\n";
  return text;
}

TEST(AnalysisSizes, AtMostThreeHundredFreeBodiesAreAccepted) {
  project::Analyses modes;
  modes.modes = true;
  EXPECT_FALSE(project::too_large(tower(300), modes).has_errors());
  EXPECT_THAT(messages(project::too_large(tower(301), modes)),
              HasSubstr("1806 free coordinates; at most 1800 are computed"));
}

TEST(AnalysisSizes, InnerCoordinatesOfElementsCount) {
  model::Description machine = tower(1);
  model::Element& mount = machine.elements.emplace_back();
  mount.k.body = 0;
  elements::Vector6 k;
  k << 1e5, 2e5, 3e5, 1e3, 2e3, 3e3;
  mount.law.nominal_stiffness = elements::constants_at_point(k, Eigen::Vector3d::Zero(), 1);
  elements::GeneralizedMaxwell branches;
  for (int i = 0; i < 100; ++i) {
    branches.ratios.push_back(0.01);
    branches.times.push_back(0.001 * (i + 1));
  }
  mount.law.damping = elements::Viscoelastic{branches};
  EXPECT_EQ(project::coordinates(machine), 6u + 600u);
}

TEST(AnalysisSizes, AllPeaksAreAcceptedButCurvesOfTwoHundredBodiesAreNot) {
  project::Analyses peaks, response;
  peaks.peaks.emplace();
  response.response.emplace();
  EXPECT_FALSE(project::too_large(tower(300), peaks).has_errors());
  EXPECT_FALSE(project::too_large(tower(100), response).has_errors());
  EXPECT_THAT(messages(project::too_large(tower(200), response)),
              HasSubstr("resonance peaks of 1200 curves of a system of 1200 coordinates: about 1.3 hours of search"));
}

TEST(AnalysisSizes, PointsTimesCurvesHaveALimit) {
  project::Analyses request;
  request.response.emplace().spacing = project::Spacing::linear;
  request.response->points = 500'000;
  EXPECT_FALSE(project::too_large(tower(1), request).has_errors());
  request.response->points = 500'001;
  EXPECT_THAT(messages(project::too_large(tower(1), request)), HasSubstr("500001 points × 6 curves"));
  request.response->selection.of = {"body 0.x"};
  EXPECT_FALSE(project::too_large(tower(1), request).has_errors());
}

TEST(AnalysisSizes, TheSecondSolverChecksFewerFrequenciesOfLargeSystems) {
  EXPECT_EQ(project::deep_check_frequencies(6), 64);
  EXPECT_EQ(project::deep_check_frequencies(36), 64);
  EXPECT_EQ(project::deep_check_frequencies(72), 8);
  EXPECT_EQ(project::deep_check_frequencies(600), 4);
}

TEST(AnalysisSizes, AreReportedWithTheLineOfTheAnalysis) {
  const std::string text =
      "trivet = 1\n[bodies.b]\nmass = 1\ninertia = {about = \"pole\", xx = 1, yy = 1, zz = 1}\n[elements.m]\ntype = "
      "\"bushing\"\non = \"b\"\nat = [0, 0, 0]\n"
      "translation = [1, 1, 1]\n[excitations.f]\ntype = \"harmonic\"\non = \"b\"\nat = [0, 0, 0]\nforce = [0, 0, "
      "1]\n[analyses]\nresponse = {spacing = \"linear\", points = 2000000}\n";
  const auto refused = judging::project_from_text(text, "machine.toml");
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(messages(refused.error()),
              HasSubstr("machine.toml:16: error: analyses.response.points: 2000000 points × 6 curves"));
}

TEST(AdmissibleRange, HasAReasonForEveryQuantity) {
  for (int i = 0; i <= static_cast<int>(project::Quantity::mass_length); ++i) {
    const auto quantity = static_cast<project::Quantity>(i);
    EXPECT_GT(std::string(project::largest(quantity).reason).size(), 5u) << i;
    EXPECT_EQ(project::outside_range(project::largest(quantity).magnitude, quantity), std::nullopt) << i;
    EXPECT_NE(project::outside_range(-1.001 * project::largest(quantity).magnitude, quantity), std::nullopt) << i;
    EXPECT_EQ(project::outside_range(0, quantity), std::nullopt);
    EXPECT_NE(project::outside_range(5e-324, quantity), std::nullopt);
  }
}

TEST(AdmissibleRange, ABandHasTwoDifferentEnds) {
  EXPECT_EQ(project::wrong_band(0, 1), std::nullopt);
  EXPECT_EQ(project::wrong_band(1, 1.00000001), std::nullopt);
  EXPECT_NE(project::wrong_band(1, 1.0000000000000002), std::nullopt);
  EXPECT_NE(project::wrong_band(0, 1e-300), std::nullopt);
  EXPECT_NE(project::wrong_band(2, 1), std::nullopt);
}

}  // namespace analysis_sizes_test
