// SPDX-License-Identifier: BSD-3-Clause
// Searches end, also for numbers outside the computable range and without convergence.
#include <gmock/gmock.h>

#include <limits>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/peaks/axis_panels.h"
#include "trivet/numerics/peaks/peak_count.h"
#include "trivet/response/random/basis_integrals.h"

namespace search_bounds_test {

using namespace trivet;
using foundation::NotComputable;

TEST(SearchBounds, CoefficientsThatAreNotFiniteAreRejected) {
  for (const double wrong : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(static_cast<void>(numerics::sign_changes(std::vector<double>{1, wrong, 1}, -1, 1)), NotComputable);
}

/// Bounds by Taylor's formula overflow, so no interval can be decided.
TEST(SearchBounds, CoefficientsWhoseBoundsOverflowAreRejected) {
  std::vector<double> c(40, 1e305);
  for (std::size_t k = 0; k < c.size(); k += 2) c[k] = -1e305;
  EXPECT_THROW(static_cast<void>(numerics::sign_changes(c, -1, 1)), NotComputable);
}

TEST(SearchBounds, PolesThatLeaveNoPanelAreRejected) {
  Eigen::VectorXcd poles(2);
  poles << 0, std::numeric_limits<double>::denorm_min();
  EXPECT_THROW(static_cast<void>(numerics::cover_axis(poles)), NotComputable);
  poles << -1, std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(numerics::cover_axis(poles)), NotComputable);
}

TEST(SearchBounds, ABandThatBeginsOnAPoleIsNotIntegrated) {
  EXPECT_THROW(static_cast<void>(response::graded_panels(Eigen::VectorXcd::Zero(1), 0, 1, 0)), NotComputable);
}

}  // namespace search_bounds_test
