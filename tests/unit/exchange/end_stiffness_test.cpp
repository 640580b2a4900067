// SPDX-License-Identifier: BSD-3-Clause
// Static condensation of matrices of other programs onto two ends.
#include "trivet/exchange/end_stiffness.h"

#include <gtest/gtest.h>

#include "support/matchers.h"
#include "support/matrix_files.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/exchange/matrix_formats.h"
#include "trivet/exchange/text/file_bytes.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::test {
namespace end_stiffness_test {

using exchange::Label;
using exchange::NamedMatrix;
using testing::HasSubstr;

/// 18 condensed rows whose scaled reciprocal condition is about 1e-4.
constexpr double condensed_round_off = 1e5 * epsilon;

std::string file_content(const std::string& name) {
  return *exchange::file_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/data/matrices/" + name);
}

/// The bar in four elements; its nodes are 11, 12, 13, 14, 15.
NamedMatrix chain() {
  NamedMatrix matrix = *exchange::read_numpy_array(file_content("chain.npy"), "f");
  for (int node = 11; node <= 15; ++node)
    for (int component = 1; component <= 6; ++component) matrix.labels.push_back({node, component});
  return matrix;
}

/// Rows and columns in another order.
NamedMatrix shuffled(const NamedMatrix& matrix) {
  NamedMatrix result = matrix;
  const auto n = static_cast<int>(matrix.labels.size());
  const auto from = [n](int i) { return (7 * i + 3) % n; };  // 7 and 30 have no common divisor
  for (int i = 0; i < n; ++i) {
    result.labels[i] = matrix.labels[from(i)];
    for (int j = 0; j < n; ++j) result.values(i, j) = matrix.values(from(i), from(j));
  }
  return result;
}

TEST(EndStiffness, AChainOfBeamsEqualsTheLongBeam) {
  const Eigen::MatrixXd wanted = bernoulli();
  for (const NamedMatrix& matrix : {chain(), shuffled(chain())}) {
    const auto ends = exchange::reduce_to_ends(matrix, exchange::NodeEnd{11}, exchange::NodeEnd{15});
    ASSERT_TRUE(ends) << complaint(ends);
    EXPECT_THAT(ends->values, NearInUnits(wanted, entry_scale(wanted), condensed_round_off));
    EXPECT_TRUE(ends->warnings.list().empty());
  }
}

TEST(EndStiffness, IsTheSameByRowsAndByLabels) {
  NamedMatrix matrix = chain();
  matrix.labels.clear();
  const auto ends = exchange::reduce_to_rows(matrix, {1, 2, 3, 4, 5, 6, 25, 26, 27, 28, 29, 30});
  ASSERT_TRUE(ends) << complaint(ends);
  EXPECT_THAT(ends->values, NearInUnits(bernoulli(), entry_scale(bernoulli()), condensed_round_off));
}

TEST(EndStiffness, InSiPassesTheChecksOfAnElement) {
  const auto ends = exchange::reduce_to_ends(chain(), exchange::NodeEnd{11}, exchange::NodeEnd{15});
  const auto si = exchange::in_si(ends->values, 0.001, 1);
  Bar bar{.length = 0.12,
          .axial = 210e9 * 200e-6,
          .torsion = 80e9 * 4577e-12,
          .bending_about_x = 210e9 * 1666.6666666666667e-12,
          .bending_about_y = 210e9 * 6666.6666666666667e-12};
  EXPECT_THAT(si, NearInUnits(bernoulli(bar), entry_scale(bernoulli(bar)), condensed_round_off));
  const auto verdict = elements::examine(si, elements::rigid_motions({0, 0, 0.12}, Eigen::Matrix3d::Identity()));
  EXPECT_LT(verdict.rigid_residual, elements::silent_residual);
  EXPECT_TRUE(elements::is_semidefinite(verdict));
}

TEST(EndStiffness, IsTheSameWithRotationsOnASecondNode) {
  NamedMatrix matrix = chain();
  for (Label& label : matrix.labels)
    if ((label.node == 11 || label.node == 15) && label.component > 3) label = {label.node + 100, label.component - 3};
  const auto ends = exchange::reduce_to_ends(matrix, exchange::NodeEnd{11, 111}, exchange::NodeEnd{15, 115});
  ASSERT_TRUE(ends) << complaint(ends);
  EXPECT_THAT(ends->values, NearInUnits(bernoulli(), entry_scale(bernoulli()), condensed_round_off));
}

TEST(EndStiffness, IncludesTheLeversOfPlates) {
  // The reference point of end N is 30 mm in front of it, and node 12 is in the same plate: the bar is shortened to
  // 90 mm, its lever is 60 mm.
  exchange::RigidEnd n{{0, 0, -30}, {{11, {0, 0, 0}}, {12, {0, 0, 30}}}};
  exchange::RigidEnd k{{5, -3, 120}, {{15, {0, 0, 120}}}};
  const auto ends = exchange::reduce_to_ends(chain(), n, k);
  ASSERT_TRUE(ends) << complaint(ends);
  Eigen::Matrix<double, 12, 12> levers = Eigen::Matrix<double, 12, 12>::Identity();
  levers.block<3, 3>(0, 3) << 0, 60, 0, -60, 0, 0, 0, 0, 0;
  levers.block<3, 3>(6, 9) << 0, 0, -3, 0, 0, -5, 3, 5, 0;
  const Eigen::MatrixXd wanted = levers.transpose() * bernoulli({.length = 90}) * levers;
  EXPECT_THAT(ends->values, NearInUnits(wanted, entry_scale(wanted), condensed_round_off));
}

TEST(EndStiffness, KeepsTheLossFactorOfAComplexMatrix) {
  NamedMatrix matrix = chain();
  matrix.imaginary = 0.02 * matrix.values;
  const auto ends = exchange::reduce_to_ends(matrix, exchange::NodeEnd{11}, exchange::NodeEnd{15});
  ASSERT_TRUE(ends) << complaint(ends);
  const Eigen::MatrixXd loss = 0.02 * bernoulli();
  EXPECT_THAT(ends->values, NearInUnits(bernoulli(), entry_scale(bernoulli()), condensed_round_off));
  EXPECT_THAT(*ends->imaginary, NearInUnits(loss, entry_scale(loss), condensed_round_off));
}

TEST(EndStiffness, ExcludesEmptyRowsWithAWarning) {
  NamedMatrix matrix = chain();
  matrix.values.conservativeResizeLike(Eigen::MatrixXd::Zero(32, 32));
  matrix.labels.push_back({20, 4});
  matrix.labels.push_back({20, 5});
  const auto ends = exchange::reduce_to_ends(matrix, exchange::NodeEnd{11}, exchange::NodeEnd{15});
  ASSERT_TRUE(ends) << complaint(ends);
  ASSERT_EQ(ends->warnings.list().size(), 1u);
  EXPECT_THAT(message(ends->warnings.list()[0]),
              HasSubstr("2 rows hold only zeros, the first one is node 20, component 4"));
}

TEST(FixedComponents, AreCompletedByTheRigidMotions) {
  const exchange::Matrix12 whole = bernoulli();
  const auto motions = elements::rigid_motions({0, 0, Bar{}.length}, Eigen::Matrix3d::Identity());
  for (const std::vector<int>& fixed : {std::vector<int>{0, 1, 2, 3, 4, 5}, std::vector<int>{6, 7, 8},
                                        std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}) {
    exchange::Matrix12 marked = whole;
    for (const int row : fixed) marked(row, row) = 1e36;
    EXPECT_EQ(exchange::fixed_components(marked), fixed);
    EXPECT_THAT(exchange::completed_by_rigid_motion(marked, fixed, motions),
                NearInUnits(whole, entry_scale(whole), condensed_round_off));
  }
  EXPECT_TRUE(exchange::fixed_components(whole).empty());
}

TEST(FixedComponents, OfTheInteriorAreAnError) {
  NamedMatrix fixed = chain();
  fixed.values(14, 14) = 1e36;  // node 13, component 3
  EXPECT_THAT(complaint(exchange::reduce_to_ends(fixed, exchange::NodeEnd{11}, exchange::NodeEnd{15})),
              HasSubstr("1e+36 on the diagonal of node 13, component 3"));
}

TEST(EndStiffness, NamesUnconnectedParts) {
  NamedMatrix matrix = chain();
  matrix.values.conservativeResizeLike(Eigen::MatrixXd::Zero(32, 32));  // two masses on a free spring
  matrix.values.bottomRightCorner<2, 2>() << 500, -500, -500, 500;
  matrix.labels.push_back({20, 1});
  matrix.labels.push_back({21, 1});
  const auto ends = exchange::reduce_to_ends(matrix, exchange::NodeEnd{11}, exchange::NodeEnd{15});
  EXPECT_THAT(complaint(ends), HasSubstr("condensation: node 21, component 1 can move without force"));
}

TEST(EndStiffness, NamesTheMissingEnd) {
  const auto said = [](int n, int k) {
    return complaint(exchange::reduce_to_ends(chain(), exchange::NodeEnd{n}, exchange::NodeEnd{k}));
  };
  EXPECT_THAT(said(11, 99), HasSubstr("end K: node 99: no such node; its component 1 is needed"));
  EXPECT_THAT(said(11, 11), HasSubstr("ends: node 11, component 1 is named twice"));
  NamedMatrix matrix = chain();
  matrix.labels[3] = {500, 1};
  EXPECT_THAT(complaint(exchange::reduce_to_ends(matrix, exchange::NodeEnd{11}, exchange::NodeEnd{15})),
              HasSubstr("end N: node 11: components 1, 2, 3, 5, 6; its component 4 is needed"));
  matrix.labels.clear();
  EXPECT_THAT(complaint(exchange::reduce_to_ends(matrix, exchange::NodeEnd{11}, exchange::NodeEnd{15})),
              HasSubstr("the file has no node numbers"));
  EXPECT_THAT(complaint(exchange::reduce_to_ends(chain(), exchange::RigidEnd{},
                                                 exchange::RigidEnd{{0, 0, 0}, {{15, {0, 0, 0}}}})),
              HasSubstr("end N: no nodes"));
}

TEST(EndStiffness, RejectsRowsOutsideTheMatrix) {
  EXPECT_THAT(complaint(exchange::reduce_to_rows(chain(), {0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 31})),
              HasSubstr("rows: row 0"));
  EXPECT_THAT(complaint(exchange::reduce_to_rows(chain(), {1, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})),
              HasSubstr("named twice"));
}

TEST(EndStiffness, RejectsInvalidUnits) {
  EXPECT_THROW(static_cast<void>(exchange::in_si(bernoulli(), 0, 1)), foundation::InvalidInput);
  EXPECT_THROW(static_cast<void>(exchange::in_si(bernoulli(), 1, -1)), foundation::InvalidInput);
}

}  // namespace end_stiffness_test
}  // namespace trivet::test
