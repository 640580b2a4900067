// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/hysteresis_loop.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"

namespace hysteresis_loop_test {

using namespace trivet;
using namespace trivet::identification;
using testing::HasSubstr;

constexpr double pi = std::numbers::pi, omega = 2 * pi * 7.3, amplitude = 4e-4, stiffness = 2.5e5, loss = 0.12;
constexpr double frequency_error = 1e-8;  // its search ends at changes of 1e-9 rad over the record

/// Record with a loss factor of 0.12 at 7.3 Hz: 250 kN/m, 0.4 mm, offset and drift, noise relative to the amplitudes.
struct HarmonicTest {
  double cycles = 6.4;
  int samples = 900;
  double noise = 0;
  double drift = 0.3;  // of the amplitude over the record
  unsigned seed = 1;

  LoopRecord record() const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    LoopRecord record{"7.3 Hz", {}, {}, {}};
    record.time = Eigen::VectorXd::LinSpaced(samples, 3, 3 + cycles * 2 * pi / omega);
    const Eigen::ArrayXd phase = omega * record.time.array(), along = Eigen::ArrayXd::LinSpaced(samples, 0, 1);
    record.displacement = amplitude * (phase.cos() + 1.7 + drift * along);
    record.force = stiffness * amplitude * (phase.cos() - loss * phase.sin() - 3 + 2 * drift * along);
    for (int i = 0; i < samples; ++i) {
      record.displacement(i) += noise * amplitude * normal(random);
      record.force(i) += noise * stiffness * amplitude * normal(random);
    }
    return record;
  }
};

std::string first_problem(const LoopRecord& record) {
  const auto loop = loop_fit(record);
  return loop ? "a loop" : foundation::message(loop.error().list().front());
}

TEST(LoopFit, ACleanLoopIsRecoveredDespiteOffsetAndDrift) {
  constexpr double round_off = 1e-9;  // normal equations of 13 columns
  const LoopFit loop = loop_fit(HarmonicTest().record()).value();
  EXPECT_EQ(loop.cycles, 6);
  EXPECT_THAT(*loop.angular_frequency, test::RelativelyNear(omega, round_off));
  EXPECT_THAT(loop.amplitude.value, test::RelativelyNear(amplitude, round_off));
  EXPECT_THAT(loop.stiffness.value, test::RelativelyNear(stiffness, round_off));
  EXPECT_THAT(loop.loss_factor.value, test::RelativelyNear(loss, round_off));
  EXPECT_THAT(loop.loss_energy.value, test::RelativelyNear(pi * stiffness * loss * amplitude * amplitude, round_off));
  EXPECT_THAT(loop.viscous_coefficient->value, test::RelativelyNear(stiffness * loss / omega, round_off));
  EXPECT_LE(loop.force_distortion, round_off);
  EXPECT_TRUE(loop.warnings.list().empty());
}

TEST(LoopFit, OneClosedLoopWithoutTimeIsEnough) {
  constexpr double one_cycle = 1e-7;  // the search ends at 1e-9 rad over the record, 1e-8 of the loss angle
  HarmonicTest one;
  one.cycles = 1;
  one.drift = 0;
  LoopRecord record = one.record();
  record.time.resize(0);
  const LoopFit loop = loop_fit(record).value();
  EXPECT_EQ(loop.cycles, 1);
  EXPECT_FALSE(loop.viscous_coefficient.has_value());
  EXPECT_THAT(loop.loss_factor.value, test::RelativelyNear(loss, one_cycle));
  record.angular_frequency = omega;
  EXPECT_THAT(loop_fit(record)->viscous_coefficient->value, test::RelativelyNear(stiffness * loss / omega, one_cycle));
}

TEST(LoopFit, IntervalsContainTheTruthAtTheirConfidence) {
  constexpr int rigs = 600;
  constexpr double fewest = 0.923, most = 0.977;  // 95 % ± 2.7 %: three standard deviations of the simulation
  for (const double noise : {0.01, 0.05}) {
    int k = 0, eta = 0, c = 0, w = 0, x = 0;
    for (unsigned seed = 0; seed < rigs; ++seed) {
      const LoopFit loop =
          loop_fit(HarmonicTest{6.4, 400, noise, 0.3, seed + (noise > 0.02 ? 5000u : 0u)}.record()).value();
      const auto holds = [](const Estimate& estimate, double truth) {
        return std::abs(estimate.value - truth) <= estimate.half_width;
      };
      k += holds(loop.stiffness, stiffness);
      eta += holds(loop.loss_factor, loss);
      c += holds(*loop.viscous_coefficient, stiffness * loss / omega);
      w += holds(loop.loss_energy, pi * stiffness * loss * amplitude * amplitude);
      x += holds(loop.amplitude, amplitude);
    }
    for (const int held : {k, eta, c, w, x}) {
      EXPECT_GE(held, fewest * rigs) << "noise " << noise;
      EXPECT_LE(held, most * rigs) << "noise " << noise;
    }
  }
}

TEST(LoopFit, HigherHarmonicsOfTheForceDoNotChangeTheStiffness) {
  LoopRecord record = HarmonicTest().record();
  record.force.array() += 0.2 * stiffness * amplitude * (3 * omega * record.time.array() + 0.4).cos();
  const LoopFit loop = loop_fit(record).value();
  constexpr double of_loss = 0.01;  // the loss raises the force to √(1 + 0.12²) of its elastic part
  EXPECT_NEAR(loop.force_distortion, 0.2, of_loss);
  EXPECT_THAT(loop.stiffness.value, test::RelativelyNear(stiffness, frequency_error));
  EXPECT_THAT(loop.loss_energy.value,
              test::RelativelyNear(pi * stiffness * loss * amplitude * amplitude, frequency_error));
}

TEST(LoopFit, TheEnergyIsTheAreaOfTheLoop) {
  LoopRecord record =
      HarmonicTest{1, 2001, 0, 0, 1}.record();  // the motion is distorted: the energy of every harmonic counts
  record.displacement.array() += 0.1 * amplitude * (2 * omega * record.time.array()).sin();
  record.force.array() += 0.3 * stiffness * amplitude * (2 * omega * record.time.array()).cos();
  double area = 0;
  for (Eigen::Index i = 1; i < 2001; ++i)
    area += 0.5 * (record.force(i) + record.force(i - 1)) * (record.displacement(i) - record.displacement(i - 1));
  const LoopFit loop = loop_fit(record).value();
  constexpr double trapezia = 1e-5;  // (2π/2000)²
  EXPECT_THAT(loop.loss_energy.value, test::RelativelyNear(area, trapezia));
  EXPECT_THAT(foundation::message(loop.warnings.list().front()), HasSubstr("harmonics of the displacement are 10 %"));
}

TEST(LoopFit, CyclesThatDoNotRepeatWidenTheIntervals) {
  LoopRecord steady = HarmonicTest{20, 2000, 0.01, 0, 1}.record(), fading = steady;
  for (Eigen::Index i = 0; i < 2000; ++i) fading.force(i) *= 1 + 0.4 * std::exp(-static_cast<double>(i) / 200);
  const LoopFit good = loop_fit(steady).value(), bad = loop_fit(fading).value();
  constexpr double by_noise = 1.4;  // white noise stays below 1.27 in 99.5 % of the records
  constexpr double warned = 1.5;
  EXPECT_LE(good.cycle_scatter, by_noise);
  EXPECT_GT(bad.cycle_scatter, warned);
  EXPECT_GT(bad.stiffness.half_width, 5 * good.stiffness.half_width);
  EXPECT_THAT(foundation::message(bad.warnings.list().back()), HasSubstr("cycles differ"));
}

TEST(LoopFit, WrongSignsAreReported) {
  LoopRecord record = HarmonicTest().record();
  record.force *= -1;
  EXPECT_THAT(foundation::message(loop_fit(record)->warnings.list().front()),
              HasSubstr("reverse the sign of the force"));
  record = HarmonicTest().record();
  std::swap(record.force, record.displacement);
  EXPECT_THAT(foundation::message(loop_fit(record)->warnings.list().front()),
              HasSubstr("a passive element dissipates energy"));
  record = HarmonicTest().record();
  record.angular_frequency = 7.3;
  EXPECT_THAT(foundation::message(loop_fit(record)->warnings.list().front()),
              HasSubstr("check the units of time and frequency"));
}

TEST(LoopFit, UnusableRecordsAreRejectedWithAReason) {
  LoopRecord record = HarmonicTest().record();
  record.force(5) = std::nan("");
  EXPECT_THAT(first_problem(record), HasSubstr("loop '7.3 Hz': sample 6: a value is missing"));
  record = HarmonicTest().record();
  record.time(7) = record.time(6);
  EXPECT_THAT(first_problem(record), HasSubstr("sample 8: time"));
  record = HarmonicTest().record();
  record.force.conservativeResize(10);
  EXPECT_THAT(first_problem(record), HasSubstr("900 displacements, 10 forces"));
  EXPECT_THAT(first_problem({"none", {}, {}, {}}), HasSubstr("0 samples"));
  EXPECT_THAT(first_problem({"still", {}, Eigen::VectorXd::Ones(50), Eigen::VectorXd::Ones(50)}),
              HasSubstr("does not change"));
  EXPECT_THAT(first_problem(HarmonicTest{0.7, 200, 0, 0, 1}.record()),
              HasSubstr("a loop must have at least one whole cycle"));
  EXPECT_THAT(first_problem(HarmonicTest{20, 90, 0, 0, 1}.record()), HasSubstr("samples per cycle"));
  LoopOptions options;
  options.harmonics = 0;
  EXPECT_THROW((void)loop_fit(HarmonicTest().record(), options), foundation::InvalidInput);
}

}  // namespace hysteresis_loop_test
