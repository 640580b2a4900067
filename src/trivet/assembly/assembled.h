// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/assembly/layout.h"
#include "trivet/model/system.h"
#include "trivet/numerics/dynamic_matrices.h"

namespace trivet::assembly {

/// How the two ends of an element (12 displacements, its local frame) follow the global coordinates: Tᵀ, a few columns only.
struct ElementMap {
  std::vector<Eigen::Index> rows;                       ///< global rows of the columns of `ends`
  Eigen::Matrix<double, 12, Eigen::Dynamic> ends;       ///< 12 × rows.size()
  spatial::Matrix12 stiffness, damping;                 ///< as assembled, scale included
  double loss_factor = 0;

  /// End displacements for a global vector of coordinates.
  template <typename Vector>
  [[nodiscard]] Eigen::Matrix<typename Vector::Scalar, 12, 1> end_displacements(const Vector& q) const {
    Eigen::Matrix<typename Vector::Scalar, 12, 1> d = Eigen::Matrix<typename Vector::Scalar, 12, 1>::Zero();
    for (Eigen::Index j = 0; j < ends.cols(); ++j)
      d += ends.col(j).template cast<typename Vector::Scalar>() * q(rows[static_cast<std::size_t>(j)]);
    return d;
  }
};

/// A q̈ + B q̇ + K q = Q of the whole system, in its free coordinates, with the way back to bodies and elements.
struct Assembled {
  Layout layout;
  numerics::DynamicMatrices matrices;
  std::vector<ElementMap> elements;
};

/// K = Σ T C_e Tᵀ, B likewise plus the damping of the system, A from the bodies.
[[nodiscard]] Assembled assemble(const model::System& system);

}  // namespace trivet::assembly
