// SPDX-License-Identifier: BSD-3-Clause
// Limit lines and load sharing of simple systems against closed forms.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/guided_mass.h"
#include "support/matchers.h"
#include "support/solved_system.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/response/machinery/load_sharing.h"

namespace limit_line_test {

using namespace trivet;
using test::RelativelyNear;
constexpr double round_off = 1e-10;    // solves of one coordinate, with roots and heights from them
constexpr double flat_minimum = 1e-7;  // the place of a minimum that values alone enclose: root of round-off

response::LimitComparison velocity_of_mass(const assembly::LimitLine& line, const assembly::Band& band,
                                           double ratio = 0.05) {
  model::Description d = test::guided_mass(2, 30, ratio);
  d.excitations = {test::vertical_force("push", 0, 5)};
  const test::SolvedSystem solved(d);
  const auto channels = solved.channels({"machine"}, assembly::MotionQuantity::velocity);
  const auto loading = assembly::harmonic_loading(solved.system, solved.assembled);
  return response::compared_with_limit(solved.assembled, channels[0], loading, solved.roots.poles,
                                       solved.peaks(channels, loading), line, band);
}

TEST(LimitLine, IsExceededBetweenTheRootsOfTheClosedForm) {
  // |v| = F ω/|k − mω² + iωc| = L where k − mω² = ±ω√(F²/L² − c²).
  constexpr double mass = 2, natural = 30, force = 5, limit = 0.2, dashpot = 2 * 0.05 * mass * natural,
                   stiffness = mass * natural * natural;
  const double s = std::sqrt(force * force / (limit * limit) - dashpot * dashpot),
               root = std::sqrt(s * s + 4 * stiffness * mass);
  for (const bool rms : {false, true}) {
    const assembly::LimitLine line{
        "flat",
        "m/s",
        rms,
        {1, 1000},
        {rms ? limit / std::numbers::sqrt2 : limit, rms ? limit / std::numbers::sqrt2 : limit}};
    const auto found = velocity_of_mass(line, {2, 200});
    ASSERT_EQ(found.exceeded.size(), 1u);
    EXPECT_FALSE(found.met());
    EXPECT_THAT(found.exceeded[0].from, RelativelyNear((root - s) / (2 * mass), round_off));
    EXPECT_THAT(found.exceeded[0].to, RelativelyNear((root + s) / (2 * mass), round_off));
    EXPECT_THAT(found.least_margin, RelativelyNear(limit * dashpot / force, round_off));
    EXPECT_THAT(found.least_margin_at, RelativelyNear(natural, flat_minimum));
    EXPECT_THAT(found.compared.from, 2);
    EXPECT_THAT(found.compared.to, 200);
  }
}

TEST(LimitLine, FallingWithFrequencyLimitsTheDisplacement) {
  // v/(L ω0/ω) = ω² F/(L ω0 |Z|): least margin at the peak of acceleration ω0/√(1 − 2ζ²).
  constexpr double mass = 2, natural = 30, force = 5, ratio = 0.3;
  const assembly::LimitLine line{"falling", "m/s", false, {3, 300}, {10 * 1.0, 0.1 * 1.0}};  // 30/ω
  const auto found = velocity_of_mass(line, {1, 1000}, ratio);
  EXPECT_EQ(found.compared.from, 3);
  EXPECT_EQ(found.compared.to, 300);
  EXPECT_TRUE(found.met());
  EXPECT_THAT(found.least_margin_at, RelativelyNear(natural / std::sqrt(1 - 2 * ratio * ratio), flat_minimum));
  EXPECT_THAT(found.least_margin,
              RelativelyNear(30 * mass * 2 * ratio * std::sqrt(1 - ratio * ratio) / force, round_off));
  EXPECT_THAT(response::margin_level(found.least_margin),
              RelativelyNear(20 * std::log10(found.least_margin), round_off));
}

TEST(LimitLine, FindsTheLeastMarginBesideANarrowPeak) {
  // As above, with a peak of a millionth of its frequency: where grid points are as close as that.
  constexpr double mass = 2, natural = 30, force = 5, ratio = 1e-6;
  const assembly::LimitLine line{"falling", "m/s", false, {3, 300}, {10, 0.1}};  // 30/ω
  const auto found = velocity_of_mass(line, {1, 1000}, ratio);
  EXPECT_THAT(found.least_margin,
              RelativelyNear(30 * mass * 2 * ratio * std::sqrt(1 - ratio * ratio) / force, round_off));
  // The line moves the minimum by ζ² of the frequency, a millionth of the width of the peak, which is the scale here.
  EXPECT_THAT(found.least_margin_at, RelativelyNear(natural / std::sqrt(1 - 2 * ratio * ratio), flat_minimum * ratio));
}

TEST(LimitLine, HasItsLowerValueAtAStep) {
  const assembly::LimitLine line{"step", "m/s", false, {1, 35, 35, 1000}, {10, 10, 0.1, 0.1}};
  EXPECT_EQ(response::zero_to_peak_limit(line, 35), 0.1);
  EXPECT_EQ(response::zero_to_peak_limit(line, 34), 10);
  EXPECT_EQ(response::zero_to_peak_limit({"step up", "m/s", false, {1, 35, 35, 1000}, {0.1, 0.1, 10, 10}}, 35), 0.1);
  EXPECT_THROW((void)response::zero_to_peak_limit(line, 0.5), foundation::InvalidInput);
  const auto found = velocity_of_mass(line, {1, 1000});
  ASSERT_EQ(found.exceeded.size(), 1u);
  EXPECT_EQ(found.exceeded[0].from, 35);
  EXPECT_GT(found.exceeded[0].to, 35);
}

TEST(LimitLine, ContinuesAcrossAPointBetweenTwoPieces) {
  const assembly::LimitLine line{"kink", "m/s", false, {1, 30, 1000}, {0.2, 0.2, 0.2}};
  EXPECT_EQ(velocity_of_mass(line, {2, 200}).exceeded.size(), 1u);
}

TEST(LimitLine, HasNoMarginAtAnUndampedResonance) {
  const auto found = velocity_of_mass({"flat", "m/s", true, {1, 1000}, {100, 100}}, {2, 200}, 0);
  EXPECT_EQ(found.least_margin, 0);
  EXPECT_THAT(found.least_margin_at, RelativelyNear(30.0, round_off));
  ASSERT_EQ(found.exceeded.size(), 1u);
  EXPECT_LT(found.exceeded[0].from, 30);
  EXPECT_GT(found.exceeded[0].to, 30);
}

TEST(LimitLine, ReportsAllErrorsOfItsTable) {
  const assembly::LimitLine line{"bad", "m/s", true, {-1, 5, 4, 4, 4}, {1, 0, std::nan(""), 1, 1}};
  EXPECT_EQ(assembly::check(line, "limits.bad").errors(), 5u);
  EXPECT_EQ(assembly::check({"short", "m", true, {1}, {1}}, "limits").errors(), 1u);
  EXPECT_EQ(assembly::check({"nowhere", "m", true, {1, 1}, {1, 2}}, "limits").errors(), 1u);
  EXPECT_THROW(velocity_of_mass({"unlike", "m", true, {1, 1000}, {1, 1}}, {2, 200}), foundation::InvalidInput);
  EXPECT_THROW(velocity_of_mass({"elsewhere", "m/s", true, {300, 1000}, {1, 1}}, {2, 200}), foundation::NotComputable);
}

TEST(LoadSharing, FollowsTheLever) {
  // Centre of mass at a quarter of the span: three quarters on the near mount.
  model::Description d;
  d.bodies = {test::guided_body("beam", 100)};
  d.bodies[0].has_inertia = true;
  d.bodies[0].free = {false, false, true, false, true, false};
  d.bodies[0].mass.centre = {0.25, 0, 0.1};
  d.bodies[0].mass.inertia_about_centre = Eigen::Vector3d(3, 12, 12).asDiagonal();
  d.elements = {test::vertical_spring("near", {}, 0, 2e5, 0, 0), test::vertical_spring("far", {}, 0, 1e5, 0, 1)};
  d.gravity = Eigen::Vector3d(0, 0, -9.80665);
  const model::System system = test::checked(d);
  const response::LoadSharing found = response::load_sharing(system, assembly::assemble(system));
  ASSERT_EQ(found.mounts.size(), 2u);
  EXPECT_THAT(found.bearing_in_total, RelativelyNear(980.665, round_off));
  EXPECT_THAT(found.mounts[0].share, RelativelyNear(0.75, round_off));
  EXPECT_THAT(found.mounts[1].share, RelativelyNear(0.25, round_off));
  EXPECT_THAT(found.mounts[0].force.z(), RelativelyNear(-735.49875, round_off));
  EXPECT_THAT(found.mounts[0].deflection(2), RelativelyNear(-735.49875 / 2e5, round_off));
  EXPECT_THAT(found.mounts[1].deflection(2), RelativelyNear(-245.16625 / 1e5, round_off));
  d.gravity.reset();
  const model::System weightless = test::checked(d);
  EXPECT_THROW((void)response::load_sharing(weightless, assembly::assemble(weightless)), foundation::NotComputable);
}

}  // namespace limit_line_test
