// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/law_over_period.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/gauss_nodes.h"

/// Closed loops under x = X sin t against closed forms.
namespace hysteretic_loop_test {

using namespace trivet;
using nonlinear::HystereticLoop;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

struct Loop {
  double force = 0;       ///< at the largest deflection
  double in_phase = 0;    ///< first harmonic with the deflection
  double quadrature = 0;  ///< first harmonic with its rate
  [[nodiscard]] double energy(double amplitude) const { return pi * amplitude * quadrature; }
};

Loop loop_of(const elements::HystereticForce& law, double amplitude) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(3);
  motion(2) = amplitude;
  const HystereticLoop loop({law, 0}, motion, {pi / 2, 3 * pi / 2});
  Loop found;
  found.force = loop.branches().front().force;
  for (const HystereticLoop::Branch& branch : loop.branches()) {
    const auto add = [&](double phase, double weight) {
      const double force = loop.at(branch, amplitude * std::sin(phase)).force;
      found.in_phase += weight / pi * force * std::sin(phase);
      found.quadrature += weight / pi * force * std::cos(phase);
    };
    const double middle = branch.kink.value_or(branch.to), piece = 0.02;
    numerics::each_gauss_node(branch.from, middle, piece, add);
    if (branch.kink) numerics::each_gauss_node(middle, branch.to, piece, add);
  }
  return found;
}

constexpr double digits = 1e-8;  // of the reference

/// Berg 1998 (Vehicle System Dynamics 30): force amplitude and loss in closed form; harmonics by quadrature.
TEST(HystereticLoop, BergClosesAtEveryAmplitude) {
  struct Row {
    double amplitude, force, loss, in_phase, quadrature;
  };
  const Row rows[] = {{5e-5, 87.69526484, 0.002063575643, 87.01027098, 13.13713056},
                      {0.0002, 207.1067812, 0.04745056519, 197.3682269, 75.51992003},
                      {0.0005, 304.2476415, 0.2688117332, 269.2280522, 171.1308644},
                      {0.002, 422.1443851, 2.318452217, 294.5816942, 368.9931307},
                      {0.01, 481.1186224, 16.95780543, 205.8876038, 539.7837115}};
  for (const Row& row : rows) {
    const Loop loop = loop_of(elements::BergFriction{500, 2e-4}, row.amplitude);
    EXPECT_THAT(loop.force, RelativelyNear(row.force, digits));
    EXPECT_THAT(loop.energy(row.amplitude), RelativelyNear(row.loss, digits));
    EXPECT_THAT(loop.in_phase, RelativelyNear(row.in_phase, digits));
    EXPECT_THAT(loop.quadrature, RelativelyNear(row.quadrature, digits));
  }
}

/// n = 2, β = γ = 1/2: Z = tanh(2U − Z), E = 2 [ln cosh(2U − Z) − Z²/2].
TEST(HystereticLoop, BoucWenWithASquareIsATangensHyperbolicus) {
  const double rows[][3] = {{0.5, 0.47870154299972106, 0.031113012968817938},
                            {1.0, 0.8256588617463368, 0.46308783649237883},
                            {2.0, 0.995102834622109, 3.6381734889030977}};
  for (const auto& row : rows) {
    const Loop loop = loop_of(elements::BoucWen{.stiffness = 1, .force = 1, .exponent = 2}, row[0]);
    EXPECT_THAT(loop.force, RelativelyNear(row[1], digits));
    EXPECT_THAT(loop.energy(row[0]), RelativelyNear(row[2], digits));
  }
  EXPECT_THAT(elements::force_on_travel(elements::BoucWen{1, 1, 2, 0.5, 0.5}, 0, 0.7).force,
              RelativelyNear(std::tanh(0.7), 1e-14));
}

/// A slider loses 4 slip (X − slip/k) in a cycle.
TEST(HystereticLoop, SliderLosesItsRectangle) {
  const Loop loop = loop_of(elements::Slider{2e4, 30}, 4e-3);
  EXPECT_EQ(loop.force, 30);
  EXPECT_THAT(loop.energy(4e-3), RelativelyNear(4 * 30 * (4e-3 - 30 / 2e4), 1e-10));
}

}  // namespace hysteretic_loop_test
