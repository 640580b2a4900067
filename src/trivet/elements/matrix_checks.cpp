// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/matrix_checks.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace trivet::elements {

MatrixVerdict examine(const Matrix12& matrix, const Eigen::Matrix<double, 12, 6>& rigid) {
  MatrixVerdict verdict;
  spatial::Vector12 scale;
  for (int i = 0; i < 12; ++i) {
    const double diagonal = std::abs(matrix(i, i));
    const double row = std::max(matrix.row(i).cwiseAbs().maxCoeff(), matrix.col(i).cwiseAbs().maxCoeff());
    scale(i) = std::sqrt(diagonal > 0 ? diagonal : row);
  }
  const auto scaled = [](double value, double by) { return value == 0 ? 0.0 : value / by; };

  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < i; ++j) {
      const double asymmetry = scaled(std::abs(matrix(i, j) - matrix(j, i)), scale(i) * scale(j));
      if (asymmetry > verdict.asymmetry) {
        verdict.asymmetry = asymmetry;
        verdict.asymmetric_row = j;
        verdict.asymmetric_column = i;
      }
    }

  verdict.residual = matrix * rigid;
  const Eigen::Matrix<double, 12, 6> from_left = matrix.transpose() * rigid;
  for (int j = 0; j < 6; ++j) {
    const double motion_scale = rigid.col(j).cwiseAbs().cwiseProduct(scale).maxCoeff();
    for (int i = 0; i < 12; ++i) {
      const double worst = std::max(std::abs(verdict.residual(i, j)), std::abs(from_left(i, j)));
      const double residual = scaled(worst, scale(i) * motion_scale);
      if (residual > verdict.rigid_residual) {
        verdict.rigid_residual = residual;
        verdict.residual_row = i;
        verdict.residual_motion = j;
      }
    }
  }

  Matrix12 symmetric;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) symmetric(i, j) = scaled(0.5 * (matrix(i, j) + matrix(j, i)), scale(i) * scale(j));
  const Eigen::SelfAdjointEigenSolver<Matrix12> solver(symmetric, Eigen::EigenvaluesOnly);
  verdict.lowest_eigenvalue = solver.eigenvalues()(0);
  verdict.highest_eigenvalue = solver.eigenvalues()(11);
  return verdict;
}

bool is_semidefinite(const MatrixVerdict& verdict) {
  const double explained = rounding_of_data + 2 * verdict.rigid_residual;
  return verdict.lowest_eigenvalue >= -explained * std::max(1.0, std::abs(verdict.highest_eigenvalue));
}

}  // namespace trivet::elements
