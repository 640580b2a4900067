// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <string>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/modes/backbone.h"

/// A mass on a spring with a slider, with and without its weight. Where the slider slips both ways, it has no mean: the
/// weight only moves the place about which the mass vibrates.
namespace loaded_slider_test {

using namespace trivet;
using test::RelativelyNear;

nonlinear::Backbone damped_mode(const std::string& gravity) {
  nonlinear::BackboneOptions options;
  options.up_to = 0.008;
  options.damped = true;
  options.at_energy = {0.05, 0.2, 0.8};
  return nonlinear::backbone(test::project("trivet = 1\n" + gravity + R"(
[bodies.m]
mass = 20
free = ["z"]
[elements.mount]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 4e4]
damping = {translation = [0, 0, 30]}
laws.z = {friction = {slip = 40, stiffness = 6e4}}
)")
                                 .base()
                                 .system,
                             options);
}

/// The mode of the loaded mass turns at once where slip begins: its mean moves by the weight that the slider bore.
TEST(LoadedSlider, HasTheDampedModeOfTheUnloadedOneBeyondItsSlip) {
  const nonlinear::Backbone loaded = damped_mode("gravity = [0, 0, -9.81]"), unloaded = damped_mode("");
  EXPECT_EQ(loaded.ended, "");
  ASSERT_EQ(loaded.at_energy.size(), 3u);
  ASSERT_EQ(unloaded.at_energy.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr double of_newton = 1e-9;
    EXPECT_THAT(loaded.at_energy[i].angular_frequency,
                RelativelyNear(unloaded.at_energy[i].angular_frequency, of_newton));
    EXPECT_THAT(loaded.at_energy[i].damping_ratio, RelativelyNear(unloaded.at_energy[i].damping_ratio, of_newton));
  }
}

}  // namespace loaded_slider_test
