// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "support/projects.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/response/steady/deep_check.h"

namespace deep_check_test {

using namespace trivet;

/// K, iωB and −ω²A of a single coordinate cancel at its resonance, although its condition is always 1.
TEST(DeepCheck, AllowsForDigitsThatCancelInASingleCoordinate) {
  const project::Project project = test::project(R"(trivet = 1
[bodies.b]
mass = 3.7
free = ["z"]
[elements.s]
type = "three_springs"
on = "b"
at = [0.13, 0.07, 0.3]
axis = [0.3, 0.2, 0.9]
translation = [12345, 5432, 98765]
damping = {proportional = 1e-11}
[elements.t]
type = "three_springs"
on = "b"
at = [-0.13, 0.17, 0.3]
axis = [0.3, -0.2, 0.7]
translation = [12345, 5432, 98765]
damping = {proportional = 1e-11}
)");
  const response::DeepCheck check = study::deep_check(project.base());
  EXPECT_TRUE(check.passed) << check.worst_difference << " of allowed " << check.allowed;
  EXPECT_GE(check.frequencies, 60);
}

/// An undamped resonance of some coordinates; others do not take part in it.
TEST(DeepCheck, GivesASingularBlockAnInfiniteCondition) {
  numerics::ExtendedMatrix z = numerics::ExtendedMatrix::Identity(5, 5);
  z.bottomRightCorner(2, 2) << 1, 2, 2, 4;
  EXPECT_TRUE(std::isinf(numerics::RefinedSolver(z).condition()));
  // The estimate alone would find 200: a solution with a zero on the right side does not meet the zero pivot.
  z = 0.01L * numerics::ExtendedMatrix::Identity(3, 3);
  z.topLeftCorner(2, 2).setOnes();
  EXPECT_TRUE(std::isinf(numerics::RefinedSolver(z).condition()));
}

/// An unbalance there would be 1e-304 of its size elsewhere.
TEST(DeepCheck, SkipsAFrequencyThatIsRoundOffOfADecayingRoot) {
  Eigen::VectorXcd poles(2);
  poles << std::complex<double>(-16, 7e-153), std::complex<double>(-2, 21);
  const std::vector<double> omega = response::check_frequencies(poles, 0, 100, 64);
  EXPECT_THAT(omega, testing::Each(testing::Gt(0.1)));
  EXPECT_THAT(omega, testing::Contains(21.0));
}

/// A loss factor is of the stiffness of the element, not of laws beside it.
TEST(DeepCheck, AgreesOnALawBesideALossFactor) {
  const project::Project project = test::project(R"(trivet = 1
[bodies.b]
mass = 100
free = ["z"]
[elements.m]
type = "three_springs"
on = "b"
at = [0, 0, 0]
translation = [1e5, 1e5, 1e5]
damping = {loss_factor = 0.1}
laws.z = {polynomial = [1e5, 0, 1e9]}
)");
  const response::DeepCheck check = study::deep_check(project.base());
  EXPECT_TRUE(check.passed) << check.worst_difference << " of allowed " << check.allowed;
  EXPECT_GE(check.frequencies, 20);
}

TEST(DeepCheck, AllowsLittleIfNothingCancels) {
  const project::Project project = test::project(test::chain({1}, {1000, 0}, {0, 0}));
  const response::DeepCheck check = study::deep_check(project.base());
  EXPECT_TRUE(check.passed);
  constexpr double without_cancellation = 1e-9;  // far below the accuracy of any input
  EXPECT_LT(check.allowed, without_cancellation);
}

}  // namespace deep_check_test
