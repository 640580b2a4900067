// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/product_update.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "trivet/numerics/lanes/instruction_set.h"

namespace product_update_test {

using namespace trivet;

/// Sums of up to a hundred products of numbers below one.
constexpr double round_off = 400 * std::numeric_limits<double>::epsilon();

Eigen::MatrixXd sample(Eigen::Index rows, Eigen::Index columns, double phase) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&](Eigen::Index i, Eigen::Index j) {
    return std::sin(phase + static_cast<double>(3 * i + 7 * j + i * j));
  });
}

class ProductUpdate : public testing::Test {
 protected:
  ~ProductUpdate() override { numerics::use_instruction_set(""); }
};

TEST_F(ProductUpdate, IsThatOfThePlainProductForAllSizesAndInstructionSets) {
  for (const std::string& set : numerics::instruction_sets()) {
    numerics::use_instruction_set(set);
    numerics::ProductUpdate update;
    for (const auto& [rows, columns, depth] :
         {std::array{1, 1, 1}, {24, 8, 5}, {25, 9, 96}, {301, 250, 100}, {7, 7, 0}}) {
      SCOPED_TRACE(set + ", " + std::to_string(rows) + " × " + std::to_string(columns));
      const Eigen::MatrixXd a = sample(rows, depth, 0.1), b = sample(columns, depth, 0.2);
      Eigen::MatrixXd border = sample(rows + 5, columns + 4, 0.3), expected = border;
      expected.block(3, 2, rows, columns) -= a * b.transpose();
      update.subtract(a, b, border.block(3, 2, rows, columns), numerics::Needed::all);
      EXPECT_LT((border - expected).cwiseAbs().maxCoeff(), round_off);
    }
  }
}

TEST_F(ProductUpdate, OfALowerTriangleLeavesItsSurroundingsAndDoesNotDependOnThreads) {
  constexpr Eigen::Index rows = 520, columns = 500, depth = 60;
  const Eigen::MatrixXd a = sample(rows, depth, 0.1), b = sample(columns, depth, 0.2);
  Eigen::MatrixXd one = sample(rows + 5, columns + 4, 0.3), expected = one;
  expected.block(3, 2, rows, columns) -= a * b.transpose();
  Eigen::MatrixXd three = one;
  numerics::ProductUpdate update;
  update.subtract(a, b, one.block(3, 2, rows, columns), numerics::Needed::lower_triangle, 1);
  update.subtract(a, b, three.block(3, 2, rows, columns), numerics::Needed::lower_triangle, 3);
  for (Eigen::MatrixXd* m : {&one, &three, &expected})
    m->block(3, 2, rows, columns).triangularView<Eigen::StrictlyUpper>().setZero();
  EXPECT_LT((one - expected).cwiseAbs().maxCoeff(), round_off);
  EXPECT_EQ(one, three);
}

}  // namespace product_update_test
