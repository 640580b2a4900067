// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/radau_panel.h"

#include <gmock/gmock.h>

#include <cmath>

namespace radau_panel_test {

using namespace trivet;
using numerics::DecayingPanel;
using numerics::radau_panel;
using numerics::RadauPanel;

constexpr double round_off = 1e-14;

TEST(RadauPanel, IntegratesPolynomials) {
  const RadauPanel& panel = radau_panel();
  EXPECT_EQ(panel.places(RadauPanel::nodes - 1), 1);
  for (int degree = 0; degree <= 2 * RadauPanel::nodes - 2; ++degree)
    EXPECT_NEAR(panel.weights.dot(panel.places.array().pow(degree).matrix()), 1.0 / (degree + 1), round_off) << degree;
  for (int degree = 0; degree < RadauPanel::nodes; ++degree)
    for (int i = 0; i < RadauPanel::nodes; ++i)
      EXPECT_NEAR(panel.integrals.row(i).dot(panel.places.array().pow(degree).matrix()),
                  std::pow(panel.places(i), degree + 1) / (degree + 1), round_off);
}

TEST(RadauPanel, InterpolatesPolynomials) {
  const RadauPanel& panel = radau_panel();
  for (const double place : {0.0, 0.1, 0.47, 0.99, 1.0})
    for (int degree = 1; degree <= RadauPanel::nodes; ++degree)
      EXPECT_NEAR(panel.interpolation(place).tail<RadauPanel::nodes>() * panel.places.array().pow(degree).matrix(),
                  std::pow(place, degree), 10 * round_off);
}

/// ẏ = r − 3 t y from y(0) = 0.3 with the r of y = 0.3 + sin 2t.
TEST(RadauPanel, SolvesADecayingEquation) {
  const auto error = [](double length) {
    const auto times = (length * radau_panel().places).array();
    const DecayingPanel panel(length, 3 * times);
    const RadauPanel::Vector exact = 0.3 + (2 * times).sin(),
                             source = 2 * (2 * times).cos() + 3 * times * exact.array();
    return std::abs((panel.of_start * 0.3 + panel.of_source * source - exact)(RadauPanel::nodes - 1));
  };
  EXPECT_LT(error(1), 1e-11);
  EXPECT_LT(error(1), error(2) / std::pow(2, 14));  // of order 15
}

/// However fast it decays, at the end there is the balance r/a of the end.
TEST(RadauPanel, FollowsTheBalanceOfAFastDecay) {
  const RadauPanel::Vector decay = 1e9 * (2 + radau_panel().places.array());
  const DecayingPanel panel(1, decay);
  const RadauPanel::Vector at = panel.of_start + panel.of_source * (1e9 * radau_panel().places);
  constexpr double of_start = 1e-8;  // what is left of it falls with the decay
  EXPECT_NEAR(at(RadauPanel::nodes - 1), 1.0 / 3, of_start);
}

}  // namespace radau_panel_test
