// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/designs.h"

#include <cmath>

namespace trivet::numerics {

Eigen::MatrixXd unpacked(const Eigen::ArrayXXd& packed, Eigen::Index design) {
  const auto n = static_cast<Eigen::Index>((std::sqrt(8.0 * static_cast<double>(packed.cols()) + 1) - 1) / 2);
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0, entry = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++entry) matrix(i, j) = matrix(j, i) = packed(design, entry);
  return matrix;
}

DynamicMatrices matrices_of(const Designs& designs, Eigen::Index design) {
  return {unpacked(designs.A, design), unpacked(designs.B, design), unpacked(designs.K, design), {}, true};
}

}  // namespace trivet::numerics
