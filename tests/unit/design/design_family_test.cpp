// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "trivet/design/design_family.h"
#include "trivet/foundation/index.h"

namespace design_family_test {

using namespace trivet;

constexpr double round_off = 1e-13;  // sums of at most six products, the weights of the nodes times their entries

design::PlainDesign design_of(double k, double b) {
  design::PlainDesign design;
  design.A = Eigen::MatrixXd::Identity(2, 2);
  design.K = (Eigen::MatrixXd(2, 2) << 3 + k, -1, -1, 2).finished();
  design.B = b * design.K;
  design.load = Eigen::Vector2d(1, k);
  design.rows = Eigen::MatrixXd::Identity(2, 2);
  design.rows_on_velocity = Eigen::MatrixXd::Zero(2, 2);
  design.derivative = {0, 0};
  return design;
}

TEST(DesignFamily, ReproducesDesignsBetweenItsNodes) {
  const auto family = design::DesignFamily<design::PlainDesign>::fitted(
                          [](const design::FamilyPoint& p) {
                            return design::DesignOrReason<design::PlainDesign>{design_of(p.x * p.x, p.y), ""};
                          },
                          {0.3, 10, "x"}, {0.01, 0.5, "y"})
                          .family;
  ASSERT_TRUE(family);
  EXPECT_EQ(family->x_nodes(), 3u);  // x² and x² y
  EXPECT_EQ(family->y_nodes(), 2u);
  const std::vector<design::FamilyPoint> points = {{0.7, 0.2}, {5.1, 0.2}, {9.9, 0.43}};
  const numerics::Designs designs = family->designs(points);
  for (std::size_t d = 0; d < points.size(); ++d) {
    const design::PlainDesign exact = design_of(points[d].x * points[d].x, points[d].y);
    const auto row = to_index(d);
    EXPECT_NEAR(designs.K(row, 0), exact.K(0, 0), round_off * exact.K(0, 0));
    EXPECT_NEAR(designs.B(row, 1), exact.B(1, 0), round_off * exact.B(0, 0));
    EXPECT_NEAR(designs.load(row, 1), exact.load(1), round_off * exact.load(1));
  }
}

TEST(DesignFamily, UsesLogarithmsIfTheyAreSmoother) {
  const auto family = design::DesignFamily<design::PlainDesign>::fitted(
                          [](const design::FamilyPoint& p) {
                            return design::DesignOrReason<design::PlainDesign>{design_of(std::log(p.x), p.y), ""};
                          },
                          {1, 1000, "x"}, {0.01, 0.5, "y"})
                          .family;
  ASSERT_TRUE(family);
  EXPECT_EQ(family->x_nodes(), 2u);
}

TEST(DesignFamily, RejectsAKinkAndNamesItsParameter) {
  const auto along_x = [](const design::FamilyPoint& p) {
    return design::DesignOrReason<design::PlainDesign>{design_of(std::abs(p.x - 3.3), p.y), ""};
  };
  const auto along_y = [](const design::FamilyPoint& p) {
    return design::DesignOrReason<design::PlainDesign>{design_of(p.x, std::max(p.y, 0.2)), ""};
  };
  const auto of_x =
                 design::DesignFamily<design::PlainDesign>::fitted(along_x, {0.3, 10, "length"}, {0.01, 0.5, "delta"}),
             of_y =
                 design::DesignFamily<design::PlainDesign>::fitted(along_y, {0.3, 10, "length"}, {0.01, 0.5, "delta"});
  EXPECT_FALSE(of_x.family);
  EXPECT_FALSE(of_y.family);
  EXPECT_THAT(of_x.reason, testing::EndsWith("polynomials on 17 nodes do not reproduce within 1e-12 along length"));
  EXPECT_THAT(of_y.reason, testing::EndsWith("within 1e-12 along delta"));
}

TEST(DesignFamily, RejectsRowsThatChange) {
  const auto changing = [](const design::FamilyPoint& p) {
    design::PlainDesign design = design_of(p.x, p.y);
    design.rows(0, 0) = p.x;
    return design::DesignOrReason<design::PlainDesign>{design, ""};
  };
  const auto found = design::DesignFamily<design::PlainDesign>::fitted(changing, {0.3, 10, "x"}, {0.01, 0.5, "y"});
  EXPECT_FALSE(found.family);
  EXPECT_THAT(found.reason, testing::HasSubstr("whose definition differs between designs"));
}

TEST(DesignFamily, ReportsWhyADesignInTheMiddleIsNotPlain) {
  const auto lossy = [](const design::FamilyPoint& p) {
    return p.x > 5 ? design::DesignOrReason<design::PlainDesign>{{}, "loss factors"}
                   : design::DesignOrReason<design::PlainDesign>{design_of(p.x, p.y), ""};
  };
  EXPECT_EQ(design::DesignFamily<design::PlainDesign>::fitted(lossy, {0.3, 10, "x"}, {0.01, 0.5, "y"}).reason,
            "loss factors");
}

}  // namespace design_family_test
