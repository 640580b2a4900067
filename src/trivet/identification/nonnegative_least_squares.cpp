// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/nonnegative_least_squares.h"

#include <Eigen/QR>
#include <algorithm>
#include <vector>

namespace trivet::identification {
namespace {

/// Least squares over the free columns; the others are 0.
Eigen::VectorXd free_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const std::vector<bool>& is_free) {
  std::vector<Eigen::Index> columns;
  for (Eigen::Index j = 0; j < a.cols(); ++j)
    if (is_free[static_cast<std::size_t>(j)]) columns.push_back(j);
  Eigen::MatrixXd chosen(a.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) chosen.col(static_cast<Eigen::Index>(c)) = a.col(columns[c]);
  const Eigen::VectorXd values = chosen.colPivHouseholderQr().solve(b);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(a.cols());
  for (std::size_t c = 0; c < columns.size(); ++c) result(columns[c]) = values(static_cast<Eigen::Index>(c));
  return result;
}

/// How far to go from x towards the trial before a free component falls to 0.
double admissible_step(const Eigen::VectorXd& x, const Eigen::VectorXd& trial, const std::vector<bool>& is_free) {
  double step = 1;
  for (Eigen::Index j = 0; j < x.size(); ++j)
    if (is_free[static_cast<std::size_t>(j)] && trial(j) <= 0) step = std::min(step, x(j) / (x(j) - trial(j)));
  return step;
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const Eigen::Index count = a.cols();
  std::vector<bool> is_free(static_cast<std::size_t>(count), false);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(count);
  const double rounding = 1e-12 * (a.transpose() * b).cwiseAbs().maxCoeff();
  for (Eigen::Index round = 0; round < 3 * count; ++round) {
    const Eigen::VectorXd downhill = a.transpose() * (b - a * x);
    Eigen::Index entering = -1;
    for (Eigen::Index j = 0; j < count; ++j)
      if (!is_free[static_cast<std::size_t>(j)] && downhill(j) > rounding &&
          (entering < 0 || downhill(j) > downhill(entering)))
        entering = j;
    if (entering < 0) break;
    is_free[static_cast<std::size_t>(entering)] = true;
    Eigen::VectorXd trial = free_solution(a, b, is_free);
    if (trial(entering) <= 0) break;  // the gain is below rounding
    for (double step = admissible_step(x, trial, is_free); step < 1; step = admissible_step(x, trial, is_free)) {
      x += step * (trial - x);
      constexpr double null = 1e-15;
      for (Eigen::Index j = 0; j < count; ++j)
        if (is_free[static_cast<std::size_t>(j)] && trial(j) <= 0 && x(j) <= null * x.maxCoeff()) {
          is_free[static_cast<std::size_t>(j)] = false;
          x(j) = 0;
        }
      trial = free_solution(a, b, is_free);
    }
    x = trial;
  }
  return x;
}

}  // namespace trivet::identification
