// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "trivet/assembly/layout.h"
#include "trivet/model/system.h"
#include "trivet/numerics/dynamic_matrices.h"

namespace trivet::assembly {

/// How an element (12 end displacements in its local frame, then its internal coordinates) follows the global coordinates: Tᵀ, a few
/// columns only.
struct ElementMap {
  std::vector<Eigen::Index> rows;                       ///< global rows of the columns of `ends`
  Eigen::MatrixXd ends;                                 ///< (12 + internal) × rows.size()
  elements::Matrices matrices;                          ///< as assembled, scale included
  /// D(ω), 12×12, where the matrices are not exact; the columns of `ends` that belong to the ends come first.
  std::function<elements::Matrix12c(std::complex<double> omega, double near)> dynamic_stiffness;
  Eigen::Index end_columns = 0;
  double defined_from = 0, defined_to = std::numeric_limits<double>::infinity();  ///< of D(ω) [rad/s]
  std::vector<double> knots;                            ///< of a tabulated D(ω) [rad/s]

  [[nodiscard]] bool frequency_dependent() const { return static_cast<bool>(dynamic_stiffness); }

  /// End displacements and internal coordinates for a global vector.
  template <typename Vector>
  [[nodiscard]] Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> coordinates(const Vector& q) const {
    Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> d = Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1>::Zero(ends.rows());
    for (Eigen::Index j = 0; j < ends.cols(); ++j)
      d += ends.col(j).template cast<typename Vector::Scalar>() * q(rows[static_cast<std::size_t>(j)]);
    return d;
  }
};

/// A q̈ + B q̇ + K q = Q of the whole system, in its free coordinates, with the way back to bodies and elements.
struct Assembled {
  Layout layout;
  numerics::DynamicMatrices matrices;   ///< of everything; frequency-dependent elements by their nearest linear system
  std::vector<ElementMap> elements;
  numerics::DynamicMatrices constant;   ///< without the frequency-dependent elements, first rows of `layout`; empty if there are none

  [[nodiscard]] bool frequency_dependent() const { return constant.size() > 0; }
  /// Exact Z(ω) in the first rows of `layout`, also for complex ω near a real one (which piece of a table holds).
  [[nodiscard]] Eigen::MatrixXcd dynamic_stiffness(std::complex<double> omega, double near) const;
};

/// K = Σ T C_e Tᵀ; B and A likewise plus the damping of the system and the bodies.
[[nodiscard]] Assembled assemble(const model::System& system);

}  // namespace trivet::assembly
