// SPDX-License-Identifier: BSD-3-Clause
// Responses of matrices on which solvers fail, compared with solutions in extended precision.
#include <gmock/gmock.h>

#include <algorithm>

#include "support/hard_cases.h"
#include "support/matchers.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/numerics/peaks/peak_refinement.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/response/steady/peaks.h"

namespace hard_cases_test {

using namespace trivet;
using numerics::DynamicMatrices;

constexpr double condition_share = 16 * 6 * test::epsilon;  // of six coordinates, solved with backward stability
constexpr double round_off = 1e-12;                         // of two heights near the same resonance
constexpr double last_digits = 1e-14;                       // three coordinates of ones

using test::HardCase, test::hard_cases, test::load, test::awkward_frequencies;

TEST(HardCases, EveryReturnedValueHasASmallBackwardErrorAndTheForwardErrorOfItsCondition) {
  for (const HardCase& hard : hard_cases()) {
    const std::vector<double> omega = awkward_frequencies(hard.m);
    const numerics::SweepResult found = numerics::sweep(hard.m, load(), omega);
    const Eigen::VectorXd d = numerics::unit_scale(hard.m.A);
    const DynamicMatrices scaled = numerics::scaled(hard.m, d);
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const auto column = to_index(i);
      if (!found.response.col(column).allFinite()) continue;
      EXPECT_LE(found.backward_error(column), numerics::accepted_backward_error) << hard.name << " at " << omega[i];
      const std::complex<long double> iw(0, omega[i]);
      numerics::ExtendedMatrix z = scaled.complex_stiffness().cast<std::complex<long double>>() +
          iw * scaled.B.cast<std::complex<long double>>() + iw * iw * scaled.A.cast<std::complex<long double>>();
      const numerics::RefinedSolver exact(z);
      const numerics::ExtendedVector q = exact.solve((d.asDiagonal() * load()).cast<std::complex<long double>>());
      const Eigen::VectorXcd mine = d.cwiseInverse().asDiagonal() * found.response.col(column);
      const double error = static_cast<double>((mine.cast<std::complex<long double>>() - q).norm() / q.norm());
      EXPECT_LE(error, condition_share * exact.condition()) << hard.name << " at " << omega[i];
    }
    EXPECT_LE(found.singular, 3) << hard.name;
  }
}

TEST(HardCases, PivotingIsCalledIfTheFastPathFails) {
  const auto cases = hard_cases();
  const auto vanishing =
      std::ranges::find_if(cases, [](const auto& c) { return std::string(c.name).starts_with("vanishing"); });
  EXPECT_GT(numerics::sweep(vanishing->m, load(), {std::sqrt(50.0)}).fallbacks, 0);
}

TEST(HardCases, PeaksAreLocalMaximaInExtendedPrecision) {
  for (const HardCase& hard : hard_cases()) {
    assembly::Assembled assembled{assembly::Layout(model::Description{}), hard.m, {}, {}, {}};
    std::vector<assembly::Channel> channels;
    for (int j = 0; j < 6; ++j)
      channels.push_back({{Eigen::VectorXcd::Unit(6, j), Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)},
                          "q" + std::to_string(j),
                          "m",
                          j % 3,
                          {},
                          {},
                          0});
    modal::Modes modes;
    modal::Roots roots;
    roots.poles = numerics::roots_from_states(hard.m).lambda;
    const response::Peaks found = response::peaks(assembled, channels, load(), modes, roots);
    int bounded = 0;
    for (const response::Peak& peak : found.list) {
      if (std::isinf(peak.amplitude)) continue;
      ++bounded;
      EXPECT_TRUE(peak.refined) << hard.name;
      const double step = std::max(64 * peak.frequency_uncertainty, 1e-6 * peak.angular_frequency);
      for (const double side : {-step, step}) {
        const numerics::Load driving(load()), nothing(Eigen::Index{0});
        const numerics::RefinedPeak beside =
            numerics::PeakRefinement({hard.m, driving, nothing})
                .refined(channels[peak.curve].curve(), peak.angular_frequency + side, 0);
        EXPECT_LE(beside.amplitude, peak.amplitude * (1 + round_off) + peak.amplitude_uncertainty)
            << hard.name << " near " << peak.angular_frequency;
      }
    }
    if (std::string(hard.name) != "one damper, the rest undamped" && std::string(hard.name) != "overdamped" &&
        std::string(hard.name).find("critical") == std::string::npos) {
      EXPECT_GT(bounded, 0) << hard.name;
    }
  }
}

TEST(HardCases, AnIndefiniteMassIsNeverTakenForADefiniteOne) {
  // A generalized symmetric solver may give 1, 1, 1 for K = 1, A = diag(1, 1, −1).
  const Eigen::MatrixXd K = Eigen::MatrixXd::Identity(3, 3), A = Eigen::Vector3d(1, 1, -1).asDiagonal();
  const auto modes = numerics::generalized_modes(K, A, true);
  EXPECT_EQ(modes.route, numerics::ModeRoute::definite_stiffness);
  EXPECT_NEAR(modes.lambda(0), -1, last_digits);
  EXPECT_NEAR(modes.lambda(1), 1, last_digits);
  EXPECT_EQ(modes.norm(0), -1);
}

}  // namespace hard_cases_test
