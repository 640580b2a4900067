// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/levenberg_marquardt.h"

#include <cmath>
#include <limits>

#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::identification {
namespace {

using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

Eigen::MatrixXd jacobian(const Residuals& residuals, const Eigen::VectorXd& at, Eigen::Index rows) {
  constexpr double step = 1e-5;  // error 1e-10 by truncation, 1e-11 by rounding
  Eigen::MatrixXd result(rows, at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const Eigen::VectorXd change = step * Eigen::VectorXd::Unit(at.size(), i);
    result.col(i) = (residuals(at + change) - residuals(at - change)) / (2 * step);
  }
  return result;
}

/// (JᵀJ)⁻¹ by eigenvalues; a parameter in a direction without influence gets an infinite variance.
Eigen::MatrixXd unit_covariance(const Eigen::MatrixXd& jacobian) {
  constexpr double without_influence = 1e-14;
  const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  const numerics::SymmetricEigen<Eigen::MatrixXd> eigen = numerics::symmetric_eigen(normal);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(normal.rows(), normal.cols());
  const double largest = eigen.values.maxCoeff();
  for (Eigen::Index i = 0; i < normal.rows(); ++i) {
    const Eigen::VectorXd direction = eigen.vectors.col(i);
    if (eigen.values(i) > without_influence * largest) {
      result += direction * direction.transpose() / eigen.values(i);
      continue;
    }
    for (Eigen::Index p = 0; p < normal.rows(); ++p)
      if (std::abs(direction(p)) > 1e-3) result(p, p) = std::numeric_limits<double>::infinity();
  }
  return result;
}

}  // namespace

LeastSquaresMinimum least_squares_minimum(const Residuals& residuals, const Eigen::VectorXd& start) {
  constexpr int most_steps = 200;
  constexpr double settled = 1e-10, longest_step = 2;
  LeastSquaresMinimum minimum{start, residuals(start), {}, false};
  double damping = 1e-3;
  for (int step = 0; step < most_steps && minimum.residuals.allFinite() && !minimum.converged; ++step) {
    const Eigen::MatrixXd slope = jacobian(residuals, minimum.parameters, minimum.residuals.size());
    const Eigen::MatrixXd normal = slope.transpose() * slope;
    const Eigen::VectorXd downhill = -slope.transpose() * minimum.residuals;
    const double floor = 1e-12 * normal.diagonal().maxCoeff();
    for (bool better = false; !better; damping *= 8) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() += damping * normal.diagonal().cwiseMax(floor);
      Eigen::VectorXd change = numerics::ldlt_solution(damped, downhill);
      if (const double length = change.cwiseAbs().maxCoeff(); length > longest_step) change *= longest_step / length;
      const Eigen::VectorXd trial = residuals(minimum.parameters + change);
      minimum.converged = change.cwiseAbs().maxCoeff() < settled || damping > 1e12;
      better = trial.allFinite() && trial.squaredNorm() <= minimum.residuals.squaredNorm();
      if (better) {
        minimum.parameters += change;
        minimum.residuals = trial;
        damping *= 1.0 / 80;
      }
      if (minimum.converged || !change.allFinite()) break;
    }
  }
  if (minimum.residuals.allFinite())
    minimum.unit_covariance = unit_covariance(jacobian(residuals, minimum.parameters, minimum.residuals.size()));
  return minimum;
}

}  // namespace trivet::identification
