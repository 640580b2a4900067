// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::identification {

/// Linear regression measured ≈ design · parameters; the readings are in groups of unknown noise.
struct Regression {
  Eigen::MatrixXd design;  ///< one row per reading; columns of comparable size
  Eigen::VectorXd measured;
  Eigen::VectorXd relative_deviation;  ///< standard deviation of each reading within its group, > 0
  std::vector<int> group;              ///< of each reading, 0 …
  int groups = 0;
};

struct RegressionFit {
  int rank = 0;
  Eigen::MatrixXd null_space;  ///< of the weighted design, one column per missing rank; if it has any, the results
                               ///< below are not set
  double condition = 0;        ///< of the weighted design, largest / smallest pivot
  Eigen::VectorXd parameters;
  Eigen::MatrixXd influence;      ///< ∂ parameters / ∂ measured
  Eigen::VectorXd residual;       ///< measured − fitted
  Eigen::VectorXd leverage;       ///< ∂ fitted / ∂ measured of each reading, 0 … 1
  Eigen::VectorXd deviation;      ///< estimated standard deviation of each reading
  Eigen::VectorXd group_freedom;  ///< degrees of freedom of each group
  Eigen::VectorXd group_scale;    ///< factor on the relative deviations of each group
};

/// Weighted least squares. The noise of each group and the weights that depend on it are determined together by
/// iteration: the noise of a group is √(Σ r²/ν) with ν = readings − their leverages. Zero noise is replaced by 1e-10 of
/// the group's readings.
[[nodiscard]] RegressionFit fit(const Regression& regression);

/// Half-width of the confidence interval of Σ functional_p · parameter_p, by Student's distribution with
/// Satterthwaite's degrees of freedom.
[[nodiscard]] double half_width(const Regression& regression, const RegressionFit& fit,
                                const Eigen::RowVectorXd& functional, double confidence);

/// Covariance of the parameters.
[[nodiscard]] Eigen::MatrixXd covariance(const RegressionFit& fit);

}  // namespace trivet::identification
