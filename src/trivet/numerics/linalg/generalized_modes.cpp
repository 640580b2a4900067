// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/generalized_modes.h"

#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/cholesky.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/general_eigen.h"
#include "trivet/numerics/linalg/normed_modes.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"

namespace trivet::numerics {
namespace {

using foundation::epsilon;

/// YᵀPY = 1 but for round-off? Triangular factors of P lose some n ε of (|L||Lᵀ|)_ij ≤ √(P_ii P_jj).
[[maybe_unused]] bool are_orthonormal(const Eigen::MatrixXd& Y, const Eigen::MatrixXd& P) {
  const double round_off = 64 * static_cast<double>(P.rows()) * epsilon;
  const Eigen::RowVectorXd sums = P.diagonal().cwiseSqrt().transpose() * Y.cwiseAbs();
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(Y.cols(), Y.cols());
  return ((Y.transpose() * P * Y - one).array().abs() <= round_off * (1 + (sums.transpose() * sums).array())).all();
}

/// Shapes y and values of S y = μ P y with P positive definite.
void solve_definite(const Eigen::MatrixXd& S, const Eigen::MatrixXd& P, Eigen::VectorXd& mu, Eigen::MatrixXd& y) {
  const SymmetricEigen<Eigen::MatrixXd> eigen = symmetric_eigen(S, P);
  if (!eigen.converged) throw foundation::NotComputable("the symmetric eigensolver did not converge");
  mu = eigen.values;
  y = eigen.vectors;
  assert(are_orthonormal(y, P));
}

GeneralizedModes general_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A) {
  assert(A.rows() == A.cols() && A.rows() > 0);
  const GeneralEigen eigen = general_eigen(lu_solution(A, K));
  if (!eigen.converged) throw foundation::NotComputable("the general eigensolver did not converge");
  const Eigen::VectorXcd& values = eigen.values;
  const double scale = values.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> real;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (std::abs(values(i).imag()) <= std::sqrt(epsilon) * 16 * std::abs(values(i)) ||
        std::abs(values(i)) <= 1e-12 * scale)
      real.push_back(i);
  Eigen::MatrixXd shapes(K.rows(), to_index(real.size()));
  Eigen::VectorXd lambda(shapes.cols());
  for (Eigen::Index i = 0; i < shapes.cols(); ++i) {
    shapes.col(i) = eigen.vectors.col(real[i]).real();
    lambda(i) = values(real[i]).real();
  }
  GeneralizedModes result = normed_modes(K, A, shapes, ModeRoute::general, lambda);
  result.complex_pairs = static_cast<int>(values.size() - shapes.cols()) / 2;
  return result;
}

}  // namespace

GeneralizedModes generalized_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A, bool symmetric) {
  assert(K.rows() == A.rows() && K.cols() == A.cols());
  const Eigen::VectorXd d = unit_scale(A);
  const Eigen::MatrixXd k = d.asDiagonal() * K * d.asDiagonal();
  const Eigen::MatrixXd a = d.asDiagonal() * A * d.asDiagonal();
  GeneralizedModes result;
  Eigen::VectorXd mu;
  Eigen::MatrixXd y;
  if (symmetric && is_positive_definite(A)) {
    solve_definite(k, a, mu, y);
    result = normed_modes(k, a, y, ModeRoute::definite_mass);
  } else if (symmetric && is_positive_definite(K)) {
    solve_definite(a, k, mu, y);
    result = normed_modes(k, a, y, ModeRoute::definite_stiffness);
  } else {
    result = general_modes(k, a);
  }
  result.shapes = (d.asDiagonal() * result.shapes).eval();
  return result;
}

}  // namespace trivet::numerics
