// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/batch/design_peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/random_designs.h"
#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/peaks/disc_search.h"
#include "trivet/numerics/peaks/peak_count.h"

namespace trivet {
namespace design_peaks_test {

/// Error of the solutions in the search on discs: ε/ζ of the height, ζ ≥ 1e-6, and a margin.
constexpr double lightly_damped = 2e-8;
/// Stated in design_peaks.h for all heights that are not lightly damped.
constexpr double nine_digits = 1e-9;
/// Share of the highest value: 5 % of the rise that makes a peak, if round-off hides the position of a deep minimum
/// (docs/decisions/peaks-of-designs.md).
constexpr double base_in_doubt = 5e-8;

struct Searched {
  double highest = 0;
  numerics::PeakCount count;
};

Searched summary(const numerics::SearchedCurve& curve) {
  std::vector<double> heights = {curve.at_start};
  for (const numerics::Extremum& e : curve.extrema) heights.push_back(e.amplitude);
  heights.push_back(curve.at_end);
  const double highest = std::ranges::max(heights);
  return {highest, numerics::prominent_peaks(heights, 1e-6 * highest)};
}

/// All coordinates of one design.
std::vector<numerics::SearchedCurve> by_discs(const numerics::Designs& designs, Eigen::Index d, int derivative,
                                              double from, double to) {
  const Eigen::Index n = designs.coordinates();
  std::vector<numerics::ObservedCurve> curves;
  for (Eigen::Index j = 0; j < n; ++j)
    curves.push_back(numerics::observed_curve({Eigen::VectorXd::Unit(n, j), {}, derivative}));
  const numerics::DynamicMatrices m = numerics::matrices_of(designs, d);
  const numerics::Load load(designs.load.row(d).matrix().transpose().cast<std::complex<double>>()),
      nothing(Eigen::Index{0});
  return numerics::search_by_discs({m, load, nothing}, curves, numerics::poles(numerics::system_roots(m)), {from, to})
      .curves;
}

void expect_agreement(const numerics::Designs& designs, const numerics::DesignPeakOptions& options, int every,
                      double tolerance) {
  const numerics::DesignPeaks peaks = numerics::design_peaks(designs, options);
  const Eigen::Index n = designs.coordinates();
  const int derivative = options.derivative.empty() ? 0 : options.derivative[0];
  for (Eigen::Index d = 0; d < designs.count(); d += every) {
    const auto curves = by_discs(designs, d, derivative, options.from, options.to);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Searched expected = summary(curves[j]);
      EXPECT_NEAR(peaks.highest(d, j), expected.highest, tolerance * expected.highest)
          << "design " << d << ", coordinate " << j;
      if (options.count_peaks) {
        EXPECT_EQ(peaks.peaks(d, j), expected.count.peaks) << "design " << d << ", coordinate " << j;
        const double rise = expected.count.largest_rise;
        EXPECT_NEAR(peaks.largest_rise(d, j), rise, (tolerance + base_in_doubt) * (1 + rise) * (1 + rise))
            << "design " << d << ", coordinate " << j;
      }
    }
  }
}

/// Compares the largest |q| of all coordinates with direct solutions at the reported frequencies.
void expect_heights_at_their_places(const numerics::Designs& designs, const numerics::DesignPeaks& peaks,
                                    double tolerance) {
  for (Eigen::Index d = 0; d < designs.count(); ++d)
    for (Eigen::Index j = 0; j < designs.coordinates(); ++j) {
      const Eigen::VectorXcd load = designs.load.row(d).matrix().transpose().cast<std::complex<double>>();
      const double there =
          std::abs(numerics::lu_solution(numerics::matrices_of(designs, d).at(peaks.highest_at(d, j)), load)(j));
      EXPECT_NEAR(there, peaks.highest(d, j), tolerance * there) << "design " << d << ", coordinate " << j;
    }
}

TEST(DesignPeaks, HighestAgreeWithTheSearchOnDiscsForAnyDamping) {
  numerics::DesignPeakOptions options;
  options.count_peaks = false;
  expect_agreement(test::random_designs(2400, 6, 1e-6, 1), options, 7, lightly_damped);
}

TEST(DesignPeaks, AreAsManyAsTheSearchOnDiscsFinds) {
  expect_agreement(test::random_designs(240, 6, 1e-3, 2), {}, 1, nine_digits);
}

TEST(DesignPeaks, AccelerationsAgreeWithTheSearchOnDiscs) {
  numerics::DesignPeakOptions options;
  options.derivative.assign(6, 2);
  expect_agreement(test::random_designs(120, 6, 1e-2, 3), options, 1, nine_digits);
}

TEST(DesignPeaks, BandsAgreeWithTheSearchOnDiscs) {
  numerics::DesignPeakOptions options;
  options.from = 5;
  options.to = 40;
  expect_agreement(test::random_designs(120, 6, 1e-2, 4), options, 1, nine_digits);
}

TEST(DesignPeaks, OtherNumbersOfCoordinatesAgreeWithTheSearchOnDiscs) {
  for (const int n : {2, 3, 9}) expect_agreement(test::random_designs(24, n, 1e-2, 5), {}, 1, nine_digits);
}

/// Systems with more coordinates than the kernels support use the discs; direct solutions check these.
TEST(DesignPeaks, ManyCoordinatesAgreeWithDirectSolutions) {
  const numerics::Designs designs = test::random_designs(12, 13, 1e-2, 5);
  const numerics::DesignPeaks peaks = numerics::design_peaks(designs);
  expect_heights_at_their_places(designs, peaks, nine_digits);
  for (Eigen::Index d = 0; d < designs.count(); ++d) {
    const numerics::DynamicMatrices m = numerics::matrices_of(designs, d);
    const Eigen::VectorXcd load = designs.load.row(d).matrix().transpose().cast<std::complex<double>>();
    for (double omega = 0.01; omega < 1000; omega *= 1.002)
      ASSERT_TRUE((numerics::lu_solution(m.at(omega), load).array().abs().transpose() <=
                   (1 + nine_digits) * peaks.highest.row(d))
                      .all())
          << d << " " << omega;
  }
}

TEST(DesignPeaks, AreAtTheReportedFrequencies) {
  constexpr double of_direct_solutions = 1e-8;  // near resonances with damping ratios from 1e-4 on
  const numerics::Designs designs = test::random_designs(400, 6, 1e-4, 21);
  numerics::DesignPeakOptions options;
  for (const bool count : {false, true}) {
    options.count_peaks = count;
    const numerics::DesignPeaks peaks = numerics::design_peaks(designs, options);
    expect_heights_at_their_places(designs, peaks, of_direct_solutions);
  }
}

TEST(DesignPeaks, DoNotDependOnOtherChannels) {
  const numerics::Designs designs = test::random_designs(200, 6, 1e-3, 11);
  const Eigen::ArrayXXd rows = Eigen::MatrixXd::Identity(3, 6).array();
  Eigen::ArrayXXd on_velocity = Eigen::ArrayXXd::Zero(3, 6);
  on_velocity.row(2) = 0.01;
  numerics::DesignPeakOptions together;
  together.rows = rows;
  together.rows_on_velocity = on_velocity;
  together.derivative = {0, 2, 0};
  const numerics::DesignPeaks all = numerics::design_peaks(designs, together);
  for (Eigen::Index c = 0; c < 3; ++c) {
    numerics::DesignPeakOptions alone;
    alone.rows = rows.row(c);
    if (c == 2) alone.rows_on_velocity = on_velocity.row(c);
    alone.derivative = {together.derivative[c]};
    const numerics::DesignPeaks one = numerics::design_peaks(designs, alone);
    for (Eigen::Index d = 0; d < designs.count(); ++d) {
      EXPECT_NEAR(all.highest(d, c), one.highest(d, 0), nine_digits * one.highest(d, 0))
          << "design " << d << ", channel " << c;
      EXPECT_EQ(all.peaks(d, c), one.peaks(d, 0)) << "design " << d << ", channel " << c;
    }
  }
}

/// A check independent of our poles: no direct solution is higher, on the whole axis and close to the undamped natural
/// frequencies, where an error of ε/ζ is allowed.
TEST(DesignPeaks, AreNowhereExceededByDirectSolutions) {
  constexpr double miss = 1e-7;  // ε/ζ with ζ from 1e-6 on, and room
  const numerics::Designs designs = test::random_designs(20'000, 6, 1e-6, 6);
  numerics::DesignPeakOptions options;
  options.count_peaks = false;
  const numerics::DesignPeaks peaks = numerics::design_peaks(designs, options);
  for (Eigen::Index d = 0; d < designs.count(); d += 10) {
    const numerics::DynamicMatrices m = numerics::matrices_of(designs, d);
    const Eigen::VectorXcd load = designs.load.row(d).matrix().transpose().cast<std::complex<double>>();
    std::vector<double> all;
    for (double omega = 0.01; omega < 1000; omega *= 1.07) all.push_back(omega);
    for (const double lambda : numerics::generalized_modes(m.K, m.A, false).lambda)
      for (double away = 1e-8; away < 0.1; away *= 3)
        for (const double side : {-1.0, 1.0}) all.push_back(std::sqrt(lambda) * (1 + side * away));
    for (const double omega : all) {
      const Eigen::VectorXcd q = numerics::lu_solution(m.at(omega), load);
      for (Eigen::Index j = 0; j < 6; ++j)
        ASSERT_LE(std::abs(q(j)), (1 + miss) * peaks.highest(d, j)) << d << " " << omega;
    }
    ASSERT_NE(peaks.status[d], numerics::DesignStatus::undecided) << d;
  }
}

TEST(DesignPeaks, AreTheSameBytesFromOneAndSixteenThreads) {
  const numerics::Designs designs = test::random_designs(1500, 6, 1e-2, 7);
  numerics::DesignPeakOptions options;
  options.threads = 1;
  const numerics::DesignPeaks one = numerics::design_peaks(designs, options);
  options.threads = 16;
  const numerics::DesignPeaks many = numerics::design_peaks(designs, options);
  EXPECT_TRUE((one.highest == many.highest).all());
  EXPECT_TRUE((one.highest_at == many.highest_at).all());
  EXPECT_TRUE((one.peaks == many.peaks).all());
  EXPECT_TRUE((one.largest_rise == many.largest_rise).all());
  EXPECT_EQ(one.status, many.status);
}

TEST(DesignPeaks, AreThoseOfEveryInstructionSet) {
  constexpr double round_off = 1e-10, lightly_damped_round_off = 1e-9;  // ε/ζ with ζ from 1e-2 and 1e-6 on, and room
  const numerics::Designs designs = test::random_designs(240, 6, 1e-2, 8),
                          light = test::random_designs(240, 6, 1e-6, 9);
  numerics::DesignPeakOptions highest;
  highest.count_peaks = false;
  const numerics::DesignPeaks best = numerics::design_peaks(designs),
                              highest_of_light = numerics::design_peaks(light, highest);
  for (const std::string& set : numerics::instruction_sets()) {
    numerics::use_instruction_set(set);
    const numerics::DesignPeaks other = numerics::design_peaks(designs),
                                other_of_light = numerics::design_peaks(light, highest);
    numerics::use_instruction_set("");
    EXPECT_LE((other.highest / best.highest - 1).abs().maxCoeff(), round_off) << set;
    EXPECT_LE((other_of_light.highest / highest_of_light.highest - 1).abs().maxCoeff(), lightly_damped_round_off)
        << set;
    EXPECT_TRUE((other.peaks == best.peaks).all()) << set;
    EXPECT_GE(std::ranges::count(other.status, numerics::DesignStatus::proven), 200) << set;
    EXPECT_GE(std::ranges::count(other_of_light.status, numerics::DesignStatus::proven), 180) << set;
  }
}

}  // namespace design_peaks_test
}  // namespace trivet
