// SPDX-License-Identifier: BSD-3-Clause
// Motions in time against closed forms and published cases.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/transient.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/excitation/shock_spectrum.h"
#include "trivet/foundation/invalid_input.h"

namespace transient_test {

using namespace trivet;
using test::along;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;
constexpr double round_off = 1e-11;      // some hundred steps, each exact to round-off
constexpr double extreme_height = 1e-9;  // of a flat extreme, found between two steps

struct Machine {
  project::Project project;
  const model::System& system = project.base().system;
  assembly::Assembled assembled = assembly::assemble(system);
};

Machine chain(const std::vector<double>& masses, const std::vector<double>& springs,
              const std::vector<double>& dashpots = {}) {
  return {test::project(test::chain(masses, springs, dashpots))};
}

response::TransientOptions until(double to, double step) {
  response::TransientOptions options;
  options.to = to;
  options.step = step;
  return options;
}

// One mass of 2 kg on a spring of 800 N/m: ω = 20 rad/s.
constexpr double mass = 2, stiffness = 800, omega = 20;

TEST(Transient, SineFromRestAgreesWithThePublishedCase) {
  // EDF code_aster SDLD31: m = 1, k = (2π3)², F = sin(1.1·2π3 t); closed form as published there.
  constexpr double all_digits = 1e-9;  // of the closed form
  const Machine m = chain({1}, {36 * pi * pi, 0});
  const auto sine = excitation::sine_burst(1, 1.1 * 6 * pi, 100);
  const auto u =
      test::transient(m.system, m.assembled, {"m1.x"}, {test::force_on(m.assembled, 0, sine, along(0))}, until(1, 0.1));
  const auto a = test::transient(m.system, m.assembled, {"m1.x"}, {test::force_on(m.assembled, 0, sine, along(0))},
                                 until(1, 0.1), assembly::MotionQuantity::acceleration);
  const int at[] = {5, 7, 10};
  const double displacement[] = {0.010842666594819608, -0.00379569402569434, -0.012746319039918437};
  const double acceleration[] = {-4.66147887235089, 2.2784084304907837, 5.479897070081606};
  for (int i = 0; i < 3; ++i) {
    EXPECT_THAT(u.curves[0].values(at[i]), RelativelyNear(displacement[i], all_digits));
    EXPECT_THAT(a.curves[0].values(at[i]), RelativelyNear(acceleration[i], all_digits));
  }
}

TEST(Transient, AcceleratedBaseAgreesWithThePublishedCase) {
  // SFM VPCS SDLD04: three masses of 1 kg on springs of 1000 N/m, base acceleration 2e5 t² m/s², last mass relative to
  // the base.
  constexpr double all_digits = 1e-9;  // of the closed form
  const Machine m = chain({1, 1, 1}, {1000, 1000, 1000, 0});
  const excitation::Signal square{{{0, 0, 0, 4e5, 0}}};
  const auto r = test::transient(m.system, m.assembled, {"m3.relative.x"},
                                 {test::base_motion(m.assembled, square, along(0), 2)}, until(0.1, 0.01));
  const int at[] = {2, 4, 5, 6, 8, 10};
  const double relative[] = {-0.002666665554880359, -0.042665578592795364, -0.1041568701264996,
                             -0.21594178847874992,  -0.6817349917048732,   -1.6590608015174797};
  for (int i = 0; i < 6; ++i) EXPECT_THAT(r.curves[0].values(at[i]), RelativelyNear(relative[i], all_digits)) << at[i];
}

TEST(Transient, DampedMassUnderAStepHasTheClosedFormAndItsOvershoot) {
  const double dashpot = 8, zeta = dashpot / (2 * mass * omega), damped = omega * std::sqrt(1 - zeta * zeta), force = 5;
  const Machine m = chain({mass}, {stiffness, 0}, {dashpot});
  const auto r =
      test::transient(m.system, m.assembled, {"m1.x"},
                      {test::force_on(m.assembled, 0, excitation::step(force, 0.013), along(0))}, until(2, 0.031));
  for (Eigen::Index i = 0; i < r.time.size(); ++i) {
    const double t = r.time(i) - 0.013;
    const double x = t < 0 ? 0
                           : force / stiffness *
            (1 - std::exp(-zeta * omega * t) * (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t)));
    EXPECT_NEAR(r.curves[0].values(i), x, round_off * force / stiffness);
  }
  EXPECT_THAT(r.curves[0].largest.value,
              RelativelyNear(force / stiffness * (1 + std::exp(-zeta * omega * pi / damped)), extreme_height));
  constexpr double extreme_time = 1e-6;  // s: a flat extreme
  EXPECT_NEAR(r.curves[0].largest.time, 0.013 + pi / damped, extreme_time);
  EXPECT_NEAR(r.curves[0].smallest.value, 0, round_off * force / stiffness);
}

TEST(Transient, UndampedMassUnderARampHasTheClosedForm) {
  const double rise = 0.37, force = 5;
  const Machine m = chain({mass}, {stiffness, 0});
  const auto r =
      test::transient(m.system, m.assembled, {"m1.x"},
                      {test::force_on(m.assembled, 0, excitation::ramp(force, rise), along(0))}, until(3, 0.01));
  const auto ramp = [&](double t) {
    return t < 0 ? 0 : force / (stiffness * rise) * (t - std::sin(omega * t) / omega);
  };
  constexpr double of_a_difference = 10 * round_off;  // of two ramps, eight times as high
  for (Eigen::Index i = 0; i < r.time.size(); ++i)
    EXPECT_NEAR(r.curves[0].values(i), ramp(r.time(i)) - ramp(r.time(i) - rise), of_a_difference * force / stiffness);
}

TEST(Transient, UndampedMassUnderAHalfSineHasTheClosedForm) {
  const double duration = 0.11, force = 5, w = pi / duration;
  const Machine m = chain({mass}, {stiffness, 0});
  const auto r = test::transient(m.system, m.assembled, {"m1.x"},
                                 {test::force_on(m.assembled, 0, excitation::half_sine(force, duration), along(0))},
                                 until(1, 0.009));
  const auto sine = [&](double t) {
    return t < 0 ? 0 : force / (mass * (omega * omega - w * w)) * (std::sin(w * t) - w / omega * std::sin(omega * t));
  };
  for (Eigen::Index i = 0; i < r.time.size(); ++i)
    EXPECT_NEAR(r.curves[0].values(i), sine(r.time(i)) + sine(r.time(i) - duration), round_off * force / stiffness);
}

TEST(Transient, JumpOfTheBaseStartsWithTheImpulseOfTheDamper) {
  // x(t)/Δ = 1 − e^{−ζωt}(cos ω_d t − ζω/ω_d sin ω_d t): its velocity starts with cΔ/m.
  const double dashpot = 16, zeta = dashpot / (2 * mass * omega), damped = omega * std::sqrt(1 - zeta * zeta),
               height = 0.01;
  const Machine m = chain({mass}, {stiffness, 0}, {dashpot});
  const auto inputs = std::vector{test::base_motion(m.assembled, excitation::step(height), along(0))};
  const auto r = test::transient(m.system, m.assembled, {"m1.x", "m1.relative.x"}, inputs, until(1, 0.01));
  const auto v =
      test::transient(m.system, m.assembled, {"m1.x"}, inputs, until(1, 0.01), assembly::MotionQuantity::velocity);
  for (Eigen::Index i = 0; i < r.time.size(); ++i) {
    const double t = r.time(i);
    const double x = height *
        (1 - std::exp(-zeta * omega * t) * (std::cos(damped * t) - zeta * omega / damped * std::sin(damped * t)));
    EXPECT_NEAR(test::curve(r, "m1.x").values(i), x, round_off * height);
    EXPECT_NEAR(test::curve(r, "m1.relative.x").values(i), x - height, round_off * height);
  }
  EXPECT_THAT(v.curves[0].values(0), RelativelyNear(dashpot * height / mass, round_off));
}

TEST(Transient, WarnsThatForcesOfDampersOnAJumpingBaseAreImpulses) {
  const Machine m = chain({mass}, {stiffness, 0}, {16});
  const auto inputs = std::vector{test::base_motion(m.assembled, excitation::step(0.01), along(0))};
  const auto force = test::transient(m.system, m.assembled, {"ground"}, inputs, until(1, 0.01));
  ASSERT_EQ(force.warnings.list().size(), 1u);
  EXPECT_THAT(message(force.warnings.list()[0]), testing::HasSubstr("ground.force.x"));
  EXPECT_TRUE(test::transient(m.system, m.assembled, {"m1.x"}, inputs, until(1, 0.01)).warnings.list().empty());
}

TEST(Transient, FreeBodyUnderAForceDriftsExactly) {
  const Machine m = chain({3, 5}, {0, 700, 0});
  const double force = 2, duration = 0.25;
  const auto r = test::transient(m.system, m.assembled, {"m1.x", "m2.x"},
                                 {test::force_on(m.assembled, 0, excitation::rectangular(force, duration), along(0))},
                                 until(10000, 100));
  const Eigen::VectorXd centre = (3 * test::curve(r, "m1.x").values + 5 * test::curve(r, "m2.x").values) / 8;
  for (Eigen::Index i = 1; i < r.time.size(); ++i)
    EXPECT_THAT(centre(i), RelativelyNear(force * duration / 8 * (r.time(i) - duration / 2), round_off));
}

TEST(Transient, InitialStateStartsTheFreeVibration) {
  const Machine m = chain({mass}, {stiffness, 0});
  response::TransientOptions options = until(40, 0.05);
  options.initial =
      response::initial_state(m.assembled, Eigen::VectorXd::Constant(1, 0.003), Eigen::VectorXd::Constant(1, -0.1));
  const auto r = test::transient(m.system, m.assembled, {"m1.x"}, {}, options);
  for (Eigen::Index i = 0; i < r.time.size(); ++i)
    EXPECT_NEAR(r.curves[0].values(i), 0.003 * std::cos(omega * r.time(i)) - 0.1 / omega * std::sin(omega * r.time(i)),
                round_off * 0.006);
  EXPECT_THAT(r.curves[0].largest.value, RelativelyNear(std::hypot(0.003, 0.1 / omega), extreme_height));
}

TEST(Transient, ExtremesOfTheAccelerationAreThoseOfTheShockResponseSpectrum) {
  // Half sine of 500 m/s² and 11 ms at the base; four points per period, the peak is between them.
  constexpr double two_searches = 1e-8;  // for the extreme, here and in the spectrum
  const double zeta = 0.05;
  const excitation::Signal shock = excitation::half_sine(500, 0.011);
  for (const double frequency_hz : {15.0, 40.0, 120.0}) {
    const double w = 2 * pi * frequency_hz;
    const Machine m = chain({1}, {w * w, 0}, {2 * zeta * w});
    const auto r =
        test::transient(m.system, m.assembled, {"m1.x"}, {test::base_motion(m.assembled, shock, along(0), 2)},
                        until(0.011 + 2 / frequency_hz, 0.25 / frequency_hz), assembly::MotionQuantity::acceleration);
    const auto spectrum = excitation::shock_spectrum(shock, {w}, zeta);
    EXPECT_THAT(r.curves[0].largest.value, RelativelyNear(spectrum[0].largest(), two_searches)) << frequency_hz;
    EXPECT_THAT(r.curves[0].smallest.value, RelativelyNear(spectrum[0].smallest(), two_searches)) << frequency_hz;
  }
}

TEST(Transient, FindsBothSidesOfAJumpBetweenItsPoints) {
  // A sawtooth of force ends between two points: the acceleration is largest just before the end.
  const Machine m = chain({mass}, {1e-3, 0});
  const auto r =
      test::transient(m.system, m.assembled, {"m1.x"},
                      {test::force_on(m.assembled, 0, excitation::terminal_peak_sawtooth(6, 0.015), along(0))},
                      until(0.1, 0.01), assembly::MotionQuantity::acceleration);
  constexpr double soft_spring = 1e-6;      // its force is 2e-8 of the sawtooth
  constexpr double time_of_a_jump = 1e-12;  // s: given, not searched for
  EXPECT_THAT(r.curves[0].largest.value, RelativelyNear(6 / mass, soft_spring));
  EXPECT_NEAR(r.curves[0].largest.time, 0.015, time_of_a_jump);
}

TEST(Transient, KeepsTheEnergyOfAnUndampedMachineOverAHundredThousandSteps) {
  constexpr double drift = 1e-11;  // 100,000 roundings of a rotation; 5e-13 is measured
  const Machine m = chain({1, 2, 0.5}, {4e4, 3e3, 9e4, 0});
  response::TransientOptions options = until(1000, 0.01);
  options.initial =
      response::initial_state(m.assembled, Eigen::Vector3d(1e-3, -2e-3, 3e-3), Eigen::Vector3d(0.1, 0, -0.2));
  const auto q = test::transient(m.system, m.assembled, {"coordinates"}, {}, options);
  const auto v =
      test::transient(m.system, m.assembled, {"coordinates"}, {}, options, assembly::MotionQuantity::velocity);
  const auto energy = [&](Eigen::Index i) {
    Eigen::Vector3d x, dx;
    for (int k = 0; k < 3; ++k) x(k) = q.curves[k].values(i), dx(k) = v.curves[k].values(i);
    return x.dot(m.assembled.matrices.K * x) + dx.dot(m.assembled.matrices.A * dx);
  };
  ASSERT_EQ(q.time.size(), 100001);
  EXPECT_THAT(energy(100000), RelativelyNear(energy(0), drift));
}

TEST(Transient, RejectsALossFactorAndNamesItsEquivalents) {
  const Machine m{test::project(test::chain({mass}, {stiffness, 0}, {}, {0.1}))};
  try {
    static_cast<void>(test::transient(m.system, m.assembled, {"m1.x"},
                                      {test::force_on(m.assembled, 0, excitation::step(1), along(0))}, until(1, 0.01)));
    FAIL() << "it was computed";
  } catch (const foundation::NotComputable& reason) {
    EXPECT_THAT(reason.what(), testing::HasSubstr("loss factor 0.1 of \"k1\""));
    EXPECT_THAT(reason.what(), testing::HasSubstr("3.183 Hz"));
    EXPECT_THAT(reason.what(), testing::HasSubstr("proportional = \"0.005 s\""));
    EXPECT_THAT(reason.what(), testing::HasSubstr("zener = {ratio = 0.221, time = \"0.04525 s\"}} with scale 0.9095"));
  }
}

}  // namespace transient_test
