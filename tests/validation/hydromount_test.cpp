// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/branch/stiffness_over_amplitude.h"

/// A hydromount against the closed forms of its lumped model (the form of Singh, Kim, Ravindra, J. Sound Vib. 158
/// (1992)), with the decoupler closed and open, and against marching in time between them.
namespace hydromount_test {

using namespace trivet;
using test::RelativelyNear;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;

std::string mount(const std::string& decoupler, double force = 100) {
  return R"(trivet = 1
[bodies.m]
mass = 100
free = ["z"]
[elements.mount]
type = "hydromount"
on = "m"
at = [0, 0, 0]
translation = [1e5, 1e5, 1.8e5]
damping = {translation = [0, 0, 90]}
upper = 4e10
lower = 1e9
piston_area = 0.0032
track = {inertance = 2.5e6, resistance = 1.6e8}
)" + decoupler +
      "[excitations.F]\ntype = \"harmonic\"\non = \"m\"\nat = [0, 0, 0]\nforce = [0, 0, " + std::to_string(force) +
      "]\n";
}

constexpr const char* with_decoupler = "decoupler = {inertance = 8e4, resistance = 2e7, play = 2e-6}\n";
/// Nothing holds it, as in the closed form.
constexpr const char* with_free_decoupler =
    "decoupler = {inertance = 8e4, resistance = 2e7, play = 2e-6, centring = 1e-3}\n";

Complex along_axis(const std::string& text, double hertz) {
  const project::Project project = test::project(text);
  return elements::dynamic_stiffness(project.base().system.elements()[0].law, 2 * pi * hertz)(8, 8);
}

void expect_near(Complex found, Complex expected, double relative) {
  EXPECT_LT(std::abs(found - expected), relative * std::abs(expected)) << found << " " << expected;
}

TEST(Hydromount, StiffnessOverFrequencyWithTheDecouplerClosedAndOpen) {
  const struct Row {
    double hertz;
    Complex closed, open;
  } rows[] = {{1, {189267.82374938024, 10405.216972859122}, {189957.06406913415, 1654.9480898679935}},
              {5, {171516.11959610274, 57366.157887106194}, {189186.48456794923, 8353.782193992209}},
              {10, {113000.79163380756, 159565.46563950577}, {186949.53399151156, 17038.902912711903}},
              {15, {59256.05670140666, 434025.44123576523}, {183402.67156546842, 26096.934401653707}},
              {20, {528283.7497246393, 821542.793924356}, {178486.3743771215, 35584.2971538102}},
              {50, {664748.8128774909, 46634.34805208131}, {112343.29890677714, 113346.06371163897}},
              {150, {597080.9587795605, 85340.56011677139}, {1006210.3604089541, 350820.5973352066}}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.hertz);
    expect_near(along_axis(mount(""), row.hertz), row.closed, 1e-10);
    expect_near(along_axis(mount(with_free_decoupler), row.hertz), row.open, 1e-10);
  }
}

TEST(Hydromount, SlowStiffnessContainsBothChambers) {
  const project::Project project = test::project(mount(""));
  EXPECT_THAT(elements::stiffness(project.base().system.elements()[0].law)(8, 8),
              RelativelyNear(189990.24390243902, 1e-12));
}

/// The loss factor is that of the rubber; neither fluid nor gas is lossy, in the matrices as in the dynamic stiffness.
TEST(Hydromount, LossFactorActsOnTheRubberAlone) {
  std::string lossy = mount(with_decoupler);
  lossy.replace(lossy.find("{translation = [0, 0, 90]}"), 26, "{loss_factor = 0.2}");
  const std::string gas = R"([elements.bag]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 1e4]
damping = {loss_factor = 0.3}
laws.z = {gas = {pressure = 4e5, volume = 1e-3, area = 5e-3}}
)";
  const project::Project project = test::project(lossy + gas);
  const double omega = 2 * pi * 12;
  for (const model::Element& element : project.base().system.elements()) {
    const elements::Matrices m = elements::matrices(element.law);
    Eigen::MatrixXcd z = m.stiffness + Complex(0, omega) * m.damping - omega * omega * m.mass;
    z += Complex(0, 1) * m.loss;
    const Eigen::Index inner = z.rows() - 12;
    Eigen::MatrixXcd ends = z.topLeftCorner(12, 12);
    if (inner > 0)
      ends -= z.topRightCorner(12, inner) * z.bottomRightCorner(inner, inner).inverse() * z.bottomLeftCorner(inner, 12);
    expect_near(ends(8, 8), elements::dynamic_stiffness(element.law, omega)(8, 8), 1e-12);
    const double own = element.law.nominal_stiffness(8, 8);
    EXPECT_THAT(m.loss(8, 8), RelativelyNear(elements::loss_factor(element.law) * own, 1e-12)) << element.name;
  }
}

/// Largest deflection of the mass at 8 Hz.
double largest(const std::string& text) {
  nonlinear::SteadyOptions options{.from = 2 * pi * 3, .to = 2 * pi * 30, .harmonics = 31, .of = {"m.z"}};
  options.at = {2 * pi * 8};
  const project::Project project = test::project(text);
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(project.base().system, options);
  return branch.at.empty() ? NAN : branch.at[0].results[0].largest;
}

TEST(Hydromount, SmallMotionIsThatOfTheOpenDecouplerAndLargeMotionThatOfTheClosedOne) {
  const Complex open = along_axis(mount(with_decoupler), 8), closed = along_axis(mount(""), 8);
  const double inertia = 100 * std::pow(2 * pi * 8, 2);
  EXPECT_THAT(largest(mount(with_decoupler, 1)), RelativelyNear(1 / std::abs(open - inertia), 1e-9));
  constexpr double play_left = 0.05;  // its seat is as soft as the upper chamber
  EXPECT_THAT(largest(mount(with_decoupler, 1e4)), RelativelyNear(1e4 / std::abs(closed - inertia), play_left));
}

/// The fluid of the mount in time: volumes and flows of a track with quadratic losses, and of a decoupler that opens
/// and closes.
struct Fluid {
  static constexpr double upper = 4e10, lower = 1e9, area = 0.0032, play = 2e-6, track = 5e11, seat = upper;
  using State = Eigen::Vector4d;  // volume and flow of the track, of the decoupler

  static std::string mount_of(double force) {
    std::string lossy = mount(with_decoupler, force);
    lossy.replace(lossy.find("resistance = 1.6e8"), 18, "resistance = 1.6e8, quadratic_resistance = 5e11");
    return lossy;
  }
  /// At the displacement z of end K.
  static double pressure(double z, const State& y) { return upper * (-area * z - y(0) - y(2)); }
  static State rate(double z, const State& y) {
    const double dissipation = 2 / (std::sqrt(seat / 8e4) * 0.1 * play);
    const double across = pressure(z, y) - lower * (y(0) + y(2));
    double closing = 0;
    if (std::abs(y(2)) > play) {
      const double sign = y(2) > 0 ? 1 : -1;
      closing = sign * seat * (std::abs(y(2)) - play) * std::max(0.0, 1 + dissipation * sign * y(3));
    }
    return {y(1), (across - 1.6e8 * y(1) - track * y(1) * std::abs(y(1))) / 2.5e6, y(3),
            (across - 2e7 * y(3) - 1e4 * y(2) - closing) / 8e4};
  }
};

/// By Runge and Kutta's method, from rest; `visit(t, state)` in the last period.
template <typename State, typename Slope, typename Visit>
void march(double omega, const Slope& slope, const Visit& visit) {
  constexpr int periods = 60, steps = 8000;
  const double h = 2 * pi / omega / steps;
  State y = State::Zero();
  for (int i = 0; i < periods * steps; ++i) {
    const double t = i * h;
    if (i >= (periods - 1) * steps) visit(t, y);
    const State k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1), k3 = slope(t + h / 2, y + h / 2 * k2),
                k4 = slope(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
}

TEST(Hydromount, BetweenThemAsMarchedInTime) {
  constexpr double omega = 2 * pi * 8, force = 100;
  using State = Eigen::Matrix<double, 6, 1>;  // m.z, its rate, the fluid
  const auto slope = [&](double t, const State& y) {
    State rate;
    const double push = Fluid::area * Fluid::pressure(y(0), y.tail<4>());
    rate << y(1), (force * std::cos(omega * t) - 1.8e5 * y(0) - 90 * y(1) + push) / 100, Fluid::rate(y(0), y.tail<4>());
    return rate;
  };
  double expected = 0;
  march<State>(omega, slope, [&](double, const State& y) { expected = std::max(expected, y(0)); });
  const double lossy = largest(Fluid::mount_of(force));
  EXPECT_THAT(lossy, RelativelyNear(expected, 5e-4));  // 31 harmonics of a seat with a kink
  EXPECT_GT(std::abs(largest(mount(with_decoupler, force)) / expected - 1), 1e-3);  // the quadratic loss counts
}

/// The mount alone: tiny motions are those of the linear law, larger ones as the fluid marches in time under a
/// prescribed deflection.
TEST(Hydromount, StiffnessOverFrequencyAndAmplitude) {
  const project::Project project = test::project(Fluid::mount_of(100));
  const std::vector<nonlinear::AmplitudeStiffness> found =
      nonlinear::stiffness_over_amplitude(project.base().system, 0, 2 * pi * 2, 2 * pi * 40, {1e-9, 5e-4, 2e-3});
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t i = 0; i < found[0].angular_frequency.size(); ++i)
    expect_near(found[0].stiffness(static_cast<Eigen::Index>(i)),
                along_axis(mount(with_decoupler), found[0].angular_frequency[i] / (2 * pi)), 1e-6);
  for (const std::size_t large : {1u, 2u}) {
    const nonlinear::AmplitudeStiffness& one = found[large];
    EXPECT_THAT(one.ended,
                testing::AnyOf("", testing::HasSubstr("30 harmonics leave out")));  // of the kinks of the seat
    const std::size_t middle = one.angular_frequency.size() / 2;
    const double omega = one.angular_frequency[middle], amplitude = one.amplitude;
    const auto z = [&](double t) { return amplitude * std::cos(omega * t); };
    Complex first = 0;
    int samples = 0;
    march<Fluid::State>(
        omega, [&](double t, const Fluid::State& y) { return Fluid::rate(z(t), y); },
        [&](double t, const Fluid::State& y) {
          first -= 2.0 * Fluid::area * Fluid::pressure(z(t), y) * std::polar(1.0, -omega * t);
          ++samples;
        });
    const Complex expected = first / (samples * amplitude) + Complex(1.8e5, 90 * omega);
    expect_near(one.stiffness(static_cast<Eigen::Index>(middle)), expected,
                3e-3);  // harmonics leave out 2 % of the flow
  }
}

}  // namespace hydromount_test
