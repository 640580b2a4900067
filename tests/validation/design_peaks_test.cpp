// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/batch/design_peaks.h"
#include "trivet/foundation/index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "trivet/foundation/invalid_input.h"

namespace trivet {
namespace design_peaks_test {

using numerics::DesignStatus;

/// A mass of 2 kg on 200 N/m, ω0 = 10 rad/s, with a force of 3 N, for these damping ratios.
numerics::Designs single_masses(const std::vector<double>& zeta) {
  const auto count = to_index(zeta.size());
  numerics::Designs designs{Eigen::ArrayXXd::Constant(count, 1, 2), Eigen::ArrayXXd(count, 1),
                            Eigen::ArrayXXd::Constant(count, 1, 200), Eigen::ArrayXXd::Constant(1, 1, 3)};
  for (Eigen::Index i = 0; i < count; ++i) designs.B(i, 0) = 2 * zeta[i] * 20;
  return designs;
}

/// Relative error of the height by round-off of the decay rate, a few units of the frequency: ε/ζ.
double height_round_off(double zeta) { return 1e-13 + 8 * std::numeric_limits<double>::epsilon() / zeta; }

constexpr double round_off = 1e-12;    // some hundred operations on numbers up to 10
constexpr double flat_maximum = 1e-8;  // rad/s: the place of a maximum is known to the root of round-off
constexpr double nine_digits = 1e-9;   // stated for all heights in design_peaks.h

TEST(DesignPeaks, SingleMassHasItsPeakBelowTheNaturalFrequency) {  // [Ewins2000]: ω0 √(1 − 2ζ²), F/k / (2ζ√(1 − ζ²))
  const std::vector<double> zeta = {1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.5, 0.7};
  const numerics::DesignPeaks peaks = numerics::design_peaks(single_masses(zeta));
  for (std::size_t i = 0; i < zeta.size(); ++i) {
    const auto d = to_index(i);
    const double z = zeta[i], height = 3.0 / 200 / (2 * z * std::sqrt(1 - z * z));
    EXPECT_NEAR(peaks.highest(d, 0), height, height_round_off(z) * height) << z;
    EXPECT_NEAR(peaks.highest_at(d, 0), 10 * std::sqrt(1 - 2 * z * z), flat_maximum) << z;
    EXPECT_EQ(peaks.peaks(d, 0), 1) << z;
    EXPECT_NEAR(peaks.largest_rise(d, 0), height / 0.015 - 1, nine_digits + height_round_off(z) * height / 0.015) << z;
    EXPECT_EQ(peaks.status[i], DesignStatus::proven) << z;
  }
}

/// Two uncoupled masses with the same natural frequency: one undamped and at rest, the other nearly undamped. No panel
/// of the search reaches the common pole. Heights there come from a parabola for 1/|y|².
TEST(DesignPeaks, OfADampedMassNextToAnUndampedOneWithItsFrequency) {
  constexpr double of_parabola = 1e-6;
  for (const double zeta : {1e-5, 1e-4, 3e-4, 1e-3}) {
    numerics::Designs designs{Eigen::ArrayXXd(1, 3), Eigen::ArrayXXd(1, 3), Eigen::ArrayXXd(1, 3),
                              Eigen::ArrayXXd(1, 2)};
    designs.A << 2, 0, 2;
    designs.B << 2 * zeta * 20, 0, 0;
    designs.K << 200, 0, 200;
    designs.load << 3, 0;
    const numerics::DesignPeaks peaks = numerics::design_peaks(designs);
    const double height = 3.0 / 200 / (2 * zeta * std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(peaks.highest(0, 0), height, of_parabola * height) << zeta;
    EXPECT_EQ(peaks.peaks(0, 0), 1) << zeta;
  }
}

TEST(DesignPeaks, DoNotExistFromSeventyOnePercentOfCriticalDampingOn) {
  const std::vector<double> zeta = {0.7072, 0.8, 0.999, 1, 1.0001, 3, 100};
  const numerics::DesignPeaks peaks = numerics::design_peaks(single_masses(zeta));
  for (std::size_t i = 0; i < zeta.size(); ++i) {
    const auto d = to_index(i);
    EXPECT_NEAR(peaks.highest(d, 0), 0.015, round_off * 0.015) << zeta[i];
    EXPECT_EQ(peaks.highest_at(d, 0), 0) << zeta[i];
    EXPECT_EQ(peaks.peaks(d, 0), 0) << zeta[i];
    EXPECT_NE(peaks.status[i], DesignStatus::undecided) << zeta[i];
  }
}

TEST(DesignPeaks, AreInfiniteWithoutDampingAlsoOnTheEdgeOfTheBand) {
  for (const auto& [from, to] : {std::pair{10.0, 20.0}, {5.0, 10.0}, {5.0, 20.0}}) {
    numerics::DesignPeakOptions options;
    options.from = from;
    options.to = to;
    EXPECT_TRUE(std::isinf(numerics::design_peaks(single_masses({0}), options).highest(0, 0))) << from << " … " << to;
  }
}

TEST(DesignPeaks, AreProvenInAllDirectionsIfOnlyOneMoves) {
  numerics::Designs designs{Eigen::ArrayXXd::Zero(1, 21), Eigen::ArrayXXd::Zero(1, 21), Eigen::ArrayXXd::Zero(1, 21),
                            Eigen::ArrayXXd::Zero(1, 6)};
  for (int i = 0; i < 6; ++i) {
    const int diagonal = i * (i + 1) / 2 + i;
    designs.A(0, diagonal) = 2;
    designs.K(0, diagonal) = 200 * (i + 1);
    designs.B(0, diagonal) = 4;
  }
  designs.load(0, 0) = 3;
  const numerics::DesignPeaks peaks = numerics::design_peaks(designs);
  EXPECT_EQ(peaks.status[0], DesignStatus::proven);
  EXPECT_NEAR(peaks.highest(0, 0), 0.015 / (0.2 * std::sqrt(0.99)), round_off);
  EXPECT_EQ(peaks.peaks(0, 0), 1);
  EXPECT_TRUE((peaks.highest.rightCols(5) == 0).all() && (peaks.peaks.rightCols(5) == 0).all());
}

TEST(DesignPeaks, VelocityPeaksAtTheNaturalFrequencyForAnyDamping) {
  const std::vector<double> zeta = {1e-3, 0.2, 0.9, 4};
  numerics::DesignPeakOptions options;
  options.derivative = {1};
  constexpr double flatter_maximum = 1e-6;     // rad/s: with a damping ratio up to 4
  constexpr double height_times_zeta = 1e-11;  // of 0.075: nine digits are stated
  const numerics::DesignPeaks peaks = numerics::design_peaks(single_masses(zeta), options);
  for (std::size_t i = 0; i < zeta.size(); ++i) {
    const auto d = to_index(i);
    EXPECT_NEAR(peaks.highest_at(d, 0), 10, flatter_maximum) << zeta[i];
    EXPECT_NEAR(peaks.highest(d, 0), 3 / (2 * zeta[i] * 20), height_times_zeta / zeta[i]) << zeta[i];
    EXPECT_EQ(peaks.peaks(d, 0), 1) << zeta[i];
  }
}

TEST(DesignPeaks, AccelerationRisesToForceOverMassWithHeavyDamping) {
  numerics::DesignPeakOptions options;
  options.derivative = {2};
  const numerics::DesignPeaks peaks = numerics::design_peaks(single_masses({0.1, 0.8}), options);
  EXPECT_NEAR(peaks.highest(0, 0), 1.5 / (0.2 * std::sqrt(1 - 0.01)), round_off);
  EXPECT_NEAR(peaks.highest_at(0, 0), 10 / std::sqrt(1 - 0.02), flat_maximum);
  EXPECT_EQ(peaks.peaks(0, 0), 1);
  EXPECT_NEAR(peaks.highest(1, 0), 1.5, round_off);
  EXPECT_TRUE(std::isinf(peaks.highest_at(1, 0)));
  EXPECT_EQ(peaks.peaks(1, 0), 0);
}

TEST(DesignPeaks,
     ForceOnTheGroundHasSpringAndDamper) {  // [Ewins2000]: |T|² = (1 + (2ζr)²) / ((1 − r²)² + (2ζr)²)
  const double zeta = 0.3, r = std::sqrt((std::sqrt(1 + 8 * zeta * zeta) - 1) / (4 * zeta * zeta));
  const double damping = 2 * zeta * r,
               expected = 3 * std::sqrt((1 + damping * damping) / (std::pow(1 - r * r, 2) + damping * damping));
  numerics::DesignPeakOptions options;
  options.rows = Eigen::ArrayXXd::Constant(1, 1, 200);
  options.rows_on_velocity = Eigen::ArrayXXd::Constant(1, 1, 2 * zeta * 20);
  const numerics::DesignPeaks peaks = numerics::design_peaks(single_masses({zeta}), options);
  EXPECT_NEAR(peaks.highest(0, 0), expected, round_off * expected);
  EXPECT_NEAR(peaks.highest_at(0, 0), 10 * r, flat_maximum);
  EXPECT_EQ(peaks.peaks(0, 0), 1);
}

TEST(DesignPeaks, CurveThatGrowsWithoutBoundHasItsPeaksCounted) {  // y = s²(1 + τs) q rises like ω above its minimum
  const double zeta = 0.01, rate = 1e-4;
  numerics::DesignPeakOptions options;
  options.rows = Eigen::ArrayXXd::Constant(1, 1, 1);
  options.rows_on_velocity = Eigen::ArrayXXd::Constant(1, 1, rate);
  options.derivative = {2};
  const auto y = [&](double omega) {
    return omega * omega * std::hypot(1, rate * omega) * 3 / std::hypot(200 - 2 * omega * omega, 2 * zeta * 20 * omega);
  };
  constexpr double scan_step = 1e-8;  // (half a step of 1e-5 rad/s over the half width of 0.1 rad/s)², with room
  double top = 0, base = std::numeric_limits<double>::infinity();
  for (double omega = 9; omega < 11; omega += 1e-5) top = std::max(top, y(omega));
  for (double omega = 20; omega < 2000; omega += 0.01) base = std::min(base, y(omega));
  const numerics::DesignPeaks peaks = numerics::design_peaks(single_masses({zeta}), options);
  EXPECT_TRUE(std::isinf(peaks.highest(0, 0)));
  EXPECT_EQ(peaks.peaks(0, 0), 1);
  EXPECT_NEAR(peaks.largest_rise(0, 0), top / base - 1, scan_step * top / base);
}

TEST(DesignPeaks, FreeMassAcceleratesByForceOverMass) {
  numerics::Designs free = single_masses({0});
  free.K.setZero();
  numerics::DesignPeakOptions acceleration;
  acceleration.derivative = {2};
  EXPECT_NEAR(numerics::design_peaks(free, acceleration).highest(0, 0), 1.5, round_off);
}

TEST(DesignPeaks, AreNotCountedOutsideTheBandAndItsEndIsTheHighest) {
  numerics::DesignPeakOptions options;
  options.to = 9;
  const numerics::DesignPeaks below = numerics::design_peaks(single_masses({0.01}), options);
  EXPECT_EQ(below.peaks(0, 0), 0);
  EXPECT_EQ(below.highest_at(0, 0), 9);
  EXPECT_NEAR(below.highest(0, 0), 3 / std::hypot(200 - 162.0, 0.4 * 9), round_off * 0.08);
  options.from = 11;
  options.to = 20;
  EXPECT_EQ(numerics::design_peaks(single_masses({0.01}), options).highest_at(0, 0), 11);
}

TEST(DesignPeaks, AreInfiniteWithoutDamping) {
  const numerics::DesignPeaks peaks = numerics::design_peaks(single_masses({0}));
  EXPECT_TRUE(std::isinf(peaks.highest(0, 0)));
  EXPECT_NEAR(peaks.highest_at(0, 0), 10, round_off);
  EXPECT_EQ(peaks.peaks(0, 0), 1);
}

TEST(DesignPeaks, AreNotComputedForANegativeMass) {
  numerics::Designs designs = single_masses({0.1, 0.1});
  designs.A(0, 0) = -2;
  const numerics::DesignPeaks peaks = numerics::design_peaks(designs);
  EXPECT_EQ(peaks.status[0], DesignStatus::impossible);
  EXPECT_EQ(peaks.highest(0, 0), 0);
  EXPECT_EQ(peaks.status[1], DesignStatus::proven);
}

TEST(DesignPeaks, AreNotComputedFromNumbersThatAreNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int which = 0; which < 4; ++which) {
      numerics::Designs designs = single_masses({0.1, 0.2, 0.3});
      designs.load = designs.load.replicate(3, 1).eval();
      (which == 0 ? designs.A : which == 1 ? designs.B : which == 2 ? designs.K : designs.load)(1, 0) = bad;
      const numerics::DesignPeaks peaks = numerics::design_peaks(designs);
      EXPECT_EQ(peaks.status[1], DesignStatus::impossible) << which;
      EXPECT_EQ(peaks.highest(1, 0), 0) << which;
      EXPECT_EQ(peaks.status[0], DesignStatus::proven) << which;
      EXPECT_EQ(peaks.status[2], DesignStatus::proven) << which;
    }
}

TEST(DesignPeaks, RejectAnEmptyBand) {
  numerics::DesignPeakOptions options;
  options.from = 3;
  options.to = 3;
  EXPECT_THROW((void)numerics::design_peaks(single_masses({0.1}), options), foundation::InvalidInput);
}

}  // namespace design_peaks_test
}  // namespace trivet
