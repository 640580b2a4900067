// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/search/zeros_and_minima.h"

namespace search_test {

using namespace trivet;
using numerics::minimum_between;
using numerics::zero_between;
using test::RelativelyNear;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double round_off = 4 * test::epsilon;
constexpr double triple_zero = 1e-19;  // far below round-off of the ends: the search goes on to a value of 0
constexpr double flat_minimum = 1e-7;  // root of round-off, the accuracy of a minimum that values enclose

/// Counts the values that a search requests.
struct Counted {
  std::function<double(double)> function;
  int count = 0;
  double operator()(double x) { return ++count, function(x); }
};

TEST(ZeroBetween, FindsPublishedConstants) {
  EXPECT_THAT(zero_between(0, 1, [](double x) { return std::cos(x) - x; }),
              RelativelyNear(0.7390851332151607, round_off));
  EXPECT_THAT(zero_between(4, 2, [](double x) { return std::sin(x); }), RelativelyNear(std::numbers::pi, round_off))
      << "ends in any order";
  EXPECT_THAT(zero_between(0, 1, [](double x) { return x * std::exp(x) - 1; }),
              RelativelyNear(0.5671432904097839, round_off));
}

TEST(ZeroBetween, NeedsFewValuesAlsoIfTheyDifferByOrders) {
  constexpr int most_values = 30;  // bisection needs 53 or more
  Counted smooth{[](double x) { return std::exp(3 * x) - 2; }}, steep{[](double x) { return std::pow(x, 9) - 1e-3; }};
  EXPECT_THAT(zero_between(-1, 4, std::ref(smooth)), RelativelyNear(std::log(2.0) / 3, round_off));
  EXPECT_THAT(zero_between(0, 10, std::ref(steep)), RelativelyNear(std::pow(1e-3, 1.0 / 9), round_off));
  EXPECT_LE(smooth.count, most_values);
  EXPECT_LE(steep.count, most_values);
}

TEST(ZeroBetween, EndsAtAJumpAndAtZero) {
  EXPECT_THAT(zero_between(0, 1, [](double x) { return x < 0.3 ? -1e-200 : 1e200; }), RelativelyNear(0.3, round_off));
  EXPECT_NEAR(zero_between(-1, 2, [](double x) { return x * x * x; }), 0, triple_zero);
  EXPECT_EQ(zero_between(1, 2, [](double x) { return x - 1; }), 1);
  EXPECT_EQ(zero_between(1, 2, [](double x) { return x - 2; }), 2);
}

TEST(ZeroBetween, StatesWhatIsMissing) {
  EXPECT_THAT([] { (void)zero_between(1, 2, [](double x) { return x; }); },
              testing::ThrowsMessage<foundation::InvalidInput>(testing::HasSubstr("must differ in sign")));
  EXPECT_THROW((void)zero_between(0, infinity, [](double x) { return x - 1; }), foundation::InvalidInput);
  EXPECT_THROW((void)zero_between(0, 1, [](double x) { return std::log(x) + 1; }), foundation::InvalidInput);
  EXPECT_THROW((void)zero_between(-1, 1, [](double x) { return x == -1 ? -1
                                                            : x == 1   ? 1
                                                                       : std::nan(""); }),
               foundation::NotComputable);
}

TEST(MinimumBetween, FindsPlaceToTheRootOfRoundOffAndValueToRoundOff) {
  constexpr double root = 3e-8, most_values = 25;  // 40 golden sections have this resolution
  Counted cosine{[](double x) { return std::cos(x); }};
  const numerics::Minimum found = minimum_between(2, 5, std::ref(cosine));
  EXPECT_NEAR(found.at, std::numbers::pi, 1.5 * root);
  EXPECT_THAT(found.value, RelativelyNear(-1, round_off));
  EXPECT_LE(cosine.count, most_values);
}

TEST(MinimumBetween, TakesFewerValuesForFewerBits) {
  constexpr int bits = 12, most_values = 14;
  Counted cosine{[](double x) { return std::cos(x); }};
  const numerics::Minimum found = minimum_between(2, 5, std::ref(cosine), bits);
  EXPECT_NEAR(found.at, std::numbers::pi, 1.5 * std::exp2(1 - bits));
  EXPECT_EQ(found.value, std::cos(found.at));
  EXPECT_LE(cosine.count, most_values);
}

TEST(MinimumBetween, ResolvesANarrowRangeFarFromZero) {
  constexpr double centre = 1e4, half = 1e-5, root = 3e-8;
  const auto valley = [&](double x) { return 1 + std::pow((x - centre) / half - 0.25, 2); };
  const numerics::Minimum found = minimum_between(centre - half, centre + half, valley);
  const double rounding_of_place = test::epsilon * centre / half;
  EXPECT_NEAR((found.at - centre) / half, 0.25, root + rounding_of_place);
}

TEST(MinimumBetween, AcceptsInfiniteValuesAndAnEnd) {
  EXPECT_EQ(minimum_between(0, 1, [](double x) { return x > 0.3 && x < 0.6 ? -infinity : x; }).value, -infinity);
  EXPECT_NEAR(minimum_between(0, 1, [](double x) { return x < 0.7 ? infinity : x * x; }).at, 0.7, flat_minimum);
  EXPECT_NEAR(minimum_between(3, 4, [](double x) { return x; }).at, 3, flat_minimum);
  EXPECT_THROW((void)minimum_between(1, 1, [](double x) { return x; }), foundation::InvalidInput);
  EXPECT_THROW((void)minimum_between(0, 1, [](double) { return std::nan(""); }), foundation::NotComputable);
}

}  // namespace search_test
