// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/signal.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/foundation/invalid_input.h"

namespace signal_test {

using namespace trivet;
using namespace trivet::excitation;
using test::RelativelyNear;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = 1e-13;       // some hundred operations on numbers of order 1
constexpr double time_round_off = 1e-12;  // times near 3 s are rounded by 4e-16 s, 4e-14 of a pulse of 11 ms
constexpr double simpsons_error = 1e-9;   // h⁴ u⁗ T/180 with steps of 2 ms and u⁗ of a few hundred
constexpr double time_step = 1e-5;        // [s] of central differences; their error is h² times a third derivative / 6
constexpr double step_error = 1e-8, higher_step_error = 1e-7;  // third derivatives up to 400, and up to 4000

/// Simpson's rule, the second method for every integral here. Only for functions that are smooth on [a, b].
double simpson(const std::function<double(double)>& f, double a, double b, int halves = 400) {
  const double h = (b - a) / (2 * halves);
  double sum = f(a) + f(b);
  for (int i = 1; i < 2 * halves; ++i) sum += (i % 2 ? 4 : 2) * f(a + i * h);
  return sum * h / 3;
}

TEST(Signal, IsZeroBeforeItsFirstPieceAndJumpsAtItsStart) {
  const Signal signal = step(3, 2);
  EXPECT_EQ(state(signal, 1.999).value, 0);
  EXPECT_EQ(state(signal, 2).value, 3);
  EXPECT_EQ(state(signal, 1e9).value, 3);
  EXPECT_EQ(state(Signal{}, 1).value, 0);
}

TEST(Signal, StateContainsTheDerivativesOfItsValue) {
  const double h = time_step;
  for (const Piece& piece : {Piece{1, 2, 3, 4, 0}, Piece{1, 2, 3, 4, 5}, Piece{1, 2, 3, 4, 0.01}}) {
    const SignalState before = state_on(piece, 0.7 - h), here = state_on(piece, 0.7), after = state_on(piece, 0.7 + h);
    EXPECT_NEAR((after.value - before.value) / (2 * h), here.rate, step_error);
    EXPECT_NEAR((after.rate - before.rate) / (2 * h), here.curvature, step_error);
    EXPECT_NEAR((after.curvature - before.curvature) / (2 * h), -piece.kappa * piece.kappa * here.rate,
                higher_step_error);
  }
}

TEST(Signal, ASlowSineTendsToAParabola) {
  const SignalState parabola = state_on({0, 1, 2, 3, 0}, 2), slow = state_on({0, 1, 2, 3, 1e-9}, 2);
  EXPECT_THAT(slow.value, RelativelyNear(parabola.value, round_off));
  EXPECT_THAT(slow.rate, RelativelyNear(parabola.rate, round_off));
  const double slow_integral = integrals({{Piece{0, 1, 2, 3, 1e-5}}}, 2).twice,
               parabola_integral = integrals({{Piece{0, 1, 2, 3, 0}}}, 2).twice;
  constexpr double curved = 1e-9;  // κ²s² = 4e-10
  EXPECT_THAT(slow_integral, RelativelyNear(parabola_integral, curved));
  // Both sides of the change from series to closed form at κs = 1.
  EXPECT_THAT(state_on({0, 1, 2, 3, 1 + 1e-14}, 1).value,
              RelativelyNear(state_on({0, 1, 2, 3, 1 - 1e-14}, 1).value, round_off));
}

TEST(Signal, IntegralsAgreeWithSimpsonsRule) {
  for (const Piece& piece : {Piece{0, 2, 3, 4, 0}, Piece{0, 2, 3, 4, 5}, Piece{0, 2, 3, 4, 0.3}}) {
    const Piece second{1.5, -1, 0.5, 2, 7};
    const auto both = [&](const std::function<double(double)>& weight) {
      return simpson([&](double t) { return weight(t) * state_on(piece, t).value; }, 0, 1.5) +
          simpson([&](double t) { return weight(t) * state_on(second, t - 1.5).value; }, 1.5, 3);
    };
    const SignalIntegrals sum = integrals({{piece, second}}, 3);
    EXPECT_THAT(sum.once, RelativelyNear(both([](double) { return 1.0; }), simpsons_error));
    EXPECT_THAT(sum.twice, RelativelyNear(both([](double t) { return 3 - t; }), simpsons_error));  // ∬u = ∫(t − τ)u dτ
  }
}

TEST(Pulses, ChangeTheVelocityByTheirTextbookAreas) {
  const double A = 490, T = 0.011;
  EXPECT_THAT(integrals(half_sine(A, T, 3), 4).once, RelativelyNear(2 * A * T / pi, round_off));
  EXPECT_THAT(integrals(versed_sine(A, T, 3), 4).once, RelativelyNear(A * T / 2, time_round_off));
  EXPECT_THAT(integrals(terminal_peak_sawtooth(A, T, 3), 4).once, RelativelyNear(A * T / 2, time_round_off));
  EXPECT_THAT(integrals(rectangular(A, T), 4).once, RelativelyNear(A * T, round_off));
  EXPECT_THAT(integrals(trapezoid(A, 0.1, 0.5, 0.2), 4).once, RelativelyNear(A * 0.65, round_off));
  EXPECT_NEAR(integrals(sine_burst(A, 50, 3), 4).once, 0, A / 50 * round_off);
}

TEST(Pulses, ReachTheirAmplitudeAndReturnToZero) {
  EXPECT_THAT(state(half_sine(7, 2, 1), 2).value, RelativelyNear(7, round_off));
  EXPECT_THAT(state(versed_sine(7, 2, 1), 2).value, RelativelyNear(7, round_off));
  constexpr double just_before = 1e-9, slope = 1e-8;  // 1e-9 s before its end it is 5e-10 below its peak
  EXPECT_THAT(state(terminal_peak_sawtooth(7, 2, 1), 3 - just_before).value, RelativelyNear(7, slope));
  EXPECT_THAT(state(triangle(7, 1, 3, 1), 2).value, RelativelyNear(7, round_off));
  EXPECT_THAT(state(sine_burst(7, pi, 2.5, 1), 1.5).value, RelativelyNear(7, round_off));
  EXPECT_THAT(state(ramp(7, 2, 1), 2).value, RelativelyNear(3.5, round_off));
  EXPECT_THAT(state(rounded_step(7, 2, 1), 2).value, RelativelyNear(3.5, round_off));
  for (const Signal& pulse : {half_sine(7, 2, 1), versed_sine(7, 2, 1), trapezoid(7, 1, 0.5, 0.5, 1),
                              triangle(7, 1, 1, 1), rectangular(7, 2, 1)})
    EXPECT_EQ(state(pulse, 3.0001).value, 0);
  EXPECT_EQ(state(ramp(7, 2, 1), 5).value, 7);
  EXPECT_EQ(state(rounded_step(7, 2, 1), 5).value, 7);
}

TEST(Pulses, RejectInvalidDurations) {
  EXPECT_THROW((void)half_sine(1, 0), foundation::InvalidInput);
  EXPECT_THROW((void)half_sine(not_a_number, 1), foundation::InvalidInput);
  EXPECT_THROW((void)rectangular(1, -1), foundation::InvalidInput);
  EXPECT_THROW((void)ramp(1, 0), foundation::InvalidInput);
  EXPECT_THROW((void)trapezoid(1, -1, 3, 1), foundation::InvalidInput);
  EXPECT_THROW((void)triangle(1, 0, 0), foundation::InvalidInput);
  EXPECT_THROW((void)sine_burst(1, 0, 1), foundation::InvalidInput);
  EXPECT_THROW((void)step(1, not_a_number), foundation::InvalidInput);
  EXPECT_THROW((void)half_sine(1, 1e-12, 1e6), foundation::InvalidInput);  // lost in the round-off of its start
}

TEST(Signal, IsDelayedAndScaled) {
  const Signal pulse = half_sine(2, 1);
  EXPECT_THAT(state(delayed(pulse, 5), 5.3).value, RelativelyNear(state(pulse, 0.3).value, round_off));
  EXPECT_THAT(state(scaled(pulse, -3), 0.3).rate, RelativelyNear(-3 * state(pulse, 0.3).rate, round_off));
  EXPECT_THROW((void)delayed(pulse, not_a_number), foundation::InvalidInput);
  EXPECT_THROW((void)delayed(pulse, 1e300), foundation::InvalidInput);
  EXPECT_THROW((void)scaled(pulse, not_a_number), foundation::InvalidInput);
  EXPECT_THROW(require_valid({{Piece{1}, Piece{1}}}), foundation::InvalidInput);
  EXPECT_THROW(require_valid({{Piece{0, 0, 0, 0, -1}}}), foundation::InvalidInput);
}

double angle(const Sweep& sweep, double s) {  // by quadrature of the frequency
  return sweep.phase +
      simpson(
             [&](double t) {
               const double share = t / sweep.duration;
               return sweep.law == Sweep::Law::linear ? sweep.from + (sweep.to - sweep.from) * share
                                                      : sweep.from * std::pow(sweep.to / sweep.from, share);
             },
             0, s);
}

TEST(Sweep, IsWithinItsToleranceEverywhere) {
  using Law = Sweep::Law;
  using Amplitude = Sweep::Amplitude;
  const double slowest = 2 * pi * 2, fastest = 2 * pi * 40;
  constexpr double angle_error = 1e-8;  // [rad] Simpson's rule in steps of 5 ms, and round-off of 500 rad
  constexpr double run_up = 1.2;        // the amplitude at the end of an interval counts
  constexpr double not_wasteful = 0.3;  // not much more accurate than necessary
  constexpr double rate_factor = 4;     // the value is wrong by (2/81)|u‴|h³, the rate by a multiple of |u‴|h²
  constexpr double joint_round_off =
      1e-9;  // times near 5 s are rounded by 1e-15 s, differences by more over short pieces
  for (const Sweep& sweep : {Sweep{3, slowest, fastest, 4, Law::linear, Amplitude::constant, 0.3, 1},
                             Sweep{3, 0, fastest, 4}, Sweep{3, fastest, slowest, 4, Law::logarithmic},
                             Sweep{3, slowest, fastest, 4, Law::logarithmic, Amplitude::speed_squared},
                             Sweep{3, 0, fastest, 4, Law::linear, Amplitude::speed_squared}})
    for (const double tolerance : {1e-3, 1e-5}) {
      const Signal signal = sweep_signal(sweep, tolerance);
      double worst = 0, worst_rate = 0;
      for (int i = 0; i <= 20011; ++i) {
        const double s = sweep.duration * i / 20012;
        const double omega =
            (sweep.law == Law::linear ? sweep.from + (sweep.to - sweep.from) * s / sweep.duration
                                      : sweep.from * std::pow(sweep.to / sweep.from, s / sweep.duration));
        const double amplitude =
            sweep.amplitude * (sweep.amplitude_law == Amplitude::constant ? 1 : std::pow(omega / sweep.to, 2));
        if (i % 50 == 0) {
          EXPECT_NEAR(sweep_state(sweep, s).value, amplitude * std::sin(angle(sweep, s)), angle_error);
        }
        const SignalState state_here = state(signal, sweep.start + s), exact = sweep_state(sweep, s);
        if (omega > slowest / 2) {
          worst = std::max(worst, std::abs(state_here.value - exact.value) / amplitude);
          worst_rate = std::max(worst_rate, std::abs(state_here.rate - exact.rate) / (amplitude * omega));
        }
      }
      EXPECT_LE(worst, run_up * tolerance);
      EXPECT_GE(worst, not_wasteful * tolerance);
      EXPECT_LE(worst_rate, rate_factor * std::pow(tolerance, 2.0 / 3));
      for (std::size_t i = 1; i + 1 < signal.pieces.size(); ++i) {  // value and rate are continuous
        const SignalState end = state_on(signal.pieces[i - 1], signal.pieces[i].start - signal.pieces[i - 1].start);
        ASSERT_NEAR(end.value, signal.pieces[i].value, joint_round_off);
        ASSERT_NEAR(end.rate, signal.pieces[i].rate, joint_round_off * fastest);
      }
      EXPECT_EQ(state(signal, sweep.start + sweep.duration + 1e-9).value, 0);
    }
}

TEST(Sweep, StateContainsTheDerivativesOfItsValue) {
  const double h = time_step;
  for (const auto law : {Sweep::Law::linear, Sweep::Law::logarithmic}) {
    const Sweep sweep{2, 3, 8, 4, law, Sweep::Amplitude::speed_squared, 0.3};
    const SignalState before = sweep_state(sweep, 1.7 - h), here = sweep_state(sweep, 1.7),
                      after = sweep_state(sweep, 1.7 + h);
    EXPECT_NEAR((after.value - before.value) / (2 * h), here.rate, step_error);
    EXPECT_NEAR((after.rate - before.rate) / (2 * h), here.curvature, higher_step_error);
  }
}

TEST(Sweep, RejectsInvalidParameters) {
  EXPECT_THROW((void)sweep_signal({1, 0, 10, 1, Sweep::Law::logarithmic}), foundation::InvalidInput);
  EXPECT_THROW((void)sweep_signal({1, 1, 10, 0}), foundation::InvalidInput);
  EXPECT_THROW((void)sweep_signal({1, -1, 10, 1}), foundation::InvalidInput);
  EXPECT_THROW((void)sweep_signal({1, 1, 0, 1, Sweep::Law::linear, Sweep::Amplitude::speed_squared}),
               foundation::InvalidInput);
  EXPECT_THROW((void)sweep_signal({1, 1, 10, 1}, 0), foundation::InvalidInput);
  EXPECT_THROW((void)sweep_signal({1, 1, 1e9, 1e3}), foundation::NotComputable);
}

TEST(Samples, AreJoinedByStraightLinesAndHeldOrDropped) {
  const Signal held = from_samples({{0, 1, 3}, {0, 2, -2}}),
               dropped = from_samples({{0, 1, 3}, {0, 2, -2}, Samples::Afterwards::zero});
  EXPECT_THAT(state(held, 0.5).value, RelativelyNear(1, round_off));
  EXPECT_NEAR(state(held, 2).value, 0, round_off);
  EXPECT_EQ(state(held, 4).value, -2);
  EXPECT_EQ(state(dropped, 4).value, 0);
}

TEST(Samples, FindingsNameTheRow) {
  const auto first = [](const Samples& samples) { return foundation::message(check(samples, "a.csv").list().at(0)); };
  EXPECT_THAT(first({{0, 2, 1}, {0, 0, 0}}),
              HasSubstr("row 3: time 1 s after 2 s; times must increase; sort the rows"));
  EXPECT_THAT(first({{0, 1, 1}, {0, 0, 0}}), HasSubstr("however close"));
  EXPECT_THAT(first({{0, 1}, {0, not_a_number}}), HasSubstr("row 2: the value is nan"));
  EXPECT_THAT(first({{not_a_number, 1}, {0, 0}}), HasSubstr("row 1: the time is nan"));
  EXPECT_THAT(first({{0}, {0}}), HasSubstr("1 samples"));
  EXPECT_THAT(first({{0, 1}, {0}}), HasSubstr("2 times and 1 values"));
  EXPECT_THAT(first({{0, 1}, {0, 5}}), HasSubstr("the last value is held"));
  EXPECT_THAT(first({{0, 1}, {5, 0}}), HasSubstr("the first value is 5"));
  EXPECT_TRUE(check(Samples{{0, 1}, {0, 0}}, "a").list().empty());
  EXPECT_THROW((void)from_samples({{0, 2, 1}, {0, 0, 0}}), foundation::InvalidInput);
  EXPECT_THROW((void)from_samples({{0, 1e-300}, {0, 1e300}}), foundation::InvalidInput);
}

}  // namespace signal_test
