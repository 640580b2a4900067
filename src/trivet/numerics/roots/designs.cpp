// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/roots/designs.h"

#include <cmath>
#include <string>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {

void require_shapes(const Designs& designs, const char* what) {
  const Eigen::Index n = designs.coordinates(), entries = n * (n + 1) / 2;
  const auto refuse = [&](const char* rule) { throw foundation::InvalidInput(std::string(what) + ": " + rule); };
  if (n < 1) refuse("at least one coordinate is needed");
  for (const Eigen::ArrayXXd* m : {&designs.A, &designs.B, &designs.K})
    if (m->rows() != designs.count() || m->cols() != entries)
      refuse("A, B and K need a row of n(n + 1)/2 entries for every design");
  if (designs.load.rows() != 1 && designs.load.rows() != designs.count())
    refuse("the load needs one row, or one for every design");
}

Eigen::Index coordinates_of(Eigen::Index entries) {
  const auto n = static_cast<Eigen::Index>((std::sqrt(8.0 * static_cast<double>(entries) + 1) - 1) / 2);
  return n * (n + 1) / 2 == entries ? n : 0;
}

void pack(const Eigen::MatrixXd& matrix, Eigen::ArrayXXd& packed, Eigen::Index design) {
  for (Eigen::Index i = 0, entry = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++entry) packed(design, entry) = matrix(i, j);
}

Eigen::MatrixXd unpacked(const Eigen::ArrayXXd& packed, Eigen::Index design) {
  const Eigen::Index n = coordinates_of(packed.cols());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0, entry = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++entry) matrix(i, j) = matrix(j, i) = packed(design, entry);
  return matrix;
}

DynamicMatrices matrices_of(const Designs& designs, Eigen::Index design) {
  return {unpacked(designs.A, design), unpacked(designs.B, design), unpacked(designs.K, design), {}, true};
}

}  // namespace trivet::numerics
