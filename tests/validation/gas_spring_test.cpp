// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/modal/modes.h"
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/nonlinear/rest/rest_position.h"

/// A mass on an air spring with a polytropic gas: closed forms, and periods by quadrature of the energy integral.
namespace gas_spring_test {

using namespace trivet;
using test::RelativelyNear;

std::string table(double more_weight, const std::string& exponent = "1.38") {
  return R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.table]
mass = 610.2083790081222
free = ["z"]
[elements.bag]
type = "air_spring"
on = "table"
at = [0, 0, 0]
from_at = [0, 0, -0.2]
pressure = "6 bar"
volume = "2.5 l"
area = "120 cm^2"
exponent = )" +
      exponent + R"(
[excitations.weight]
type = "constant"
on = "table"
at = [0, 0, 0]
force = [0, 0, )" +
      std::to_string(-more_weight) + "]\n";
}

TEST(GasSpring, CarriesItsLoadWithTheTangentOfTheGas) {
  const model::System system = test::project(table(0)).base().system;
  EXPECT_NEAR(system.elements()[0].nonlinear_parts[0].at_rest, 0, 1e-12);
  const auto frequency = [](const model::System& of) {
    return *modal::modes(of, assembly::assemble(of)).list.front().angular_frequency / (2 * std::numbers::pi);
  };
  EXPECT_THAT(frequency(system), RelativelyNear(1.4070432864853988, 1e-9));
  const double isothermal = std::sqrt(34560.0 / 610.2083790081222) / (2 * std::numbers::pi);
  EXPECT_THAT(frequency(test::project(table(0, "1")).base().system), RelativelyNear(isothermal, 1e-9));
}

TEST(GasSpring, ForceAtFortyMillimetresBothWays) {
  constexpr double load = 5984.1;
  for (const auto& [compression, force] : {std::pair(0.04, 8446.940670436092), {-0.04, 4434.3968369662425}}) {
    const project::Case rest =
        test::project(table(0), {"excitations.weight.force=[0,0," + std::to_string(load - force) + "]"}).base();
    EXPECT_NEAR(rest.system.elements()[0].nonlinear_parts[0].at_rest, -compression, 1e-9);
  }
}

/// p (V/(V + A δ))^n − p_a, integrated from rest, less the weight: what a swing to one end stores.
double stored(double compression) {
  constexpr double p = 6e5, V = 2.5e-3, A = 0.012, n = 1.38, load = 5984.1, atmosphere = 101325;
  const double share = 1 - A * compression / V;
  return p * V * (std::pow(share, 1 - n) - 1) / (n - 1) - (load + atmosphere * A) * compression;
}

TEST(GasSpring, PeriodOverAmplitude) {
  const model::System system = test::project(table(0)).base().system;
  const struct Row {
    double compression, period, other_end;
  } rows[] = {{0.01, 0.7108587488343209, -0.010395903366574168},
              {0.03, 0.7121627768913906, -0.03387216860256315},
              {0.06, 0.7173947610246785, -0.07783978759287491}};
  for (const Row& row : rows) {
    nonlinear::BackboneOptions options{.up_to_energy = 1.001 * stored(row.compression), .harmonics = 15};
    options.of = {"table.z"};
    options.at_energy = {stored(row.compression)};
    const nonlinear::Backbone found = nonlinear::backbone(system, options);
    ASSERT_EQ(found.at_energy.size(), 1u);
    EXPECT_THAT(2 * std::numbers::pi / found.at_energy[0].angular_frequency, RelativelyNear(row.period, 1e-9));
    EXPECT_THAT(found.at_energy[0].results[0].smallest, RelativelyNear(-row.compression, 1e-8));
    EXPECT_THAT(found.at_energy[0].results[0].largest, RelativelyNear(-row.other_end, 1e-8));
  }
}

}  // namespace gas_spring_test
