// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/peaks/axis_panels.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/peaks.h"

namespace response_test {

using namespace trivet;
constexpr double pi = std::numbers::pi;
constexpr double round_off = 1e-12;  // up to 80 operations on numbers up to 20

TEST(Phase, IsPlus180DegreesForNegativeRealValues) {
  EXPECT_EQ(response::phase({-1, 0.0}), pi);
  EXPECT_EQ(response::phase({-1, -0.0}), pi);
  EXPECT_EQ(response::phase({2, -0.0}), 0);
  EXPECT_LT(response::phase({1, -1}), 0) << "a lag is negative";
}

TEST(Phase, IsContinuousOverWholeTurns) {
  Eigen::VectorXcd values(80);
  for (int i = 0; i < 80; ++i) values(i) = std::polar(1.0, -0.2 * i);
  EXPECT_NEAR(response::continuous_phase(values)(79), -0.2 * 79, round_off);
}

std::string driven_chain(const std::string& analyses) {
  return test::chain({1, 1, 1}, {100, 100, 100, 0}, {0.2, 0.2, 0.2}) +
      "[excitations.f]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [1, 0, 0]\n" + analyses;
}

TEST(Phase, IsContinuousFromRestAtAFewFrequencies) {
  // A transfer function of a chain of three: each resonance passed without a zero turns the phase of m3 by −π.
  const auto project =
      test::project(driven_chain("[analyses]\nresponse = {at = [0.1, 30], of = [\"m3\"], phase = \"continuous\"}\n"));
  const auto results = study::case_results(project.base(), project.base().analyses);
  constexpr double lag_below = 0.01, lead_above = 0.2;  // [rad] by the damping, far from the resonances
  EXPECT_NEAR(results.response->phase[0](0), 0, lag_below);
  EXPECT_NEAR(results.response->phase[0](1), -3 * pi, lead_above);
}

TEST(AutomaticGrid, ContainsEveryPeakAndResolvesTheCurve) {
  constexpr double peak_position = 1e-6;  // a maximum is flat: its place is known to the root of the round-off, 1e-8
  constexpr double chord_error = 0.004;   // the grid allows 7e-4 at three places of an interval
  const auto project = test::project(driven_chain("[analyses]\nresponse = {band = [0, 30]}\npeaks = {}\n"));
  const auto results = study::case_results(project.base(), project.base().analyses);
  const auto& omega = results.response->curves.angular_frequency;
  EXPECT_LT(omega.size(), 1500u);
  for (const auto& peak : results.peaks->peaks.list) {
    const auto nearest = std::ranges::min(omega, [&](double a, double b) {
      return std::abs(a - peak.angular_frequency) < std::abs(b - peak.angular_frequency);
    });
    EXPECT_NEAR(nearest, peak.angular_frequency, peak_position * peak.angular_frequency) << "no peak is cut";
  }
  const auto dense =
      test::project(driven_chain("[analyses]\nresponse = {band = [0, 30], spacing = \"linear\", points = 20001}\n"));
  const auto truth = study::case_results(dense.base(), dense.base().analyses);
  for (std::size_t c = 0; c < 3; ++c) {
    const double top = results.response->curves.curves[c].value.cwiseAbs().maxCoeff();
    std::size_t k = 0;
    for (std::size_t i = 0; i < truth.response->curves.angular_frequency.size(); ++i) {
      const double w = truth.response->curves.angular_frequency[i];
      while (k + 2 < omega.size() && omega[k + 1] < w) ++k;
      const double share = (w - omega[k]) / (omega[k + 1] - omega[k]);
      const auto at = [&](std::size_t j) { return std::abs(results.response->curves.curves[c].value(to_index(j))); };
      EXPECT_NEAR((1 - share) * at(k) + share * at(k + 1),
                  std::abs(truth.response->curves.curves[c].value(to_index(i))), chord_error * top);
    }
  }
}

TEST(Grids, EndExactlyAtTheBand) {
  EXPECT_EQ(response::linear_grid({1, 2}, 3), (std::vector<double>{1, 1.5, 2}));
  const auto log = response::logarithmic_grid({1, 100}, 3);
  EXPECT_NEAR(log[1], 10, round_off);
  EXPECT_EQ(log.back(), 100);
}

TEST(AxisPanels, CoverTheAxisAndStayClearOfPoles) {
  constexpr double joint_round_off = 1e-9;                         // of sums over all panels
  constexpr double ratio = numerics::panel_ratio, rounded = 1e-4;  // radius over distance of the centre
  Eigen::VectorXcd poles(4);
  poles << std::complex<double>(-1e-6, 3), std::complex<double>(-1e-6, -3), std::complex<double>(-2, 40),
      std::complex<double>(-2, -40);
  const auto cover = numerics::cover_axis(poles);
  double end = 0;
  for (const auto& panel : cover.panels) {
    if (panel.at_infinity) {
      EXPECT_NEAR(1 / panel.radius, end, joint_round_off * end);
      continue;
    }
    EXPECT_NEAR(panel.centre - panel.radius, end, joint_round_off * panel.centre);
    end = panel.centre + panel.radius;
    EXPECT_LE(panel.radius,
              (ratio + rounded) * (poles.array() - std::complex<double>(0, panel.centre)).abs().minCoeff());
  }
  EXPECT_TRUE(cover.panels.back().at_infinity);
  EXPECT_TRUE(cover.poles_on_axis.empty());
}

TEST(AxisPanels, CoverTheAxisOfALoadThatIsUnboundedAtRestWithoutPoles) {
  const auto cover = numerics::cover_axis({}, {.unbounded_at_rest = true});
  EXPECT_GT(cover.lowest, 0);
  EXPECT_TRUE(std::isfinite(cover.panels.front().radius));
  EXPECT_TRUE(cover.panels.back().at_infinity);
}

TEST(AxisPanels, CoverTheAxisOfRigidBodyModesOnly) {
  const auto cover = numerics::cover_axis(Eigen::VectorXcd::Zero(12));
  EXPECT_GT(cover.lowest, 0);
  EXPECT_FALSE(cover.panels.front().at_infinity);
  EXPECT_TRUE(cover.panels.back().at_infinity);
}

TEST(Peaks, AFreeBodyMovesAndHasNone) {
  const auto project = test::project(
      "trivet = 1\n[bodies.b]\nmass = 10\nfree = [\"x\", \"y\"]\n[excitations.f]\ntype = \"harmonic\"\non = \"b\"\nat "
      "= [0, 0, 0]\nforce = [1, 0, 0]\n"
      "[analyses]\npeaks = {}\n");
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  ASSERT_EQ(results.peaks->peaks.curves.size(), 2u);
  EXPECT_FALSE(results.peaks->peaks.curves[0].vanishes);
  EXPECT_EQ(results.peaks->peaks.curves[0].peaks, 0);
  EXPECT_TRUE(results.peaks->peaks.curves[1].vanishes);
}

TEST(Static, RejectsAFreeSystemWithAReason) {
  const auto project = test::project(
      "trivet = 1\ngravity = [0, 0, -9.81]\n[bodies.b]\nmass = 1\nfree = [\"z\"]\n[analyses]\nstatic = {}\n");
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  EXPECT_FALSE(results.statics.has_value());
  ASSERT_EQ(results.failures.size(), 1u);
  EXPECT_THAT(results.failures[0], testing::HasSubstr("slide along z"));
}

TEST(Limits, AnUndampedResonanceAtTheEndOfTheBandExceedsThem) {
  for (const char* band : {"[0, 30]", "[30, 60]", "[0, 29.999]", "[30.001, 60]"}) {
    const auto project =
        test::project(test::chain({2}, {1800}, {}) +
                      "[excitations.f]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [1, 0, 0]\n" +
                      "[limits]\n\"m1.x\" = 1\n[analyses]\nresponse = {band = " + band + "}\n");
    EXPECT_FALSE(study::case_results(project.base(), project.base().analyses).limits[0].met) << band;
  }
}

TEST(Limits, AreMetByAnAmplitudeEqualToThem) {
  const auto project = test::project(
      driven_chain("[limits]\n\"m1.x\" = \"1 m\"\n[analyses]\nresponse = {band = [0, 1], of = [\"m1\"]}\n"));
  project::Analyses request = project.base().analyses;
  const double largest = study::case_results(project.base(), request).limits[0].in_band;
  for (const auto& [share, met] : {std::pair{1 - 1e-12, true}, {1 - 1e-6, false}}) {
    request.limits[0].amplitude = share * largest;
    EXPECT_EQ(study::case_results(project.base(), request).limits[0].met, met) << share;
  }
}

TEST(Limits, AreJudgedAtTheExactPeakWithinTheBand) {
  const auto project = test::project(
      driven_chain("[limits]\n\"m1.x\" = \"1 m\"\n[analyses]\nresponse = {band = [0, 1], of = [\"m1\"]}\n"));
  const auto limits = study::case_results(project.base(), project.base().analyses).limits;
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_TRUE(limits[0].met);
  EXPECT_GT(limits[0].anywhere, limits[0].in_band);
}

TEST(RelativeProminence, IsInfiniteOverAMinimumThatIsRoundOff) {
  response::Peak peak{.amplitude = 3, .prominence = 2};
  EXPECT_EQ(response::relative_prominence(peak), 2);
  peak.prominence = 3 - 1e-9;
  EXPECT_NEAR(response::relative_prominence(peak), 3e9, 3e9 * 1e-6);
  peak.prominence = 3 * (1 - 4e-16);
  EXPECT_TRUE(std::isinf(response::relative_prominence(peak)));
}

}  // namespace response_test
