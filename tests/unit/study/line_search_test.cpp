// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/design_search.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace line_search_test {

using namespace trivet;

/// The least of two values: a smooth maximum at 0.7, a lower kink at 0.2, and a part in which nothing has a slope.
numerics::MaxMinProblem two_maxima(std::atomic<int>& values) {
  return {1, {true, true}, [&](const Eigen::VectorXd& x, Eigen::VectorXd& result, Eigen::MatrixXd* slopes) {
            EXPECT_EQ(slopes, nullptr);
            ++values;
            const double u = x(0), smooth = 0.5 - 4 * std::pow(u - 0.7, 2), kink = 0.3 - 5 * std::abs(u - 0.2);
            result.resize(2);
            result << (u < 0.05 ? -30 : std::max(smooth, kink)), 1;
          }};
}

TEST(LineSearch, FindsTheHighestMaximumWithFewValuesAndNoSlopes) {
  std::atomic<int> values = 0;
  const numerics::MaxMinProblem problem = two_maxima(values);
  std::vector<numerics::MaxMinPoint> known;
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i)
    known.push_back(numerics::point_at(problem, Eigen::VectorXd::Constant(1, i / double{steps})));
  values = 0;
  const std::vector<numerics::MaxMinPoint> found = study::maxima_on_a_line(
      problem, known, 4,
      [](std::size_t count, std::string_view, const std::function<numerics::MaxMinPoint(std::size_t)>& find) {
        std::vector<numerics::MaxMinPoint> all;
        for (std::size_t i = 0; i < count; ++i) all.push_back(find(i));
        return all;
      });
  constexpr double of_the_range = 2e-4;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].x(0), 0.7, of_the_range);
  EXPECT_NEAR(found[0].objective, 0.5, 4 * of_the_range * of_the_range);
  EXPECT_NEAR(found[1].x(0), 0.2, of_the_range);
  EXPECT_NEAR(found[1].objective, 0.3, 5 * of_the_range);
  EXPECT_LT(values, 40);
}

}  // namespace line_search_test
