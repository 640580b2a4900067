// SPDX-License-Identifier: BSD-3-Clause
// The explanation of a peak of one mass, in closed form: ω0 = √(k/m), |y| = F/(kη).
#include "trivet/study/explain/explanation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "support/matchers.h"
#include "support/projects.h"

namespace explanation_test {

using namespace trivet;
using test::RelativelyNear;
constexpr double digits = 1e-8;      // of a peak's frequency: a maximum is flat
constexpr double round_off = 1e-12;  // of an undamped natural frequency and its slope

const std::string force = "[excitations.f]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [5, 0, 0]\n";

study::Explanation one_mass(double loss) {
  return study::explanation(test::project(test::chain({2}, {1800}, {}, {loss}) + force).base());
}

const response::Sensitivity& sensitivity(const study::Explanation& explanation, const std::string& parameter) {
  for (const response::Sensitivity& s : explanation.peaks.at(0).sensitivities)
    if (explanation.parameters[s.parameter].name == parameter) return s;
  throw std::out_of_range(parameter);
}

TEST(Explanation, HasTheKnownSlopesForOneMass) {
  const study::Explanation explanation = one_mass(0.1);
  ASSERT_EQ(explanation.peaks.size(), 1u);
  struct Known {
    const char* parameter;
    double height, frequency;
  };
  for (const Known& known : {Known{"elements.k1.scale", -1, 0.5}, Known{"elements.k1.stiffness_factor.x", -1, 0.5},
                             Known{"elements.k1.damping_factor", -1, 0}, Known{"bodies.m1.mass", 0, -0.5},
                             Known{"elements.k1.moved.x", 0, 0}}) {
    EXPECT_NEAR(*sensitivity(explanation, known.parameter).height, known.height, digits) << known.parameter;
    EXPECT_NEAR(*sensitivity(explanation, known.parameter).frequency, known.frequency, digits) << known.parameter;
  }
}

TEST(Explanation, RecomputesThePeakWithTenPercentMore) {
  const study::ExplainedPeak peak = one_mass(0.1).peaks.at(0);
  ASSERT_TRUE(peak.trial.has_value());
  EXPECT_EQ(peak.trial->parameter, "elements.k1.stiffness_factor.x");
  EXPECT_THAT(*peak.trial->angular_frequency, RelativelyNear(30 * std::sqrt(1.1), digits));
  EXPECT_THAT(*peak.trial->amplitude, RelativelyNear(5 / 180.0 / 1.1, digits));
  EXPECT_THAT(*peak.trial->predicted_angular_frequency, RelativelyNear(30 * 1.05, digits));
  EXPECT_THAT(*peak.trial->predicted_amplitude, RelativelyNear(5 / 180.0 * 0.9, digits));
}

TEST(Explanation, StatesItInWords) {
  EXPECT_EQ(
      words_in_si(one_mass(0.1).peaks.at(0).sentence),
      "m1.x: 27.78 mm at 30 rad/s (4.775 Hz). Mode 1, translation along x, contributes 100 % of it. 100 % of the "
      "strain energy is in \"k1\", 100 % in its stiffness along x; \"k1\" dissipates 100 % of the power. +10 % on "
      "the stiffness along x of \"k1\" moves the peak to 31.46 rad/s (5.008 Hz) and 25.25 mm (recomputed; to first "
      "order 31.5 rad/s (5.013 Hz) and 25 mm). Its height is most sensitive to elements.k1.scale: +1 % gives -1 %.");
}

TEST(Explanation, HasNoHeightForAnUnboundedPeak) {
  const study::Explanation explanation = one_mass(0);
  ASSERT_EQ(explanation.peaks.size(), 1u);
  EXPECT_FALSE(sensitivity(explanation, "elements.k1.scale").height.has_value());
  EXPECT_THAT(*sensitivity(explanation, "bodies.m1.mass").frequency, RelativelyNear(-0.5, round_off));
  EXPECT_THAT(words_in_si(explanation.peaks[0].sentence), testing::StartsWith("m1.x: unbounded at 30 rad/s"));
  EXPECT_THAT(explanation.peaks[0].notes, testing::ElementsAre(testing::HasSubstr("no height")));
}

TEST(Explanation, ChoosesTheTallestPeaks) {
  const auto project = test::project(test::chain({1, 1, 1}, {1000, 1000, 1000}, {}, {0.02, 0.02, 0.02}) + force);
  const study::Explanation all = study::explanation(project.base(), {{"m1.x"}, 10});
  const study::Explanation one = study::explanation(project.base(), {{"m1.x"}, 1});
  ASSERT_EQ(all.peaks.size(), 3u);
  ASSERT_EQ(one.peaks.size(), 1u);
  EXPECT_EQ(one.left_out, 2);
  for (const study::ExplainedPeak& peak : all.peaks) EXPECT_LE(peak.peak.amplitude, one.peaks[0].peak.amplitude);
}

TEST(ValueWords, HaveTheUsualPrefix) {
  EXPECT_EQ(study::value_words(0.0084, "m"), "8.4 mm");
  EXPECT_EQ(study::value_words(3.5e-5, "rad"), "35 µrad");
  EXPECT_EQ(study::value_words(1250, "N"), "1.25 kN");
  EXPECT_EQ(study::value_words(2.5e6, "N m"), "2.5 MN m");
  EXPECT_EQ(study::value_words(1250, "m/s²"), "1250 m/s²");
  EXPECT_EQ(study::value_words(-0.5, "m"), "-500 mm");
  EXPECT_EQ(study::value_words(0, "N"), "0 N");
  EXPECT_EQ(study::value_words(3e-9, "m"), "3 nm");
}

}  // namespace explanation_test
