// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "support/matchers.h"
#include "trivet/elements/law.h"
#include "trivet/identification/stiffness_fit.h"
#include "trivet/numerics/sampling/student_distribution.h"

/// Synthetic rigs with a known matrix.
namespace load_cases_test {

using namespace trivet;
using namespace trivet::identification;
using numerics::student_quantile;

const Eigen::Vector3d arm(0.01, -0.02, 0.12);

/// A mount of 300, 450, 1200 kN/m with all couplings.
Matrix12 true_stiffness() {
  Matrix6 k = (Vector6() << 3e5, 4.5e5, 1.2e6, 900, 700, 250).finished().asDiagonal();
  const Vector6 size = k.diagonal().cwiseSqrt();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j) k(i, j) = k(j, i) = 0.35 * std::sin(1.0 + 3 * i + 7 * j) * size(i) * size(j);
  return elements::from_moved_end(k, arm);
}

/// A rig that moves both ends (or only K) randomly by about 1 mm and 10 mrad, with noise relative to the rms of each
/// channel.
class SyntheticRig {
 public:
  explicit SyntheticRig(unsigned seed) : random_(seed) {}

  std::vector<LoadCase> cases(int count, const Matrix12& stiffness, bool both_ends, double noise) {
    std::vector<LoadCase> cases;
    Vector12 squares = Vector12::Zero();
    for (int k = 0; k < count; ++k) {
      Vector12 d;
      for (int i = 0; i < 12; ++i) d(i) = (i < 6 && !both_ends ? 0 : normal_(random_)) * (i % 6 < 3 ? 1e-3 : 1e-2);
      cases.push_back({"case " + std::to_string(k + 1), d, stiffness * d});
      squares += cases.back().wrench.cwiseAbs2() / count;
    }
    for (LoadCase& one : cases)
      for (int i = 0; i < 12; ++i) {
        if (!both_ends && i < 6) one.wrench(i) = std::numeric_limits<double>::quiet_NaN();
        one.wrench(i) += noise * std::sqrt(squares(i)) * normal_(random_);
      }
    return cases;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

Vector12 entry_size(const Matrix12& stiffness) { return stiffness.diagonal().cwiseSqrt(); }

TEST(StudentQuantile, AgreesWithTheTables) {
  constexpr double printed = 5e-4;  // three decimals
  EXPECT_NEAR(student_quantile(0.95, 1), 12.706, printed);
  EXPECT_NEAR(student_quantile(0.95, 5), 2.571, printed);
  EXPECT_NEAR(student_quantile(0.99, 10), 3.169, printed);
  EXPECT_NEAR(student_quantile(0.95, 120), 1.980, printed);
  EXPECT_NEAR(student_quantile(0.95, 1e9), 1.960, printed);
}

TEST(IdentifiedStiffness, ExactReadingsGiveTheExactMatrix) {
  const Matrix12 truth = true_stiffness();
  constexpr double round_off = 1e-11;        // 100 readings of 1e-16, condition below 1e3
  constexpr double rigid_round_off = 1e-10;  // a motion of both ends: sums of several such entries
  for (const auto unknowns : {Unknowns::self_balanced, Unknowns::full_symmetric}) {
    StiffnessFitOptions options;
    options.unknowns = unknowns;
    const auto fit = identified_stiffness(SyntheticRig(1).cases(30, truth, true, 0), arm, options);
    ASSERT_TRUE(fit.has_value());
    EXPECT_THAT(fit->stiffness, test::NearInUnits(truth, entry_size(truth), round_off));
    EXPECT_LE(fit->scaled_rigid_residual, rigid_round_off);
    EXPECT_THAT(fit->outliers, testing::IsEmpty());
  }
}

/// Share of the entries of all rigs with the true value inside their interval.
double coverage(Unknowns unknowns, bool both_ends, int cases, double noise, int rigs) {
  const Matrix12 truth = true_stiffness();
  StiffnessFitOptions options;
  options.unknowns = unknowns;
  const int first = unknowns == Unknowns::self_balanced ? 6 : 0;
  int held = 0, all = 0;
  for (int rig = 0; rig < rigs; ++rig) {
    SyntheticRig synthetic(static_cast<unsigned>(1e5 * noise) + static_cast<unsigned>(rig));
    const auto fit = identified_stiffness(synthetic.cases(cases, truth, both_ends, noise), arm, options).value();
    for (int i = first; i < 12; ++i)
      for (int j = first; j <= i; ++j, ++all)
        held += std::abs(fit.stiffness(i, j) - truth(i, j)) <= fit.half_width(i, j);
  }
  return static_cast<double>(held) / all;
}

constexpr double
    least = 0.93,
    most = 0.97;  // the goal for 95 % intervals; 2000 to 4000 intervals each: the simulation scatters by 0.005

TEST(IdentifiedStiffness, IntervalsContainTheTruthAsOftenAsStated) {
  for (const double noise : {0.01, 0.05}) {
    EXPECT_THAT(coverage(Unknowns::self_balanced, false, 24, noise, 200),
                testing::AllOf(testing::Ge(least), testing::Le(most)))
        << "moved end, noise " << noise;
    EXPECT_THAT(coverage(Unknowns::self_balanced, false, 10, noise, 150),
                testing::AllOf(testing::Ge(least), testing::Le(most)))
        << "few cases, noise " << noise;
    EXPECT_THAT(coverage(Unknowns::self_balanced, true, 30, noise, 60),
                testing::AllOf(testing::Ge(least), testing::Le(most)))
        << "both ends, noise " << noise;
    EXPECT_THAT(coverage(Unknowns::full_symmetric, true, 40, noise, 20),
                testing::AllOf(testing::Ge(least), testing::Le(most)))
        << "78 constants, noise " << noise;
  }
}

}  // namespace load_cases_test
