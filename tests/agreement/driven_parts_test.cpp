// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/judging/read_project.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/response/steady/frequency_response.h"

/// Steady motion under orders and waves, and with elements whose stiffness is a function of frequency: against the
/// linear machine while all stops are open, the balance of forces, and marching in time.
namespace driven_parts_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

/// On a coil spring with its exact dynamic stiffness, rubber of fractional order and two bushings.
std::string machine(const std::string& more) {
  return R"(trivet = 1
[bodies.machine]
mass = 20
inertia = {about = "center_of_mass", xx = 0.5, yy = 0.6, zz = 0.7, xy = 0.05}
points = {edge = [0.1, -0.05, 0.02]}
[elements.spring]
type = "coil_spring"
on = "machine"
at = [0.1, 0.1, -0.1]
wire_diameter = 6e-3
mean_diameter = 50e-3
active_coils = 6
free_length = 0.12
material = "spring_steel"
level = "exact"
[elements.rubber]
type = "bushing"
on = "machine"
at = [-0.1, 0.1, -0.1]
translation = [1.1e4, 1e4, 2e4]
rotation = [20, 20, 20]
damping = {fractional_zener = {ratio = 1.5, time = 1e-3, order = 0.6}}
[elements.left]
type = "bushing"
on = "machine"
at = [-0.05, -0.1, -0.1]
translation = [1e4, 1e4, 2e4]
damping = {proportional = 2e-3}
[elements.right]
type = "bushing"
on = "machine"
at = [0.1, -0.1, -0.1]
translation = [1e4, 1.2e4, 2e4]
damping = {proportional = 2e-3}
)" + more;
}

constexpr const char* open_stop = R"([elements.stop]
type = "stop"
on = "machine"
at = [0.02, 0.05, 0]
axis = "z"
gaps = [1, 1]
stiffness = 1e5
)";

constexpr const char* force = R"([excitations.force]
type = "harmonic"
on = "machine"
at = [0.02, 0.01, 0]
force = [5, 0, 30]
)";

/// Both ends of the springs move later, the further they are.
constexpr const char* wave = R"([excitations.wave]
type = "base"
translation = [0, 0, 1e-3]
wave = {direction = "x", speed = 20}
)";

void expect_linear_response(const std::string& excitation) {
  const project::Project with = test::project(machine(open_stop + excitation)),
                         without = test::project(machine(excitation));
  const model::System& linear_system = without.base().system;
  const std::vector<std::string> of = {"machine", "machine.edge", "spring", "rubber", "left", "ground"};
  nonlinear::SteadyOptions options{.from = 20, .to = 120, .harmonics = 3, .of = of};
  options.at = {25, 61.5, 118};
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(with.base().system, options);
  const assembly::Assembled assembled = assembly::assemble(linear_system);
  const response::FrequencyResponse linear = response::frequency_response(
      assembled, assembly::channels(linear_system, assembled, of, assembly::MotionQuantity::displacement),
      assembly::harmonic_loading(linear_system, assembled, {}), options.at);
  ASSERT_EQ(found.at.size(), options.at.size());
  constexpr double round_off = 1e-11;  // of the largest result; the condition of the dynamic stiffness is 1e4
  for (std::size_t i = 0; i < options.at.size(); ++i) {
    double largest = 0;
    for (const response::Curve& curve : linear.curves)
      largest = std::max(largest, std::abs(curve.value(static_cast<Eigen::Index>(i))));
    ASSERT_GT(largest, 0);
    for (std::size_t c = 0; c < linear.curves.size(); ++c) {
      const std::complex<double> expected = linear.curves[c].value(static_cast<Eigen::Index>(i));
      EXPECT_NEAR(std::abs(found.at[i].results[c].harmonics(0) - expected), 0, round_off * largest) << found.results[c];
    }
  }
}

TEST(DrivenParts, OpenStopsWithElementsOverFrequencyGiveTheLinearResponse) { expect_linear_response(force); }
TEST(DrivenParts, OpenStopsUnderAWaveGiveTheLinearResponse) { expect_linear_response(wave); }

/// d'Alembert at every harmonic; the spring has mass of its own, so the forces on the body alone are added.
TEST(DrivenParts, ForcesOfElementsOverFrequencyBalanceTheMotionOfTheBody) {
  std::string text = machine(force);
  const std::size_t spring = text.find("[elements.spring]"), rubber = text.find("[elements.rubber]");
  text.erase(spring, rubber - spring);  // what remains has no mass
  const project::Project project = test::project(text, {"elements.right.laws.z={cubic=4e10}"});
  nonlinear::SteadyOptions options{.from = 30, .to = 120, .harmonics = 9, .of = {"machine", "ground"}};
  options.at = {45, 75};
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(project.base().system, options);
  EXPECT_EQ(found.multipliers_of, nonlinear::SteadyBranch::Multipliers::constant_machine);
  EXPECT_GT(found.winding.points, 0);
  EXPECT_THAT(found.winding.differs_at, testing::IsEmpty());
  ASSERT_GE(found.at.size(), 2u);
  for (const nonlinear::SteadyPoint& point : found.at) {
    EXPECT_GT(std::abs(point.results[2].harmonics(2)), 1e-3 * std::abs(point.results[2].harmonics(0)));
    for (int axis = 0; axis < 3; ++axis) {
      const nonlinear::ObservedMotion &motion = point.results[static_cast<std::size_t>(axis)],
                                      &forces = point.results[static_cast<std::size_t>(6 + axis)];
      for (Eigen::Index k = 0; k < motion.harmonics.size(); ++k) {
        const double omega = point.angular_frequency * static_cast<double>(k + 1);
        const std::complex<double> given = k > 0 ? 0 : axis == 2 ? 30 : axis == 0 ? 5 : 0;
        EXPECT_NEAR(std::abs(given + 20 * omega * omega * motion.harmonics(k) - forces.harmonics(k)), 0, 1e-8) << axis;
      }
    }
  }
}

constexpr const char* orders = R"([excitations.engine]
type = "orders"
on = "machine"
at = [0.02, 0.01, 0]
table = [{order = 1.5, force = [0, 0, 12]}, {order = 2, force_per_speed2 = [0, 0, 4e-3], phase = 0.7}, {order = 0.5, moment = [2, 0, 0]}]
)";

TEST(DrivenParts, OpenStopsUnderOrdersGiveTheLinearResponseToEachOrder) {
  const project::Project project = test::project(machine(std::string(open_stop) + orders));
  const model::System& system = project.base().system;
  const std::vector<std::string> of = {"machine", "spring", "ground"};
  nonlinear::SteadyOptions options{.from = 20, .to = 120, .harmonics = 5, .of = of};
  options.at = {30, 83};
  const nonlinear::SteadyBranch found = nonlinear::steady_branch(system, options);
  EXPECT_TRUE(found.of_shaft);
  EXPECT_EQ(found.first_harmonic, 0.5);
  ASSERT_EQ(found.at.size(), options.at.size());
  const assembly::Assembled assembled = assembly::assemble(system);
  const std::vector<assembly::Channel> channels =
      assembly::channels(system, assembled, of, assembly::MotionQuantity::displacement);
  for (const response::OrderLoading& order : response::order_loadings(system, assembled)) {
    const auto k = static_cast<Eigen::Index>(std::lround(2 * order.order)) - 1;
    for (std::size_t i = 0; i < options.at.size(); ++i) {
      const response::FrequencyResponse linear =
          response::frequency_response(assembled, channels, order.loading, {order.order * options.at[i]});
      for (std::size_t c = 0; c < channels.size(); ++c)
        EXPECT_NEAR(std::abs(found.at[i].results[c].harmonics(k) - linear.curves[c].value(0)), 0, 1e-9)
            << found.results[c] << " order " << order.order;
    }
  }
}

/// A mass on a hardening spring under two orders with a common divisor, marched in time over two turns of the shaft.
TEST(DrivenParts, OrdersOnAHardeningSpringAsMarchedInTime) {
  constexpr double mass = 12, damping = 60, stiffness = 1.5e4, cubic = 4e8, speed = 31;
  const std::string engine =
      "\n[excitations.engine]\ntype = \"orders\"\non = \"m1\"\nat = [0, 0, 0]\ntable = [{order = 1, force = [60, 0, "
      "0]}, {order = 1.5, force = [50, 0, 0], phase = 0.7}]\n";
  const project::Project project =
      test::project(test::chain({mass}, {stiffness, 0}, {damping, 0}) + engine, {"elements.k1.laws.x={cubic=4e8}"});
  nonlinear::SteadyOptions options{.from = 5, .to = 40, .harmonics = 45, .of = {"m1.x"}};
  options.at = {speed};
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(project.base().system, options);
  ASSERT_EQ(branch.at.size(), 1u);
  ASSERT_TRUE(branch.at[0].stable);
  const auto slope = [&](double t, const Eigen::Vector2d& y) {
    const double given = 60 * std::cos(speed * t) + 50 * std::cos(1.5 * speed * t + 0.7);
    return Eigen::Vector2d(y(1), (given - damping * y(1) - stiffness * y(0) - cubic * y(0) * y(0) * y(0)) / mass);
  };
  constexpr int periods = 250, steps = 16'000;  // it settles slowly
  const double h = 4 * pi / speed / steps;
  Eigen::Vector2d y = Eigen::Vector2d::Zero();
  double largest = 0, smallest = 0;
  for (int i = 0; i < periods * steps; ++i) {
    const double t = i * h;
    const Eigen::Vector2d k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1),
                          k3 = slope(t + h / 2, y + h / 2 * k2), k4 = slope(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (i < (periods - 1) * steps) continue;
    largest = std::max(largest, y(0));
    smallest = std::min(smallest, y(0));
  }
  constexpr double between_steps = 1e-6;
  EXPECT_THAT(branch.at[0].results[0].largest, RelativelyNear(largest, between_steps));
  EXPECT_THAT(branch.at[0].results[0].smallest, RelativelyNear(smallest, between_steps));
}

TEST(DrivenParts, OrdersWithoutACommonDivisorAreRefused) {
  const std::string odd = R"([excitations.engine]
type = "orders"
on = "machine"
at = [0, 0, 0]
table = [{order = 1, force = [0, 0, 12]}, {order = 1.6180339887, force = [0, 0, 4]}]
)";
  const project::Project project = test::project(machine(std::string(open_stop) + odd));
  const nonlinear::SteadyOptions options{.from = 20, .to = 120, .harmonics = 5};
  EXPECT_THAT([&] { (void)nonlinear::steady_branch(project.base().system, options); },
              testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr("no common divisor")));
}

/// The second verdict shares the harmonic balance with the first, not the way from a motion to its stability.
TEST(DrivenParts, TwoVerdictsOnStabilityAgree) {
  const char* examples[] = {"roll_stop/engine.toml", "isolator/hardening.toml", "snubber/genset.toml"};
  for (const char* example : examples) {
    SCOPED_TRACE(example);
    const auto read = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/" + example);
    ASSERT_TRUE(read);
    nonlinear::SteadyOptions options{.from = 20, .to = 220, .harmonics = 5};
    options.deep = true;
    const nonlinear::SteadyBranch branch = nonlinear::steady_branch(read.value().base().system, options);
    EXPECT_EQ(branch.winding.points, std::ssize(branch.points));
    EXPECT_EQ(branch.winding.undecided, 0);
    EXPECT_THAT(branch.winding.differs_at, testing::IsEmpty());
  }
}

}  // namespace driven_parts_test
