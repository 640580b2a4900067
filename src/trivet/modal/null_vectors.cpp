// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/null_vectors.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::modal {
namespace {

/// Gram–Schmidt, twice: the columns may be almost parallel.
void make_orthonormal(Eigen::MatrixXcd& x) {
  for (int round = 0; round < 2; ++round)
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
      for (Eigen::Index i = 0; i < j; ++i) x.col(j) -= x.col(i).dot(x.col(j)) * x.col(i).eval();
      x.col(j).normalize();
    }
}

Eigen::MatrixXcd right_null_vectors(const Eigen::MatrixXcd& z, Eigen::Index count) {
  assert(z.rows() == z.cols() && count > 0 && count <= z.rows());
  if (count == z.rows()) return Eigen::MatrixXcd::Identity(count, count);  // z is nothing but round-off, or exactly 0
  const double shift = 4 * std::numeric_limits<double>::epsilon() * z.cwiseAbs().maxCoeff();
  const Eigen::MatrixXcd regular = z + shift * Eigen::MatrixXcd::Identity(z.rows(), z.cols());
  const numerics::PivotedLu<std::complex<double>> lu(regular);
  // A start that no symmetry of a machine makes orthogonal to what is searched.
  Eigen::MatrixXcd x(z.rows(), count);
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < z.rows(); ++i)
      x(i, j) = 1 + 0.3 * std::cos(static_cast<double>((i + 1) * (j + 1)) * 1.7 + static_cast<double>(j));
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    make_orthonormal(x);
    x = lu.solve(x);
  }
  make_orthonormal(x);
  return x;
}

}  // namespace

NullVectors null_vectors(const Eigen::MatrixXcd& Z, const Eigen::VectorXd& scale, Eigen::Index count) {
  const Eigen::MatrixXcd scaled = scale.asDiagonal() * Z * scale.asDiagonal(), transposed = scaled.transpose();
  return {scale.asDiagonal() * right_null_vectors(transposed, count),
          scale.asDiagonal() * right_null_vectors(scaled, count)};
}

}  // namespace trivet::modal
