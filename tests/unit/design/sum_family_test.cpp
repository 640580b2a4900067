// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/sum_family.h"

#include <gmock/gmock.h>

#include <cmath>

#include "trivet/foundation/index.h"

namespace sum_family_test {

using namespace trivet;
using design::SumFamily;

constexpr double round_off = 1e-13;  // sums of a few products

/// Entries of four numbers: a b², b c, log d, and one that is constant.
design::PackedOrReason packed(const Eigen::VectorXd& v) {
  Eigen::VectorXd entries(4);
  entries << v(0) * v(1) * v(1), v(1) * v(2) - 3 * v(0), std::log(v(3)), 5;
  return {design::PackedDesign{entries, Eigen::VectorXd::Constant(4, 10)}, ""};
}

const std::vector<design::SumVariable> ranges = {{0.3, 3, "a"}, {-0.4, 0.2, "b"}, {-1, 1, "c"}, {1, 1000, "d"}};

Eigen::VectorXd values(double a, double b, double c, double d) { return Eigen::Vector4d(a, b, c, d); }

TEST(SumFamily, ReproducesDesignsUpToTheEndsOfTheRanges) {
  const auto family = SumFamily::fitted(packed, ranges).family;
  ASSERT_TRUE(family);
  for (const Eigen::VectorXd& v : {values(0.3, -0.4, -1, 1), values(3, 0.2, 1, 1000), values(1, 0, 0.5, 77)}) {
    const Eigen::VectorXd exact = packed(v).design->entries, found = family->at(v);
    for (Eigen::Index e = 0; e < exact.size(); ++e) EXPECT_NEAR(found(e), exact(e), 10 * round_off) << e;
  }
  EXPECT_LE(family->worst_difference(), 1e-12);
}

TEST(SumFamily, HasATermForEachProductThatActsAndForNoOther) {
  const auto family = SumFamily::fitted(packed, ranges).family;
  ASSERT_TRUE(family);
  // 1; a; b, b²; c; log d; a b, a b²; b c
  EXPECT_EQ(family->terms(), 9u);
}

/// Couplings of four equal mounts at ± x, ± y with equal ranges of their stiffness: they cancel where all have the
/// same.
TEST(SumFamily, HasTheTermsThatCancelInASymmetricDesign) {
  const auto couplings = [](const Eigen::VectorXd& v) {
    Eigen::VectorXd entries(3);
    entries << (v(0) - v(1) - v(2) + v(3)) * v(4) * v(5), (v(0) + v(1) - v(2) - v(3)) * v(4),
        (v(0) + v(1) + v(2) + v(3)) * v(5) * v(5);
    return design::PackedOrReason{design::PackedDesign{entries, Eigen::VectorXd::Constant(3, 10)}, ""};
  };
  const design::SumVariable stiffness{0.3, 4, "k"};
  const auto found =
      SumFamily::fitted(couplings, {stiffness, stiffness, stiffness, stiffness, {0.2, 0.6, "x"}, {0.1, 0.4, "y"}});
  ASSERT_TRUE(found.family) << found.reason;
  Eigen::VectorXd design(6);
  design << 4, 0.3, 0.3, 2, 0.6, 0.4;
  EXPECT_NEAR(found.family->at(design)(0), 5.4 * 0.6 * 0.4, 10 * round_off);
}

TEST(SumFamily, GivesTheSameDesignsManyAtATime) {
  const auto family = SumFamily::fitted(packed, ranges).family;
  ASSERT_TRUE(family);
  Eigen::MatrixXd points(11, 4);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = values(0.3 + 0.2 * double(i), -0.4 + 0.05 * double(i), 0.1, 1 + double(i * i)).transpose();
  const Eigen::MatrixXd many = family->designs(points);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::VectorXd one = family->at(points.row(i).transpose());
    for (Eigen::Index e = 0; e < one.size(); ++e) EXPECT_NEAR(many(i, e), one(e), 10 * round_off);
  }
}

TEST(SumFamily, HasTheSlopesOfItsEntries) {
  const auto family = SumFamily::fitted(packed, ranges).family;
  ASSERT_TRUE(family);
  const double a = 1.7, b = -0.15, c = 0.4, d = 30;
  Eigen::MatrixXd exact = Eigen::MatrixXd::Zero(4, 4);
  exact.row(0) << b * b, 2 * a * b, 0, 0;
  exact.row(1) << -3, c, b, 0;
  exact(2, 3) = 1 / d;
  const Eigen::MatrixXd found = family->slopes(values(a, b, c, d));
  for (Eigen::Index e = 0; e < 4; ++e)
    for (Eigen::Index j = 0; j < 4; ++j) EXPECT_NEAR(found(e, j), exact(e, j), 100 * round_off) << e << " " << j;
}

TEST(SumFamily, FollowsATurnThatIsNoPolynomial) {
  const auto turned = [](const Eigen::VectorXd& v) {
    Eigen::VectorXd entries(2);
    entries << v(1) * std::pow(std::cos(v(0)), 2), v(1) * std::cos(v(0)) * std::sin(v(0));
    return design::PackedOrReason{design::PackedDesign{entries, Eigen::VectorXd::Ones(2)}, ""};
  };
  const auto family = SumFamily::fitted(turned, {{-0.7, 0.7, "angle"}, {0.5, 2, "stiffness"}}).family;
  ASSERT_TRUE(family);
  EXPECT_NEAR(family->at(Eigen::Vector2d(0.31, 1.4))(1), 1.4 * std::cos(0.31) * std::sin(0.31), 1e-12);
}

TEST(SumFamily, RejectsAKinkAndNamesItsNumber) {
  const auto bent = [](const Eigen::VectorXd& v) {
    const Eigen::VectorXd entries = Eigen::VectorXd::Constant(1, v(0) + std::abs(v(1) - 0.3));
    return design::PackedOrReason{design::PackedDesign{entries, Eigen::VectorXd::Ones(1)}, ""};
  };
  const auto found = SumFamily::fitted(bent, {{0, 1, "length"}, {0, 1, "delta"}});
  EXPECT_FALSE(found.family);
  EXPECT_EQ(found.reason, "matrices that polynomials of degree 16 do not reproduce along delta");
}

TEST(SumFamily, RejectsAFunctionThatIsFlatOnlyWhereItWasLookedAt) {
  const auto far = [](const Eigen::VectorXd& v) {
    const double above = std::max(0.0, v(0) + v(1) - 1.2);  // 0 where either is at its first node
    const Eigen::VectorXd entries = Eigen::VectorXd::Constant(1, 1 + above * (v(0) < 1 && v(1) < 1 ? 1 : 0));
    return design::PackedOrReason{design::PackedDesign{entries, Eigen::VectorXd::Ones(1)}, ""};
  };
  const auto found = SumFamily::fitted(far, {{0, 1, "a"}, {0, 1, "b"}});
  EXPECT_FALSE(found.family);
  EXPECT_THAT(found.reason, testing::HasSubstr("does not reproduce within 1e-12"));
}

TEST(SumFamily, ComparesAlsoTheCornersIfAskedTo) {
  const auto none_in_a_corner = [](const Eigen::VectorXd& v) {
    return v(0) < 1e-6 && v(1) > 0.999 ? design::PackedOrReason{{}, "no model in the corner"}
                                       : design::PackedOrReason{design::PackedDesign{v, Eigen::VectorXd::Ones(2)}, ""};
  };
  const std::vector<design::SumVariable> two = {{0, 1, "a"}, {0, 1, "b"}};
  EXPECT_TRUE(SumFamily::fitted(none_in_a_corner, two).family);
  EXPECT_EQ(SumFamily::fitted(none_in_a_corner, two, SumFamily::Compared::grid).reason, "no model in the corner");
  const auto found = SumFamily::fitted(packed, ranges, SumFamily::Compared::grid).family;
  ASSERT_TRUE(found);
  EXPECT_THAT(found->words(), testing::HasSubstr("compared with 649 others"));  // 24 and 5⁴
}

// Eight numbers: all ends alone, and corners of all together.
TEST(SumFamily, ComparesTheEndsOfManyNumbersIfAskedTo) {
  std::vector<design::SumVariable> many;
  for (int j = 0; j < 8; ++j) many.push_back({0, 1, std::to_string(j)});
  const auto reason = [&](const std::function<bool(const Eigen::VectorXd&)>& without) {
    const auto some = [&](const Eigen::VectorXd& v) {
      return without(v) ? design::PackedOrReason{{}, "no model"}
                        : design::PackedOrReason{design::PackedDesign{v, Eigen::VectorXd::Ones(8)}, ""};
    };
    EXPECT_TRUE(SumFamily::fitted(some, many).family) << "not among those spread over the ranges";
    return SumFamily::fitted(some, many, SumFamily::Compared::ends).reason;
  };
  EXPECT_EQ(reason([](const Eigen::VectorXd& v) { return v(5) < 1e-6 && v(0) == 0.5; }), "no model");
  EXPECT_EQ(reason([](const Eigen::VectorXd& v) { return v(5) > 0.999 && v(0) == 0.5; }), "no model");
  EXPECT_EQ(reason([](const Eigen::VectorXd& v) { return v.sum() > 7.9; }), "no model");
  EXPECT_EQ(reason([](const Eigen::VectorXd& v) { return v.sum() < 0.01; }), "no model");
  EXPECT_EQ(reason([](const Eigen::VectorXd&) { return false; }), "");
}

TEST(SumFamily, ReportsWhyADesignHasNoForm) {
  const auto some = [](const Eigen::VectorXd& v) {
    return v(0) > 0.9 ? design::PackedOrReason{{}, "frequency-dependent elements"}
                      : design::PackedOrReason{design::PackedDesign{v, Eigen::VectorXd::Ones(1)}, ""};
  };
  EXPECT_EQ(SumFamily::fitted(some, {{0, 1, "a"}}).reason, "frequency-dependent elements");
}

}  // namespace sum_family_test
