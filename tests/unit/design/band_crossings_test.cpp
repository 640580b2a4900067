// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/design/crossings.h"
#include "trivet/study/map/design_map.h"

namespace band_crossings_test {

using namespace trivet;

/// Outcome for a natural frequency and the band 3 … 3.1; with the resonance in the band the margin is `there`.
design::DesignOutcome design(double omega, float there) {
  const bool below = omega < 3, inside = !below && omega <= 3.1;
  return {inside ? there : 5.0F, 0, static_cast<std::uint8_t>(inside), static_cast<std::uint16_t>(below)};
}

/// Crossings along a row of two designs with the natural frequency as a function of x.
design::BandCrossings crossings(const std::function<double(double)>& omega, float there) {
  const auto judge = [&](const std::vector<design::MapPlace>& places, const foundation::Progress&) {
    std::vector<design::DesignOutcome> outcomes;
    for (const design::MapPlace& p : places) outcomes.push_back(design(omega(p.x), there));
    return outcomes;
  };
  return design::band_crossings({2, 1}, {design(omega(0), there), design(omega(1), there)}, judge);
}

TEST(BandCrossings, AreFoundForRisingAndFallingFrequenciesWithAGridThatShowsThem) {
  for (const auto& omega : {std::function<double(double)>([](double x) { return 1 + 4.3 * x; }),
                            std::function<double(double)>([](double x) { return 9 - 7.7 * x; })}) {
    const design::BandCrossings found = crossings(omega, 0.5F);
    EXPECT_EQ(found.pairs, 1u);
    EXPECT_EQ(found.points[1], 0u);
    ASSERT_GT(found.points[0], 2u);
    bool met = false;
    for (std::size_t k = 0; k < found.points[0]; ++k)
      met = met || !design(omega(static_cast<double>(k) / static_cast<double>(found.points[0] - 1)), 0.5F).feasible();
    EXPECT_TRUE(met);
  }
}

TEST(BandCrossings, AreNotCountedIfTheyMeetTheLimit) {
  EXPECT_EQ(crossings([](double x) { return 1 + 4.3 * x; }, 1.2F).pairs, 0u);
}

TEST(BandCrossings, AreNotJudgedIfADesignIsInTheBand) {
  const design::JudgePlaces never = [](const std::vector<design::MapPlace>&,
                                       const foundation::Progress&) -> std::vector<design::DesignOutcome> {
    throw std::logic_error("asked");
  };
  for (const double omega : {1.0, 3.05, 5.0}) {
    EXPECT_EQ(design::band_crossings({2, 1}, {design(3.05, 2), design(omega, 2)}, never).pairs, 0u);
    EXPECT_EQ(design::band_crossings({1, 2}, {design(omega, 2), design(3.05, 2)}, never).pairs, 0u);
  }
}

TEST(BandCrossings, CountTwoDesignsOnceForSeveralFrequencies) {
  const auto pair = [](double x) {
    return design::DesignOutcome{x > 0.4 && x < 0.6 ? 0.5F : 5.0F, 0, 0, static_cast<std::uint16_t>(x < 0.5 ? 2 : 0)};
  };
  const auto judge = [&](const std::vector<design::MapPlace>& places, const foundation::Progress&) {
    std::vector<design::DesignOutcome> outcomes;
    for (const design::MapPlace& p : places) outcomes.push_back(pair(p.y));
    return outcomes;
  };
  EXPECT_EQ(design::band_crossings({1, 2}, {pair(0), pair(1)}, judge).pairs, 1u);
}

/// ω = 10 √scale rad/s passes a narrow band between the designs 1 and 1.5: computed by poles for a force, and by
/// separate designs for an unbalance of equal size there.
TEST(BandCrossings, GiveAWarningForALightlyDampedMachineOnly) {
  const std::string axes =
      "x = {parameter = \"elements.spring.scale\", from = 0.5, to = 4, points = 8}, y = {parameter = "
      "\"elements.spring.damping.proportional\", from = 1e-4, to = 2e-4, points = 3}";
  const std::string force = test::mapped_machine(
      "map = {" + axes + ", band = [\"11.17 rad/s\", \"11.19 rad/s\"], limits = {\"machine.z\" = \"0.5 m\"}}\n");
  std::string unbalance = force;
  unbalance.replace(unbalance.find("type = \"harmonic\""), 17,
                    "type = \"unbalance\"\naxis = \"x\"\nmass_eccentricity = 0.08");
  unbalance.erase(unbalance.find("force = ["), 19);
  for (const std::string& text : {force, unbalance}) {
    const auto mapped = [&](std::vector<std::string> settings) {
      settings.emplace_back("elements.spring.damping.proportional=0.005");  // between the two ranges
      const project::Project project = test::project(text, settings);
      return study::design_map(project, project.base(), *project.base().analyses.map);
    };
    const study::DesignMap light = mapped({});
    EXPECT_EQ(light.feasible_designs, 24u);
    EXPECT_EQ(light.band_crossings.pairs, 3u);
    EXPECT_EQ(light.warnings.list().size(), 1u);
    EXPECT_LT(mapped({"analyses.map.x.points=" + std::to_string(light.band_crossings.points[0])}).feasible_designs,
              3 * light.band_crossings.points[0]);
    const study::DesignMap heavy = mapped({"analyses.map.y.from=0.1", "analyses.map.y.to=0.2"});
    EXPECT_EQ(heavy.band_crossings.pairs, 0u);
    EXPECT_TRUE(heavy.warnings.list().empty());
  }
}

}  // namespace band_crossings_test
