// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/unit_modes.h"

#include <algorithm>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::study {

UnitModes unit_modes(const Eigen::MatrixXd& stiffness) {
  if (stiffness.rows() == 6) {  // most machines: without allocation, faster
    const auto found = numerics::symmetric_eigen(spatial::Matrix6(stiffness));
    return {found.values, found.vectors};
  }
  auto found = numerics::symmetric_eigen(stiffness);
  return {std::move(found.values), std::move(found.vectors)};
}

double least_decoupling(const Eigen::MatrixXd& motion, const Eigen::MatrixXd& momentum, const UnitModes& modes) {
  constexpr double apart = 1e-5;  // of the highest ω²: closer ones have shapes without digits
  const Eigen::MatrixXd shares = (motion * modes.shapes).cwiseProduct(momentum * modes.shapes);
  const Eigen::VectorXd& squares = modes.squares;
  const Eigen::Index n = squares.size();
  const double least_gap = apart * squares(n - 1);
  double least = foundation::infinity;
  for (Eigen::Index k = 0; k < n; ++k) {
    const bool alone =
        (k == 0 || squares(k) - squares(k - 1) > least_gap) && (k + 1 == n || squares(k + 1) - squares(k) > least_gap);
    if (alone) least = std::min(least, shares.col(k).maxCoeff());
  }
  return least;
}

}  // namespace trivet::study
