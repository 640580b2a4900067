// SPDX-License-Identifier: BSD-3-Clause
// Coordinates that the load hardly moves, by poles: their terms cancel, or are round-off. Compared with solutions in
// long double.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "trivet/numerics/batch/design_peaks.h"

namespace weak_coupling_test {

using namespace trivet::numerics;

constexpr double nine_digits = 1e-9;   // stated for all heights in design_peaks.h
constexpr double eight_digits = 1e-8;  // of the fallback, whose series are truncated

/// One design.
Designs design_of(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& K,
                  const Eigen::VectorXd& load) {
  const Eigen::Index n = A.rows(), entries = n * (n + 1) / 2;
  Designs designs{Eigen::ArrayXXd(1, entries), Eigen::ArrayXXd(1, entries), Eigen::ArrayXXd(1, entries),
                  load.transpose().array()};
  pack(A, designs.A, 0);
  pack(B, designs.B, 0);
  pack(K, designs.K, 0);
  return designs;
}

/// Equal masses between walls on equal springs, 10 rad/s each, the force on the last.
Designs chain(int masses) {
  Eigen::MatrixXd K = 200 * Eigen::MatrixXd::Identity(masses, masses);
  for (int i = 1; i < masses; ++i) K(i, i - 1) = K(i - 1, i) = -100;
  Eigen::MatrixXd B = 0.002 * K;
  B(0, 0) += 0.01;
  return design_of(Eigen::MatrixXd::Identity(masses, masses), B, K, Eigen::VectorXd::Unit(masses, masses - 1));
}

/// |q| of the only design.
Eigen::ArrayXd amplitudes(const Designs& designs, double omega) {
  using Extended = std::complex<long double>;
  const DynamicMatrices m = matrices_of(designs, 0);
  const Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic> Z = m.K.cast<Extended>() -
      Extended(static_cast<long double>(omega) * omega) * m.A.cast<Extended>() +
      Extended(0, omega) * m.B.cast<Extended>();
  const Eigen::Matrix<Extended, Eigen::Dynamic, 1> load = designs.load.row(0).matrix().transpose().cast<Extended>();
  return Z.partialPivLu().solve(load).cwiseAbs().cast<double>().array();
}

/// All |q| fall above the resonances, which are at most 20 rad/s: the highest values are at the start of these bands.
TEST(WeakCoupling, FarFromTheForceAndAboveAllResonancesHighestValuesHaveNineDigits) {
  for (const int masses : {2, 3, 6})
    for (const double from : {30.0, 60.0, 200.0, 2000.0}) {
      const Designs designs = chain(masses);
      const Eigen::ArrayXd expected = amplitudes(designs, from);
      for (const bool count : {false, true})
        for (const double to : {3 * from, std::numeric_limits<double>::infinity()}) {
          DesignPeakOptions options;
          options.from = from, options.to = to, options.count_peaks = count;
          const DesignPeaks peaks = design_peaks(designs, options);
          EXPECT_LE((peaks.highest.row(0).transpose() / expected - 1).abs().maxCoeff(), nine_digits)
              << masses << " masses from " << from << " to " << to;
          if (count) {
            EXPECT_EQ(peaks.peaks.maxCoeff(), 0) << masses << " masses from " << from << " to " << to;
          }
        }
    }
}

TEST(WeakCoupling, NearTheResonancesPolesAloneSuffice) {
  for (const int masses : {2, 6}) EXPECT_EQ(design_peaks(chain(masses)).status[0], DesignStatus::proven) << masses;
}

Designs two_masses(double coupling) {
  Eigen::Matrix2d K;
  K << 100, coupling, coupling, 225;
  return design_of(Eigen::Matrix2d::Identity(), Eigen::Vector2d(1, 1.5).asDiagonal(), K, Eigen::Vector2d(1, 0));
}

TEST(WeakCoupling, RoundOffCouplesNothing) {
  for (const double coupling : {1e-15, 1e-18, 0.0}) {
    const DesignPeaks peaks = design_peaks(two_masses(coupling));
    EXPECT_EQ(peaks.highest(0, 1), 0) << coupling;
    EXPECT_EQ(peaks.peaks(0, 1), 0) << coupling;
    EXPECT_EQ(peaks.peaks(0, 0), 1) << coupling;
  }
}

/// y₂ = −coupling / (Z₁₁ Z₂₂ − coupling²)
TEST(WeakCoupling, RealCouplingHasNineDigits) {
  for (const double coupling : {1e-9, 1e-7, 1e-5, 1e-3}) {
    const Designs designs = two_masses(coupling);
    const DesignPeaks peaks = design_peaks(designs);
    const double there = amplitudes(designs, peaks.highest_at(0, 1))(1);
    EXPECT_NEAR(peaks.highest(0, 1), there, nine_digits * there) << coupling;
    EXPECT_EQ(peaks.peaks(0, 1), 2) << coupling;
  }
}

TEST(WeakCoupling, AVelocityThatTheForceDoesNotAccelerateAtOnceDoesNotGrowWithoutBound) {
  Eigen::Matrix2d K;
  K << 300, -100, -100, 250;
  const Designs designs = design_of(Eigen::Vector2d(2, 3).asDiagonal(), 0.003 * K, K, Eigen::Vector2d(0.7, 0));
  constexpr double between_points = 1e-4;  // of the scan
  for (const bool count : {false, true}) {
    DesignPeakOptions options;
    options.rows = Eigen::ArrayXXd::Zero(1, 2);
    options.rows(0, 0) = 1;
    options.rows_on_velocity = Eigen::ArrayXXd::Zero(1, 2);
    options.rows_on_velocity(0, 1) = 1;
    options.derivative = {2};
    options.count_peaks = count;
    const DesignPeaks peaks = design_peaks(designs, options);
    ASSERT_TRUE(std::isfinite(peaks.highest(0, 0))) << count;
    double seen = 0;
    for (double omega = 1; omega < 1e4; omega *= 1.0005) {
      const Eigen::VectorXcd q = matrices_of(designs, 0).at(omega).partialPivLu().solve(Eigen::Vector2cd(0.7, 0));
      seen = std::max(seen, omega * omega * std::abs(q(0) + std::complex<double>(0, omega) * q(1)));
    }
    EXPECT_LE(seen, peaks.highest(0, 0) * (1 + nine_digits));
    EXPECT_GE(seen, peaks.highest(0, 0) * (1 - between_points));
  }
}

/// c₁ᵀA⁻¹h = 0 to round-off only.
TEST(WeakCoupling, AVelocityWhoseAccelerationIsRoundOffDoesNotGrowWithoutBound) {
  Eigen::Matrix2d A, K;
  K << 300, -100, -100, 250;
  for (int k = 0; k < 200; ++k) {
    A << 2, 0.3 + 0.003 * k, 0.3 + 0.003 * k, 3;
    const Eigen::Vector2d load(0.7, 0.1 + 0.01 * k), at_once = A.partialPivLu().solve(load);
    DesignPeakOptions options;
    options.rows = Eigen::ArrayXXd::Zero(1, 2);
    options.rows(0, 0) = 1;
    options.rows_on_velocity = Eigen::RowVector2d(at_once(1), -at_once(0)).array();
    options.derivative = {2};
    for (const bool count : {false, true}) {
      options.count_peaks = count;
      ASSERT_TRUE(std::isfinite(design_peaks(design_of(A, 0.003 * K, K, load), options).highest(0, 0))) << k;
    }
  }
}

/// A body with a rigid-body mode along its first coordinate.
Designs sliding(double stiffest) {
  const Eigen::Vector3d stiffness(0, 3000, stiffest), damping(0, 1, 0.02 * std::sqrt(stiffest));
  return design_of(6 * Eigen::Matrix3d::Identity(), damping.asDiagonal(), stiffness.asDiagonal(),
                   Eigen::Vector3d(0, 1, 1));
}

TEST(WeakCoupling, WithAFreeDirectionTheHighestValueIsFiniteForAnyStartOfTheBand) {
  for (const double stiffest : {3e6, 3e11, 3e13, 3e15})
    for (const double from : {0.0, 1e-3, 0.22363, 0.268, 2.0}) {
      DesignPeakOptions options;
      options.from = from;
      const DesignPeaks peaks = design_peaks(sliding(stiffest), options);
      EXPECT_EQ(peaks.status[0], DesignStatus::fallback);
      EXPECT_NEAR(peaks.highest(0, 1), amplitudes(sliding(stiffest), peaks.highest_at(0, 1))(1),
                  eight_digits * peaks.highest(0, 1))
          << stiffest << " " << from;
      EXPECT_EQ(peaks.peaks(0, 1), 1) << stiffest << " " << from;
      EXPECT_EQ(peaks.highest(0, 0), 0);
    }
}

TEST(WeakCoupling, ABandRuledByARigidBodyModeIsUndecided) {
  Eigen::Matrix2d K;
  K << 100, -100, -100, 100;
  DesignPeakOptions options;
  options.to = 1e-4;
  EXPECT_EQ(design_peaks(design_of(Eigen::Matrix2d::Identity(), 0.01 * K, K, Eigen::Vector2d(1, 0)), options).status[0],
            DesignStatus::undecided);
}

/// Free along a skew axis, where K has a stiffness of either sign by round-off: compared with the same body in its own
/// axes, where that stiffness is exactly 0.
TEST(WeakCoupling, AStiffnessThatIsRoundOffMakesNoPeak) {
  constexpr double start_of_the_search = 1e-5;  // round-off of K matters there, see docs/theory.md
  const Eigen::Vector3d damping(0, 3e2, 1.2e3), stiffness(0, 3e3, 3e4), load(0, 1, 1);
  for (int k = 0; k < 100; ++k) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1 + 0.02 * k, Eigen::Vector3d(1 + 0.01 * k, std::sin(k), std::cos(3 * k)).normalized())
            .toRotationMatrix();
    const auto turned = [&](const Eigen::Vector3d& principal) -> Eigen::MatrixXd {
      const Eigen::Matrix3d x = turn * principal.asDiagonal() * turn.transpose();
      return 0.5 * (x + x.transpose());
    };
    const Eigen::MatrixXd mass = 6 * Eigen::Matrix3d::Identity();
    DesignPeakOptions along_own_axes;
    along_own_axes.rows = turn.array();
    const DesignPeaks expected = design_peaks(
        design_of(mass, damping.asDiagonal(), stiffness.asDiagonal(), turn.transpose() * load), along_own_axes);
    const DesignPeaks found = design_peaks(design_of(mass, turned(damping), turned(stiffness), load));
    EXPECT_TRUE((found.peaks == expected.peaks).all()) << k << ": " << found.peaks << " instead of " << expected.peaks;
    EXPECT_LE(((found.highest - expected.highest) / expected.highest).abs().maxCoeff(), start_of_the_search) << k;
  }
}

}  // namespace weak_coupling_test
