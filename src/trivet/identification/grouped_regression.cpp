// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/grouped_regression.h"

#include <algorithm>
#include <cmath>

#include "trivet/identification/student_distribution.h"
#include "trivet/numerics/linalg/orthogonal.h"

namespace trivet::identification {
namespace {

/// Ratio of smallest to largest pivot that still counts as excited; designs are scaled, so rounding is near 1e-15.
constexpr double rank_tolerance = 1e-9;
/// Ratio of noise to readings below which a group counts as exact.
constexpr double least_noise = 1e-10;

Eigen::VectorXd group_sizes(const Regression& regression, const Eigen::VectorXd& values) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(regression.groups), count = squares;
  for (Eigen::Index r = 0; r < values.size(); ++r) {
    squares(regression.group[r]) += std::pow(values(r) / regression.relative_deviation(r), 2);
    count(regression.group[r]) += 1;
  }
  return (squares.array() / count.array().max(1)).sqrt();
}

/// Directions without influence on the readings: R₁₁ x₁ = −R₁₂ x₂ for every unit x₂, in the order of the parameters.
Eigen::MatrixXd null_space(const numerics::PivotedQr& qr, Eigen::Index rank) {
  const Eigen::Index count = qr.R.cols();
  Eigen::MatrixXd pivoted(count, count - rank);
  pivoted.topRows(rank) = -qr.R.topRightCorner(rank, count - rank);
  pivoted.topRows(rank) =
      qr.R.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(pivoted.topRows(rank).eval());
  pivoted.bottomRows(count - rank).setIdentity();
  return qr.P * pivoted;
}

Eigen::VectorXd deviations(const Regression& regression, const Eigen::VectorXd& group_scale) {
  Eigen::VectorXd deviation = regression.relative_deviation;
  for (Eigen::Index r = 0; r < deviation.size(); ++r) deviation(r) *= group_scale(regression.group[r]);
  return deviation;
}

/// One weighted solution; `judge_rank` sets the rank. False if the rank is less than full.
bool solve(const Regression& regression, bool judge_rank, RegressionFit& fit) {
  const Eigen::VectorXd weight = fit.deviation.cwiseInverse();
  const Eigen::MatrixXd weighted = weight.asDiagonal() * regression.design;
  const numerics::PivotedQr qr = numerics::pivoted_qr(weighted, rank_tolerance);
  const Eigen::Index count = regression.design.cols();
  if (judge_rank) fit.rank = static_cast<int>(qr.rank);
  if (fit.rank < count) {
    fit.null_space = null_space(qr, fit.rank);
    return false;
  }
  const Eigen::MatrixXd inverse = qr.R.triangularView<Eigen::Upper>().solve(qr.Q.transpose());
  fit.influence = qr.P * inverse * weight.asDiagonal();
  fit.parameters = fit.influence * regression.measured;
  fit.residual = regression.measured - regression.design * fit.parameters;
  fit.leverage = qr.Q.rowwise().squaredNorm();
  fit.condition = std::abs(qr.R(0, 0) / qr.R(count - 1, count - 1));
  return true;
}

}  // namespace

RegressionFit fit(const Regression& regression) {
  RegressionFit fit;
  Eigen::VectorXd readings = group_sizes(regression, regression.measured);
  const double stand_in =
      readings.maxCoeff() > 0 ? (readings.array() > 0).select(readings, readings.maxCoeff()).minCoeff() : 1;
  readings = (readings.array() > 0).select(readings, stand_in);  // for a channel whose readings are all 0
  const Eigen::VectorXd floor = least_noise * readings;
  fit.group_scale = readings;
  constexpr int most_rounds = 60;
  constexpr double settled = 1e-4;  // of the noise: far below its own uncertainty
  fit.deviation = deviations(regression, fit.group_scale);
  for (int round = 0; round < most_rounds; ++round) {
    if (!solve(regression, round == 0, fit)) return fit;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(regression.groups);
    fit.group_freedom = squares;
    for (Eigen::Index r = 0; r < fit.residual.size(); ++r) {
      const int g = regression.group[r];
      squares(g) += std::pow(fit.residual(r) / regression.relative_deviation(r), 2);
      fit.group_freedom(g) += 1 - fit.leverage(r);
    }
    const Eigen::VectorXd scale = (squares.array() / fit.group_freedom.array().max(1e-3)).sqrt().max(floor.array());
    const bool done = ((scale - fit.group_scale).array().abs() <= settled * scale.array()).all();
    fit.group_scale = scale;
    fit.deviation = deviations(regression, scale);
    if (done) break;
  }
  return fit;
}

double half_width(const Regression& regression, const RegressionFit& fit, const Eigen::RowVectorXd& functional,
                  double confidence) {
  const Eigen::RowVectorXd sensitivity = functional * fit.influence;
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(regression.groups);
  for (Eigen::Index r = 0; r < sensitivity.size(); ++r)
    variance(regression.group[r]) += std::pow(sensitivity(r) * fit.deviation(r), 2);
  const double total = variance.sum();
  if (total == 0) return 0;
  const double share = (variance / total).array().square().cwiseQuotient(fit.group_freedom.array().max(1e-3)).sum();
  return student_quantile(confidence, 1 / share) * std::sqrt(total);
}

Eigen::MatrixXd covariance(const RegressionFit& fit) {
  const Eigen::MatrixXd spread = fit.influence * fit.deviation.asDiagonal();
  return spread * spread.transpose();
}

}  // namespace trivet::identification
