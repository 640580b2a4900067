// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

#include "trivet/response/random/pole_expansion.h"

namespace trivet::response {

/// Nodes [rad/s] and weights of an integral over frequency.
struct IntegrationNodes {
  Eigen::VectorXd omega, weight;
};

/// Boundaries of panels between two frequencies, ascending. All poles are outside the Bernstein ellipse of each panel
/// (foci at its ends) for which a Gauss rule of n points converges like 2.8⁻²ⁿ, and half width · `longest_delay` is
/// below 6. Poles on the axis inside the band are not allowed.
[[nodiscard]] std::vector<double> graded_panels(const Eigen::VectorXcd& poles, double from, double to,
                                                double longest_delay);

/// Gauss–Legendre rule with 16 points on every panel between neighbouring ends: error 3e-15 for one pole on its
/// ellipse.
[[nodiscard]] IntegrationNodes gauss_nodes(const std::vector<double>& ends);

/// 15 Gauss–Kronrod nodes on [−1, 1], ascending, with the weights of both rules; the Gauss rule uses 7 of them.
/// [QUADPACK, 1983]
struct KronrodRule {
  Eigen::Array<double, 15, 1> node, kronrod, gauss;
};
[[nodiscard]] KronrodRule kronrod_rule();

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
