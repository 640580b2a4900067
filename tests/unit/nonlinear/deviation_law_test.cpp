// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/deviation_law.h"

#include <gtest/gtest.h>

namespace deviation_law_test {

using namespace trivet;
using Eigen::VectorXd;

const elements::ElasticForce hardening = elements::PolynomialForce{{50, 20, 3e4}};
const elements::ElasticForce stop = elements::GapStop{.gap_above = 0.02, .gap_below = 0.05, .stiffness = 1e5};
const elements::ElasticForce damped_stop =
    elements::GapStop{.gap_above = 0.01, .stiffness = 2e4, .power = 1.5, .dissipation = 0.3};
const elements::DampingForce damper = elements::QuadraticDamping{40};

TEST(DeviationLaw, ForcesAtManyDeflectionsAreThoseAtEach) {
  nonlinear::DeviationLaw::Parts parts;
  for (const elements::ElasticForce& law : {hardening, stop, damped_stop}) parts.add(law);
  parts.add(damper);
  const VectorXd deflections = VectorXd::LinSpaced(41, -0.1, 0.1), rates = VectorXd::LinSpaced(41, 2, -4);
  const elements::ForcesInMotion all = parts.at(deflections, rates);
  for (Eigen::Index i = 0; i < deflections.size(); ++i) {
    const nonlinear::DeviationLaw::Force one = parts.at(deflections(i), rates(i));
    EXPECT_DOUBLE_EQ(all.force(i), one.force);
    EXPECT_DOUBLE_EQ(all.by_deflection(i), one.by_deviation);
    EXPECT_DOUBLE_EQ(all.by_rate(i), one.by_rate);
  }
}

TEST(DeviationLaw, ElasticTangentsAreThoseAtEachDeviation) {
  constexpr double round_off = 1e-10;  // of the stop's 1e5 N/m
  const nonlinear::DeviationLaw about({hardening, stop}, 0.015, {.stiffness = 70});
  const VectorXd deviations = VectorXd::LinSpaced(41, -0.1, 0.1), tangents = about.elastic_tangents(deviations);
  for (Eigen::Index i = 0; i < deviations.size(); ++i)
    EXPECT_NEAR(tangents(i), about.without_memory(deviations(i), 0).by_deviation, round_off);
}

}  // namespace deviation_law_test
