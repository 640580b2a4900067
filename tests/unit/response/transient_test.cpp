// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/transient.h"
#include "trivet/elements/viscoelastic.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/excitation/signal.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/transient/exponential_step.h"
#include "trivet/response/transient/input_course.h"
#include "trivet/response/transient/state_space.h"
#include "trivet/response/transient/time_stepper.h"

namespace transient_test {

using namespace trivet;
using test::along;
using test::RelativelyNear;
using testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double round_off = 1e-12;  // some hundred operations on numbers near 1

struct Machine {
  project::Project project;
  const model::System& system = project.base().system;
  assembly::Assembled assembled = assembly::assemble(system);
  response::TimeInput push(const excitation::Signal& signal) const {
    return test::force_on(assembled, 0, signal, along(0));
  }
};

/// 2 kg on 800 N/m: 20 rad/s, 3.18 Hz.
Machine one_mass(const std::vector<double>& dashpots = {}) {
  return {test::project(test::chain({2}, {800, 0}, dashpots))};
}

response::TransientOptions until(double to, double step) {
  response::TransientOptions options;
  options.to = to;
  options.step = step;
  return options;
}

std::string warnings(const response::TransientResponse& r) {
  std::string all;
  for (const auto& problem : r.warnings.list()) all += message(problem) + "\n";
  return all;
}

/// A half sine is 0 at both of its ends, up to the round-off of sin π, which is no jump.
TEST(InputCourse, RoundOffAtTheEndOfAHalfSineIsNoJump) {
  const excitation::Signal half_sine = excitation::half_sine(55, 0.0787), box = excitation::rectangular(55, 0.0787),
                           versed_sine = excitation::versed_sine(55, 0.0787);
  EXPECT_EQ(response::InputCourse(half_sine, 0).smoothness(), 1);
  EXPECT_EQ(response::InputCourse(box, 0).smoothness(), 0);
  EXPECT_EQ(response::InputCourse(versed_sine, 0).smoothness(), 2);
}

TEST(ExponentialStep, TurnsAnOscillatorByItsAngleOnEveryLevel) {
  Eigen::Matrix2d F;
  F << 0, 7, -7, 0;
  const response::ExponentialStep exponential(F, 1.3, 0);
  EXPECT_GT(exponential.levels(), 4u);
  for (std::size_t level = 0; level < exponential.levels(); ++level) {
    const double angle = std::ldexp(7 * 1.3, -static_cast<int>(level));
    EXPECT_NEAR(exponential.state(level)(0, 1), std::sin(angle), round_off);
    EXPECT_NEAR(exponential.state(level)(0, 0), std::cos(angle), round_off);
  }
}

TEST(ExponentialStep, IntegratesTheInputAndItsIntegrals) {
  // ẋ = w_m alone: x(h) is the integral of the quantity of the mth column, a cos-like series in κ for ∬u.
  const double h = 0.8, kappa = 3;
  const Eigen::MatrixXd zero_system = Eigen::MatrixXd::Zero(1, 1);
  const response::ExponentialStep exponential(zero_system, h, kappa);
  response::InputMatrix G = response::InputMatrix::Zero(1, 5);
  G(0, response::of_value) = 1;
  const auto gamma = exponential.input(G, kappa)[0];
  EXPECT_NEAR(gamma(0, 2), h, round_off);                                                    // of u
  EXPECT_NEAR(gamma(0, 3), (1 - std::cos(kappa * h)) / (kappa * kappa), round_off);          // of u̇
  EXPECT_NEAR(gamma(0, 4), (h - std::sin(kappa * h) / kappa) / (kappa * kappa), round_off);  // of ü
  G.setZero();
  G(0, 0) = 1;
  const auto twice = exponential.input(G, 0)[0];
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(twice(0, i), std::pow(h, i + 1) / std::tgamma(i + 2), round_off);
}

/// A mass m on a spring k1 to a node without mass or damping, which has a spring k2; the force acts on the node.
TEST(StateSpace, LetsACoordinateWithoutMassAndDampingFollowStatically) {
  const double mass = 2, k1 = 900, k2 = 300;
  numerics::DynamicMatrices m;
  m.A = Eigen::Vector2d(mass, 0).asDiagonal();
  m.B = Eigen::Matrix2d::Zero();
  m.K.resize(2, 2);
  m.K << k1, -k1, -k1, k1 + k2;
  response::Drive drive{response::InputMatrix::Zero(2, 5), response::InputMatrix::Zero(6, 5)};
  drive.force(1, response::of_value) = 1;
  const response::StateSpace space(m, {drive});
  const excitation::Signal step = excitation::step(1);
  const std::vector<response::InputCourse> courses = {response::InputCourse(step, 0)};
  response::TimeStepper stepper(space, courses, 0.01, 1e-15);
  response::StepperState state{0, Eigen::VectorXd::Zero(space.size()), {-1}};
  stepper.apply_corners(state);
  stepper.advance(state, 0.37);
  // The share k1/(k1 + k2) of the force acts on the mass, which is on the springs in series; the node is between them.
  const double series = k1 * k2 / (k1 + k2), omega = std::sqrt(series / mass),
               q = k1 / (k1 + k2) / series * (1 - std::cos(omega * 0.37));
  Eigen::VectorXd inputs(response::input_derivatives);
  stepper.inputs(state, inputs);
  const Eigen::VectorXd both = space.displacements().on_state * state.x + space.displacements().on_input * inputs;
  EXPECT_THAT(both(0), RelativelyNear(q, round_off));
  EXPECT_THAT(both(1), RelativelyNear((1 + k1 * q) / (k1 + k2), round_off));
}

TEST(StateSpace, RejectsAnUnconstrainedCoordinate) {
  numerics::DynamicMatrices m;
  m.A = Eigen::Vector2d(2, 0).asDiagonal();
  m.B = Eigen::Matrix2d::Zero();
  m.K = Eigen::Vector2d(100, 0).asDiagonal();
  EXPECT_THROW(response::StateSpace(m, {}), foundation::NotComputable);
}

TEST(Transient, ProposesAZenerLawWithTheSameLossAndStiffness) {
  constexpr double printed_digits = 1e-3;  // three or four digits of a law
  // The numbers of the message for η = 0.1 at 20 rad/s.
  const std::complex<double> modulus = 0.9095 * elements::relative_modulus(elements::Zener{0.221, 0.04525}, 20.0);
  EXPECT_NEAR(modulus.real(), 1, printed_digits);
  EXPECT_NEAR(modulus.imag() / modulus.real(), 0.1, printed_digits);
  // … and of B = ηK/ω: 0.005 s.
  EXPECT_NEAR(20 * 0.005, 0.1, round_off);
}

TEST(Transient, RejectsAFractionalLawUnlessTheNearestSystemIsRequested) {
  const Machine m{test::project(
      "trivet = 1\n[bodies.b]\nmass = 2\nfree = [\"x\"]\n[elements.s]\ntype = \"three_springs\"\non = \"b\"\nat = [0, "
      "0, 0]\n"
      "translation = [800, 0, 0]\ndamping = {fractional_zener = {ratio = 0.5, time = 0.01, order = 0.5}}\n")};
  const auto base = test::base_motion(m.assembled, excitation::step(0.01), along(0));
  try {
    static_cast<void>(test::transient(m.system, m.assembled, {"b.x", "s"}, {base}, until(60, 0.01)));
    FAIL() << "it was computed";
  } catch (const foundation::NotComputable& reason) {
    EXPECT_THAT(reason.what(), HasSubstr("\"s\""));
    EXPECT_THAT(reason.what(), HasSubstr("nearest linear system"));
  }
  response::TransientOptions options = until(60, 0.01);
  options.nearest_linear_system = true;
  const auto r = test::transient(m.system, m.assembled, {"b.x", "s"}, {base}, options);
  EXPECT_THAT(warnings(r), HasSubstr("nearest linear system"));
  constexpr double motion_left = 1e-6, force_left = 1e-3;  // [m], [N] of the slow relaxations after 60 s; 800 N/m
  const Eigen::Index last = r.time.size() - 1;
  EXPECT_NEAR(test::curve(r, "b.x").values(last), 0.01, motion_left);    // it comes to rest on the displaced ground …
  EXPECT_NEAR(test::curve(r, "s.force.x").values(last), 0, force_left);  // … and the element has no force
}

TEST(Transient, RejectsPhasesAndForeignLoads) {
  const Machine m = one_mass(), other{test::project(test::chain({1, 1}, {1, 1, 0}, {}))};
  response::TimeInput input = m.push(excitation::step(1));
  input.loading = assembly::Loading(Eigen::VectorXcd::Constant(1, {0, 1}).eval());
  EXPECT_THROW(static_cast<void>(test::transient(m.system, m.assembled, {"m1.x"}, {input}, until(1, 0.1))),
               foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(
                   test::transient(m.system, m.assembled, {"m1.x"}, {other.push(excitation::step(1))}, until(1, 0.1))),
               foundation::InvalidInput);
}

TEST(Transient, RejectsTimesOutOfRangeAndMissingInputs) {
  const Machine m = one_mass();
  const std::vector inputs = {m.push(excitation::step(1))};
  const auto run = [&](const response::TransientOptions& options) {
    static_cast<void>(test::transient(m.system, m.assembled, {"m1.x"}, inputs, options));
  };
  EXPECT_THROW(run(until(0, 0.1)), foundation::InvalidInput);
  EXPECT_THROW(run(until(std::numeric_limits<double>::quiet_NaN(), 0.1)), foundation::InvalidInput);
  EXPECT_THROW(run(until(1, 0)), foundation::InvalidInput);
  EXPECT_THROW(run(until(1, -1)), foundation::InvalidInput);
  EXPECT_THROW(run(until(1e6, 1e-12)), foundation::InvalidInput);
  response::TransientOptions wrong = until(1, 0.1);
  wrong.initial = response::InitialState{Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)};
  EXPECT_THROW(run(wrong), foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(test::transient(m.system, m.assembled, {"m1.x"}, {}, until(1, 0.1))),
               foundation::InvalidInput);
}

TEST(Transient, ChoosesItsOwnTimes) {
  const Machine m = one_mass();
  const auto r = test::transient(m.system, m.assembled, {"m1.x"}, {m.push(excitation::step(1, 0.5))}, {});
  const double period = 2 * pi / 20;
  constexpr double time_round_off = 1e-9;  // [s] of a sum of steps
  EXPECT_NEAR(r.time(r.time.size() - 1), 0.5 + 10 * period, time_round_off);
  EXPECT_LE(r.time(1), period / 20);  // at least 20 points in a period
  EXPECT_GT(r.time(1), period / 22);  // and not many more
  EXPECT_TRUE(r.warnings.list().empty()) << warnings(r);
}

TEST(Transient, WarnsAboutAStepTooCoarseToShowTheMotion) {
  const Machine m = one_mass();
  const std::vector inputs = {m.push(excitation::step(1))};
  EXPECT_THAT(warnings(test::transient(m.system, m.assembled, {"m1.x"}, inputs, until(2, 0.05))),
              HasSubstr("6.28 points in a period of the mode at 3.183 Hz"));
  EXPECT_EQ(warnings(test::transient(m.system, m.assembled, {"m1.x"}, inputs, until(2, 0.03))), "");
  response::TransientOptions few;
  few.to = 100;
  few.most_points = 500;
  EXPECT_THAT(warnings(test::transient(m.system, m.assembled, {"m1.x"}, inputs, few)), HasSubstr("allow more points"));
}

TEST(Transient, WarnsAboutSamplesTooFarApartForTheFastestMode) {
  const Machine m = one_mass();
  const auto sampled = [&](double step) {
    excitation::Samples samples;
    for (int i = 0; i < 40; ++i) samples.times.push_back(step * i), samples.values.push_back(std::sin(0.8 * i));
    return warnings(
        test::transient(m.system, m.assembled, {"m1.x"}, {m.push(excitation::from_samples(samples))}, until(2, 0.01)));
  };
  EXPECT_THAT(sampled(0.25), HasSubstr("Nyquist frequency 2 Hz"));
  EXPECT_THAT(sampled(0.25), HasSubstr("contain no motion above"));
  EXPECT_THAT(sampled(0.1), HasSubstr("reproduce 71 % of a motion"));  // sinc²(0.318)
  EXPECT_EQ(sampled(0.03), "");
}

TEST(Transient, ComputesAnUnstableSystemAndWarnsUntilNumbersEnd) {
  // One mass on a spring of −200 N/m: e^{10 t}, doubling every ln 2/10 s.
  Machine m = one_mass();
  m.assembled.matrices.K(0, 0) = -200;
  response::TransientOptions options = until(3, 0.01);
  options.initial =
      response::initial_state(m.assembled, Eigen::VectorXd::Constant(1, 1e-3), Eigen::VectorXd::Constant(1, 0));
  const auto r = test::transient(m.system, m.assembled, {"m1.x"}, {}, options);
  constexpr double growing_round_off = 1e-11;  // 300 steps, each with the rounding of the exponential
  EXPECT_THAT(r.curves[0].values(300), RelativelyNear(1e-3 * std::cosh(30), growing_round_off));
  EXPECT_THAT(warnings(r), HasSubstr("doubles every 0.06931 s"));
  options.to = 100;
  EXPECT_THROW(static_cast<void>(test::transient(m.system, m.assembled, {"m1.x"}, {}, options)),
               foundation::NotComputable);
}

TEST(Transient, ReportsProgressAndStopsOnAnInterruption) {
  const Machine m = one_mass();
  int calls = 0;
  const auto progress = [&](std::string_view, double fraction) {
    EXPECT_LE(fraction, 1);
    if (++calls == 3) throw foundation::Interrupted();
  };
  EXPECT_THROW(static_cast<void>(response::transient_response(
                   m.system, m.assembled,
                   assembly::channels(m.system, m.assembled, {"m1.x"}, assembly::MotionQuantity::displacement),
                   {m.push(excitation::step(1))}, until(100, 0.01), progress)),
               foundation::Interrupted);
}

TEST(Transient, RmsOfAWholeNumberOfPeriodsIsThatOfASine) {
  const Machine m = one_mass();
  response::TransientOptions options = until(2 * pi, 2 * pi / 4000);
  options.initial =
      response::initial_state(m.assembled, Eigen::VectorXd::Constant(1, 0.004), Eigen::VectorXd::Constant(1, 0));
  constexpr double round_off_of_steps = 1e-9;  // 4000 steps; the sum over whole periods is exact
  EXPECT_THAT(test::transient(m.system, m.assembled, {"m1.x"}, {}, options).curves[0].rms,
              RelativelyNear(0.004 / std::sqrt(2.0), round_off_of_steps));
}

TEST(Transient, AppliesJumpsAtItsStartAfterTheInitialState) {
  // The base, and the body with it, have been at 0.01 m for a long time: nothing moves. A force that jumps at the start
  // acts.
  const Machine m = one_mass({30});
  response::TransientOptions options = until(3, 0.01);
  options.from = 2;
  options.initial = response::initial_state(m.assembled, Eigen::VectorXd::Constant(1, 0.01), Eigen::VectorXd::Zero(1));
  constexpr double at_rest = 1e-14;  // [m] round-off of 100 steps at 0.01 m
  const auto base = test::base_motion(m.assembled, excitation::step(0.01, 0.5), along(0));
  EXPECT_LE((test::transient(m.system, m.assembled, {"m1.x"}, {base}, options).curves[0].values.array() - 0.01)
                .abs()
                .maxCoeff(),
            at_rest);
  const auto pushed = test::transient(m.system, m.assembled, {"m1.x"}, {base, m.push(excitation::step(8, 2))}, options,
                                      assembly::MotionQuantity::acceleration);
  EXPECT_THAT(pushed.curves[0].values(0), RelativelyNear(4.0, round_off));
}

}  // namespace transient_test
