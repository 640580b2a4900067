// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/coil_springs.h"
#include "support/matchers.h"
#include "trivet/elements/coil_dynamics.h"
#include "trivet/elements/coil_preload.h"
#include "trivet/foundation/invalid_input.h"

namespace coil_spring_test {

using namespace trivet;
using elements::CoilSpring;
using test::literature_spring;
using testing::HasSubstr;

/// Subjects of all errors, or of all warnings.
std::vector<std::string> subjects(const CoilSpring& spring, foundation::Severity severity, bool massive = false) {
  std::vector<std::string> result;
  const foundation::Problems problems = elements::check(spring, massive);
  for (const foundation::Problem& problem : problems.list())
    if (problem.severity == severity) result.push_back(problem.subject);
  return result;
}

TEST(CoilSpringCheck, APublishedSpringIsSound) {
  EXPECT_TRUE(elements::check(literature_spring(), true).list().empty());
}

TEST(CoilSpringCheck, AnEmptyDescriptionNamesEverythingMissing) {
  EXPECT_THAT(subjects({}, foundation::Severity::error, true),
              testing::ElementsAre("wire_diameter", "mean_diameter", "active_coils", "active_length", "youngs_modulus",
                                   "shear_modulus", "density"));
}

TEST(CoilSpringCheck, EveryViolatedBoundIsNamed) {
  const auto errors = [](auto change) {
    CoilSpring spring = literature_spring();
    change(spring);
    EXPECT_THROW((void)elements::stiffness(spring), foundation::InvalidInput);
    return subjects(spring, foundation::Severity::error);
  };
  using testing::ElementsAre;
  EXPECT_THAT(errors([](CoilSpring& s) { s.wire = elements::RoundWire{-1e-3}; }), ElementsAre("wire_diameter"));
  EXPECT_THAT(errors([](CoilSpring& s) { s.wire = elements::RectangularWire{1e-3, 0}; }), ElementsAre("wire_height"));
  EXPECT_THAT(errors([](CoilSpring& s) { s.mean_diameter = 2.9e-3; }), ElementsAre("mean_diameter")) << "index below 3";
  EXPECT_THAT(errors([](CoilSpring& s) { s.active_length = 7.5e-3; }), ElementsAre("active_length")) << "coils overlap";
  EXPECT_THAT(errors([](CoilSpring& s) { s.active_coils = 0.1; }), ElementsAre("active_coils"));
  EXPECT_THAT(errors([](CoilSpring& s) { s.shear_modulus = 0.6e11; }), ElementsAre("shear_modulus"))
      << "Poisson's ratio above a half";
  EXPECT_THAT(errors([](CoilSpring& s) { s.loss_factor = -0.1; }), ElementsAre("loss_factor"));
  EXPECT_THAT(errors([](CoilSpring& s) { s.dead_coils_k = -1; }), ElementsAre("dead_coils_k"));
  EXPECT_THAT(errors([](CoilSpring& s) { s.density = 0; }), ElementsAre("density"));
  EXPECT_THAT(errors([](CoilSpring& s) { s.start_angle = std::numeric_limits<double>::infinity(); }),
              ElementsAre("start_angle"));
}

TEST(CoilSpringCheck, UnusualProportionsWarn) {
  CoilSpring spring = literature_spring();
  spring.mean_diameter = 25e-3;
  spring.active_coils = 1.5;
  EXPECT_THAT(subjects(spring, foundation::Severity::warning), testing::ElementsAre("mean_diameter", "active_coils"));
  EXPECT_FALSE(elements::check(spring).has_errors());
}

TEST(CoilSpring, WithoutDensityItHasStiffnessButNoDynamics) {
  CoilSpring spring = literature_spring();
  spring.density = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(elements::stiffness(spring).allFinite());
  try {
    (void)elements::dynamic_stiffness(spring, 1.0);
    FAIL();
  } catch (const foundation::InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("density"));
  }
}

TEST(CoilSpring, TorsionConstantOfRectangles) {
  // Timoshenko and Goodier, table: J/(b h³) for side ratios 1, 2, 10.
  constexpr double printed = 5e-3, mm4 = 1e-12;  // three digits: half a unit of the last is 2e-3 of 0.229
  CoilSpring spring = literature_spring();
  for (const auto& [ratio, factor] : {std::pair{1.0, 0.1406}, {2.0, 0.229}, {10.0, 0.312}}) {
    spring.wire = elements::RectangularWire{1e-3, ratio * 1e-3};
    EXPECT_THAT(elements::wire_section(spring).torsion_constant, test::RelativelyNear(factor * ratio * mm4, printed))
        << ratio;
  }
}

TEST(CoilSpring, APivotedSeatCarriesNoMoment) {
  CoilSpring spring = literature_spring();
  spring.seat_n = spring.seat_k = elements::Seat::pivoted;
  const elements::Matrix12 k = elements::stiffness(spring);
  for (const int i : {3, 4, 9, 10}) EXPECT_EQ(k.row(i).cwiseAbs().maxCoeff(), 0);
  constexpr double round_off = 1e-12;  // the solution of four equations
  EXPECT_LE(std::abs(k(0, 0)), round_off * k(2, 2)) << "between two pivots only axial force and torsion are carried";
  EXPECT_GT(k(2, 2), 0);
  EXPECT_GT(k(5, 5), 0);
}

TEST(CoilSpring, DeadCoilsAddTheirMassAndHeight) {
  constexpr double round_off = 1e-9;  // some thousand operations along the wire
  CoilSpring spring = literature_spring();
  const double omega = 100, bare = elements::dynamic_stiffness(spring, omega)(8, 8);
  spring.dead_coils_k = 2;
  const double mass = 2 * 7900 * std::numbers::pi * 0.25e-6 * 2 * std::numbers::pi * 5e-3;
  EXPECT_NEAR(elements::dynamic_stiffness(spring, omega)(8, 8), bare - omega * omega * mass, round_off * bare);
  EXPECT_DOUBLE_EQ(elements::seat_distance(spring), spring.active_length + 2e-3);
}

TEST(CoilSpring, RepeatedLookupsOfFrequenciesAgree) {
  constexpr double resolution = 1e-12;  // the bisection ends within 1e-13 of a frequency
  const auto three = elements::natural_frequencies(literature_spring(), elements::SeatsHeld::both, 3);
  const auto ten = elements::natural_frequencies(literature_spring(), elements::SeatsHeld::both, 10);
  for (std::size_t i = 0; i < three.size(); ++i) EXPECT_NEAR(three[i], ten[i], resolution * ten[i]);
  EXPECT_THROW((void)elements::natural_frequencies(literature_spring(), elements::SeatsHeld::both, 0),
               foundation::InvalidInput);
}

TEST(CoilNaturalFrequencies, AreFoundIfTheSearchHitsOneExactly) {
  CoilSpring spring;
  spring.wire = elements::RoundWire{0.01};
  spring.mean_diameter = 0.08;
  spring.active_coils = 8;
  spring.active_length = 0.48;
  spring.youngs_modulus = 206e9;
  spring.shear_modulus = 79e9;
  spring.density = 7850;
  // The search meets the first frequency of the spring compressed by 24 mm exactly; the stiffness there is infinite.
  const auto first = [&](double compression) {
    return natural_frequencies(compressed_by(spring, compression).coil, elements::SeatsHeld::both, 1).front();
  };
  constexpr double second_difference = 1e-6;  // the square of the step, 4e-4 of the compression, is 2e-7
  EXPECT_NEAR(first(0.024) / (0.5 * (first(0.02399) + first(0.02401))), 1, second_difference);
}

}  // namespace coil_spring_test
