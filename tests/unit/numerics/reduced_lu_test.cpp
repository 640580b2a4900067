// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/reduced_lu.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "trivet/numerics/linalg/decompositions.h"

namespace reduced_lu_test {

using namespace trivet;
using Eigen::Index;
using numerics::ReducedLu;

/// With columns of which only the diagonal and, if it is bordered, the last row are not zero.
Eigen::MatrixXd matrix(Index n, const std::vector<Index>& alone, bool bordered) {
  Eigen::MatrixXd A(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) A(i, j) = std::sin(static_cast<double>(1 + 3 * i + 7 * j + i * j));
  for (const Index j : alone) {
    A.col(j).head(n - 1).setZero();
    if (!bordered) A(n - 1, j) = 0;
    A(j, j) = j % 2 == 0 ? -1.5 : 0.5;
  }
  return A;
}

TEST(ReducedLu, HasTheSolutionAndSignOfTheWholeMatrix) {
  constexpr double round_off = 1e-11;  // of matrices with condition numbers up to 1e4
  const Index n = 40;
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, 1, 2);
  for (const std::vector<Index>& alone : {std::vector<Index>{}, {0}, {3, 4, 5, 20, 38}, {1, 2, 7, 9, 11, 30}})
    for (const bool bordered : {false, true}) {
      const Eigen::MatrixXd A = matrix(n, alone, bordered);
      const ReducedLu found(A, bordered ? ReducedLu::Border::last_row : ReducedLu::Border::none);
      const numerics::PivotedLu<double> whole(A);
      EXPECT_EQ(found.left(), n - static_cast<Index>(alone.size()));
      EXPECT_LT((found.solve(b) - whole.solve(b)).norm(), round_off * whole.solve(b).norm());
      EXPECT_EQ(found.determinant_sign(), whole.determinant() < 0 ? -1 : 1);
    }
}

}  // namespace reduced_lu_test
