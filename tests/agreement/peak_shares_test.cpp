// SPDX-License-Identifier: BSD-3-Clause
// Shares of peaks against independent sums.
#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "support/sensitivity_request.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/modal/roots.h"
#include "trivet/response/sensitivity/peak_shares.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace peak_shares_test {

using namespace trivet;
using test::drive;
using test::RelativelyNear;
using test::sensitivity_request;

TEST(PeakShares, ModesSumToOneAndToTheChannel) {
  using enum test::RandomDamping;
  constexpr double round_off = 1e-9;  // 1e-16 over the damping, times modes that nearly cancel
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const model::System system = test::checked(
        test::RandomSystem(seed).description(1 + seed % 3, std::array{proportional, viscous, loss}[seed % 3]));
    const assembly::Assembled assembled = assembly::assemble(system);
    const auto request =
        sensitivity_request({"body 0.tip.x", "ground.force.z"}, static_cast<assembly::MotionQuantity>(seed % 3));
    const double omega = 40.0 + 10 * seed;
    const auto curves = response::frequency_response(
        assembled, assembly::channels(system, assembled, request.channels, request.quantity),
        request.load(system, assembled), {omega});
    for (std::size_t c = 0; c < 2; ++c) {
      const response::PeakShares shares = response::peak_shares(system, assembled, request, {c, omega, {}});
      std::complex<double> sum = 0;
      double one = shares.beyond_modes;
      for (const response::ModeShare& mode : shares.modes) {
        sum += mode.part;
        one += mode.share;
      }
      EXPECT_LE(std::abs(shares.value - curves.curves[c].value(0)), round_off * std::abs(shares.value));
      EXPECT_LE(std::abs(sum - shares.value), round_off * std::abs(shares.value));
      EXPECT_NEAR(shares.beyond_modes, 0, round_off);
      EXPECT_NEAR(one, 1, round_off);
    }
  }
}

/// Mean power of the load over a period, ½ω Im(qᴴh).
double input_power(const model::System& system, const response::SensitivityRequest& request, double omega) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto curves = response::frequency_response(
      assembled, assembly::channels(system, assembled, {"coordinates"}, assembly::MotionQuantity::displacement),
      request.load(system, assembled), {omega});
  const Eigen::VectorXcd load = request.load(system, assembled).force.at(omega);
  double power = 0;
  for (std::size_t i = 0; i < curves.curves.size(); ++i)
    power += 0.5 * omega * (std::conj(curves.curves[i].value(0)) * load(to_index(i))).imag();
  return power;
}

TEST(PeakShares, EnergiesSumToOneAndThePowerIsThatOfTheLoad) {
  using enum test::RandomDamping;
  constexpr double round_off = 1e-9;  // two sums of solutions with condition up to 1e5
  for (unsigned seed = 1; seed <= 8; ++seed) {
    model::Description description =
        test::RandomSystem(seed).description(1 + seed % 3, std::array{proportional, viscous, loss}[seed % 3]);
    if (seed == 4) description.damping = model::RayleighDamping{0.3, 1e-4};
    if (seed == 5) description.damping = model::ModalDamping{{0.02}};
    if (seed == 6) description.elements[0].law.damping = elements::Zener{0.5, 0.02};
    if (seed == 7) description.elements[0].law.damping = elements::FractionalZener{0.6, 0.01, 0.5};
    const model::System system = test::checked(description);
    const auto request = sensitivity_request({"body 0.x"});
    const double omega = 55;
    const response::PeakShares shares =
        response::peak_shares(system, assembly::assemble(system), request, {0, omega, {}});
    double stored = shares.geometric, dissipated = shares.system_damping;
    for (const response::ElementShare& element : shares.elements) {
      stored += element.stored;
      dissipated += element.dissipated;
    }
    EXPECT_NEAR(stored, 1, round_off);
    EXPECT_NEAR(dissipated, 1, round_off);
    EXPECT_THAT(shares.dissipated_power, RelativelyNear(input_power(system, request, omega), round_off))
        << "seed " << seed;
    const bool plain = seed != 6;  // a relaxing branch also stores energy
    for (std::size_t e = plain ? 0 : 1; e < shares.elements.size(); ++e)
      EXPECT_NEAR(shares.elements[e].by_direction.sum(), shares.elements[e].stored, round_off) << "seed " << seed;
  }
}

TEST(PeakShares, IncludeThePowerOfAMovingGround) {
  // Power supplied by the ground: minus the mean of the force on it times its velocity.
  constexpr double round_off = 1e-9;  // two sums of solutions with condition up to 1e5
  for (int kind = 0; kind < 2; ++kind) {
    test::RandomSystem random(30 + static_cast<unsigned>(kind));
    model::Description description = random.description(2, test::RandomDamping::viscous);
    description.excitations = drive(0, random);
    description.excitations[0].action.at.setZero();
    if (kind == 1) description.elements[1].law.damping = elements::FractionalZener{0.6, 0.01, 0.5};
    const model::System system = test::checked(description);
    const assembly::Assembled assembled = assembly::assemble(system);
    const auto request = sensitivity_request({"body 0.x"});
    const double omega = 60;
    const response::PeakShares shares = response::peak_shares(system, assembled, request, {0, omega, {}});
    const auto force = response::frequency_response(
        assembled, assembly::channels(system, assembled, {"ground"}, assembly::MotionQuantity::displacement),
        request.load(system, assembled), {omega});
    double power = 0;
    for (std::size_t j = 0; j < 6; ++j)
      power -= 0.5 *
          (std::conj(force.curves[j].value(0)) * std::complex<double>(0, omega) *
           description.excitations[0].action.amplitude(to_index(j)))
              .real();
    EXPECT_THAT(shares.dissipated_power, RelativelyNear(power, round_off));
    double stored = 0, one = shares.beyond_modes;
    for (const response::ElementShare& element : shares.elements) stored += element.stored;
    for (const response::ModeShare& mode : shares.modes) one += mode.share;
    EXPECT_NEAR(stored, 1, round_off);
    EXPECT_NEAR(one, 1, round_off);
  }
}

TEST(PeakShares, TwoParallelSpringsShareByTheirStiffness) {
  const auto project = test::project(R"(trivet = 1
[bodies.m]
mass = 2
free = ["x"]
[elements.soft]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [500, 0, 0]
damping = {loss_factor = 0.1}
[elements.hard]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [1300, 0, 0]
damping = {loss_factor = 0.05}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [5, 0, 0]
)");
  const model::System& system = project.base().system;
  const response::PeakShares shares =
      response::peak_shares(system, assembly::assemble(system), sensitivity_request({"m.x"}), {0, 30.0, {}});
  constexpr double round_off = 1e-13;  // one coordinate, some ten operations
  EXPECT_NEAR(shares.elements[0].stored, 500.0 / 1800, round_off);
  EXPECT_NEAR(shares.elements[1].by_direction(0), 1300.0 / 1800, round_off);
  EXPECT_NEAR(shares.elements[0].dissipated, 50.0 / 115, round_off);
  EXPECT_THAT(shares.strain_energy, RelativelyNear(0.25 * 1800 * (5.0 / 115) * (5.0 / 115), round_off));
  EXPECT_THAT(shares.dissipated_power, RelativelyNear(0.5 * 30 * 115 * (5.0 / 115) * (5.0 / 115), round_off));
}

}  // namespace peak_shares_test
