// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/modes/backbone.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"

/// Nonlinear modes against shooting and closed forms.
namespace backbone_test {

using namespace trivet;
using nonlinear::Backbone;
using nonlinear::BackbonePoint;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

model::System with_law(const std::string& text, elements::ScalarLaw law) {
  model::Description description = test::project(text).base().system.description();
  description.elements[0].nonlinear_parts = {{0, 0.5, {std::move(law)}}};
  return model::System::checked(description).value();
}

/// Kerschen et al. 2009: two masses of 1 kg, three springs of 1 N/m, 0.5 N/m³ on the first.
model::System two_masses() {
  return with_law(test::chain({1, 1}, {1, 1, 1}, {0, 0, 0}),
                  elements::ElasticForce(elements::PolynomialForce{{0, 0, 0.5}}));
}

struct Row {
  double energy, omega, first, second;
};

void expect_rows(Eigen::Index mode, const std::vector<Row>& rows) {
  nonlinear::BackboneOptions options{.mode = mode, .up_to_energy = 60, .harmonics = 15};
  options.of = {"m1.x", "m2.x"};
  for (const Row& row : rows) options.at_energy.push_back(row.energy);
  const Backbone found = nonlinear::backbone(two_masses(), options);
  EXPECT_EQ(found.ended, "");
  ASSERT_EQ(found.at_energy.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE(rows[i].energy);
    const BackbonePoint& point = found.at_energy[i];
    const double sign = point.coordinates.row(0).real().sum() < 0 ? -1 : 1;
    EXPECT_THAT(point.angular_frequency, RelativelyNear(rows[i].omega, 1e-7));
    EXPECT_THAT(sign * point.coordinates.row(0).real().sum(), RelativelyNear(rows[i].first, 1e-6));
    EXPECT_THAT(sign * point.coordinates.row(1).real().sum(), RelativelyNear(rows[i].second, 1e-6));
  }
}

TEST(Backbone, ModesOfTwoMassesAgreeWithShooting) {
  expect_rows(0,
              {{0.01, 1.000933299, 0.0998546939, 0.1000207854},
               {0.1, 1.008974049, 0.3117761362, 0.316871436},
               {1, 1.06590677, 0.8907520415, 1.016539202},
               {2, 1.1035323, 1.162024599, 1.452424927},
               {5, 1.162521779, 1.569653277, 2.33187079},
               {10, 1.206905474, 1.90339788, 3.327011668},
               {20, 1.246668081, 2.258411399, 4.724048579},
               {50, 1.29008878, 2.77703734, 7.453318943}});
  expect_rows(1,
              {{0.1, 1.733868549, 0.1830333381, -0.1818581771},
               {1, 1.751501176, 0.5920349664, -0.5535495797},
               {5, 1.859860153, 1.443043595, -0.9802958417},
               {10, 2.029585827, 2.113646733, -0.981448151},
               {20, 2.309019099, 2.877975983, -0.8440923865},
               {50, 2.812313984, 3.974261172, -0.652881307}});
}

/// Near 1:3 the in-phase mode turns in energy: a program that raises energy or amplitude would stop there.
TEST(Backbone, GoesThroughTheInternalResonance) {
  nonlinear::BackboneOptions options{.mode = 0, .up_to_energy = 5500, .harmonics = 21};
  const Backbone found = nonlinear::backbone(two_masses(), options);
  std::vector<const BackbonePoint*> turns;
  for (std::size_t i = 1; i + 1 < found.points.size(); ++i)
    if ((found.points[i].energy > found.points[i - 1].energy) != (found.points[i + 1].energy > found.points[i].energy))
      turns.push_back(&found.points[i]);
  ASSERT_GE(turns.size(), 2u);
  constexpr double between_points = 0.03;  // the turning point is the highest point of the branch, not located
  EXPECT_THAT(turns[0]->energy, RelativelyNear(4661.4, between_points));
  EXPECT_THAT(turns[0]->angular_frequency, RelativelyNear(1.4045, 0.002));
}

/// T = 2 (π − acos(g/a))/ω₁ + 2 acos((g − x_c)/B)/ω₂.
TEST(Backbone, MassAgainstAStopHasThePeriodOfItsTwoArcs) {
  const double m = 1, k = 10, stop = 50, g = 0.01;
  const model::System system = with_law(test::chain({m}, {k, 0}, {0, 0}),
                                        elements::ElasticForce(elements::GapStop{.gap_above = g, .stiffness = stop}));
  nonlinear::BackboneOptions options{.mode = 0, .up_to_energy = 0.03, .harmonics = 40};
  options.at_energy = {0.0004, 0.0006, 0.001, 0.002, 0.02};
  const Backbone found = nonlinear::backbone(system, options);
  ASSERT_EQ(found.at_energy.size(), options.at_energy.size());
  for (const BackbonePoint& point : found.at_energy) {
    const double E = point.energy, a = std::sqrt(2 * E / k), w1 = std::sqrt(k / m), w2 = std::sqrt((k + stop) / m);
    double period = 2 * pi / w1;
    if (a > g) {
      const double v = std::sqrt(2 * (E - k * g * g / 2) / m), centre = stop * g / (k + stop),
                   radius = std::hypot(g - centre, v / w2);
      period = 2 * (pi - std::acos(g / a)) / w1 + 2 * std::acos((g - centre) / radius) / w2;
    }
    constexpr double truncation = 1e-6;  // of 40 harmonics
    EXPECT_THAT(point.angular_frequency, RelativelyNear(2 * pi / period, truncation)) << E;
  }
}

/// A linear damper beside a cubic spring: ζ from the energy that one period loses, c ∮ v² dt = 2 ζ ω m ∮ v² dt.
TEST(Backbone, DampingRatioFallsWithTheFrequencyItIsAShareOf) {
  const model::System system =
      with_law(test::chain({1.5}, {600, 0}, {0.9, 0}), elements::ElasticForce(elements::PolynomialForce{{0, 0, 2e5}}));
  nonlinear::BackboneOptions options{.mode = 0, .up_to = 0.08, .harmonics = 9};
  options.damped = true;
  const Backbone damped = nonlinear::backbone(system, options);
  EXPECT_EQ(damped.ended, "");
  EXPECT_GT(damped.points.back().angular_frequency, 1.2 * damped.angular_frequency);
  for (const BackbonePoint& point : damped.points)
    EXPECT_THAT(point.damping_ratio, RelativelyNear(0.9 / 1.5 / 2 / point.angular_frequency, 1e-9));
}

/// Slow slider: ζ of extended periodic motion is the loss of its loop over 2π² m ω² a² with one harmonic.
TEST(Backbone, SliderDampsMostBeyondItsSlip) {
  const double m = 10, slip = 30, stiffness = 2e4;
  const model::System system =
      with_law(test::chain({m}, {4e4, 0}, {0, 0}), elements::HystereticForce(elements::Slider{stiffness, slip}));
  nonlinear::BackboneOptions options{.mode = 0, .up_to = 0.02, .harmonics = 1};
  options.damped = true;
  const Backbone found = nonlinear::backbone(system, options);
  EXPECT_EQ(found.ended, "");
  for (const BackbonePoint& point : found.points) {
    const double a = std::abs(point.coordinates(0, 1)), w = point.angular_frequency;
    const double lost = std::max(0.0, 4 * slip * (a - slip / stiffness));
    EXPECT_NEAR(point.damping_ratio, lost / (2 * pi * m * w * w * a * a), 1e-9);
  }
}

}  // namespace backbone_test
