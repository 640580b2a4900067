// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/measurement_comparison.h"

#include <gmock/gmock.h>

#include <chrono>
#include <complex>

namespace measurement_comparison_test {

using namespace trivet;

/// Receptance of a single mass with a loss factor, at equal steps.
struct Resonance {
  std::vector<double> angular_frequency;
  Eigen::VectorXcd value;
};

Resonance resonance(double natural, double loss, double step) {
  Resonance result;
  for (double omega = 0.5 * natural; omega < 1.5 * natural; omega += step) result.angular_frequency.push_back(omega);
  result.value.resize(static_cast<Eigen::Index>(result.angular_frequency.size()));
  for (Eigen::Index i = 0; i < result.value.size(); ++i) {
    const double omega = result.angular_frequency[static_cast<std::size_t>(i)];
    result.value(i) = 1.0 / std::complex<double>(natural * natural - omega * omega, loss * natural * natural);
  }
  return result;
}

TEST(Assurance, IsOneForCurvesThatDifferByAFactor) {
  const Eigen::VectorXcd curve = resonance(10, 0.1, 0.1).value;
  constexpr double round_off = 1e-14;
  EXPECT_NEAR(study::assurance(std::complex<double>(-2, 3) * curve, curve), 1, round_off);
}

TEST(Assurance, IsZeroForOrthogonalShapes) {
  Eigen::VectorXcd one(2), other(2);
  one << 1, std::complex<double>(0, 1);
  other << 1, std::complex<double>(0, -1);
  EXPECT_EQ(study::assurance(one, other), 0);
}

TEST(Assurance, DoesNotExistForACurveThatIsZero) {
  EXPECT_TRUE(std::isnan(study::assurance(Eigen::VectorXcd::Zero(3), Eigen::VectorXcd::Ones(3))));
}

TEST(MeasuredPeaks, LieBetweenTheLines) {
  constexpr double natural = 10, loss = 0.05;
  for (const double step : {0.1, 0.037, 0.05}) {
    const Resonance curve = resonance(natural, loss, step);
    const auto peaks = study::measured_peaks(curve.angular_frequency, curve.value);
    ASSERT_EQ(peaks.size(), 1);
    // The parabola neglects the third power of ω − ω₀: an error of second order in step/ω₀.
    EXPECT_NEAR(peaks[0].angular_frequency, natural, step * step / natural);
    EXPECT_NEAR(peaks[0].amplitude * loss * natural * natural, 1, 0.02);
    EXPECT_NEAR(peaks[0].resolution, step, 1e-9);
  }
}

TEST(MeasuredPeaks, NeedARiseOfAFifth) {
  Eigen::VectorXcd values(7);
  values << 1, 1.15, 1, 0.9, 1.3, 0.95, 1;
  const auto peaks = study::measured_peaks({1, 2, 3, 4, 5, 6, 7}, values);
  ASSERT_EQ(peaks.size(), 1);
  EXPECT_NEAR(peaks[0].angular_frequency, 5, 0.5);
}

TEST(MeasuredPeaks, OfALongRisingNoiseNeedNoLongTime) {
  // Each of 100 000 maxima is higher than all before it; to visit all of them again takes a minute.
  constexpr int count = 200'000;
  std::vector<double> omega;
  Eigen::VectorXcd values(count);
  for (int i = 0; i < count; ++i) {
    omega.push_back(1 + i);
    values(i) = (1 + 10.0 * i / count) * (i % 2 == 0 ? 1 : 0.5);
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(study::measured_peaks(omega, values).size(), count / 2 - 1);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(MeasuredPeaks, NeedCoherence) {
  const Resonance curve = resonance(10, 0.05, 0.1);
  const Eigen::VectorXd poor = Eigen::VectorXd::Constant(curve.value.size(), 0.3);
  EXPECT_TRUE(study::measured_peaks(curve.angular_frequency, curve.value, poor).empty());
}

}  // namespace measurement_comparison_test
