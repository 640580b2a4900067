// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "trivet/response/random/integration_panels.h"
#include "trivet/response/random/pole_expansion.h"

namespace trivet::response {

/// Accuracy of every integral of a product, relative to √(I_jj I_kk).
inline constexpr double fraction_accuracy = 1e-14;

/// Integrals of products of 1/(iω − λ_k) and of powers of iω, on given nodes. A result is a sum of real coefficients
/// times basis functions: for a conjugate pair 1/(s − λ) + 1/(s − λ̄) and i/(s − λ) − i/(s − λ̄), the powers themselves;
/// with complex residues each function and i times it.
class BasisIntegrals {
 public:
  BasisIntegrals(const PoleExpansions& expansions, IntegrationNodes nodes);

  [[nodiscard]] const Eigen::VectorXd& omega() const { return nodes_.omega; }
  /// Real coefficients of the basis: channels × functions.
  [[nodiscard]] Eigen::MatrixXd coefficients(const PoleExpansion& part) const;
  /// Channels × nodes, without the delay of the part.
  [[nodiscard]] Eigen::MatrixXcd values(const PoleExpansion& part) const;
  /// Re ∫ weight u_j conj(u_k) dω for all pairs of basis functions; `weight` per node.
  [[nodiscard]] Eigen::MatrixXd real_products(const Eigen::VectorXcd& weight) const;

 private:
  /// first · factor + second · second_factor of the plain functions.
  struct Function {
    Eigen::Index first = 0, second = 0;
    std::complex<double> factor = 1, second_factor = 0;
  };
  [[nodiscard]] Eigen::MatrixXcd products(const Eigen::VectorXcd& weight) const;

  Eigen::VectorXcd poles_;
  std::vector<int> powers_;  ///< powers that occur in any part
  std::vector<Function> basis_;
  IntegrationNodes nodes_;
  Eigen::MatrixXd real_, imag_;  ///< nodes × plain functions: the poles, then the powers
  Eigen::MatrixXd square_;       ///< |1/(iω − λ)|²
};

}  // namespace trivet::response
