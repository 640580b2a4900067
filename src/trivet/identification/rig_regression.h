// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "trivet/identification/stiffness_fit.h"

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

/// The matrix as a sum of constants: C = Σ constant_p · matrices[p]. Constants are scaled to similar size.
struct Basis {
  std::vector<Matrix12> matrices;
  std::vector<std::array<int, 2>> entry;  ///< row and column of each constant in the 12×12
  Eigen::VectorXd unit;                   ///< value of a constant that is 1 in the regression
};

/// Regression with the meaning of its rows.
struct Rig {
  Basis basis;
  Regression regression;
  std::vector<std::array<int, 2>> reading;  ///< load case and channel of each row
  std::vector<int> offset_channel;          ///< channel of each offset column
};

/// Typical translation and rotation of the load cases (1 if there is none).
[[nodiscard]] std::array<double, 2> typical_motion(const std::vector<LoadCase>& cases);

/// The load cases as a regression for the constants, and, if requested, for zero offsets.
[[nodiscard]] Rig rig_regression(const std::vector<LoadCase>& cases, const Eigen::Vector3d& arm,
                                 const StiffnessFitOptions& options);

struct Contradiction {
  Eigen::Index reading = 0;
  double deviation = 0;  ///< measured − predicted by the remaining readings
  double studentised = 0;
  double limit = 0;
};

/// Readings that contradict the others, worst first: the reading with the largest externally studentised residual is
/// removed while it exceeds Student's limit at risk/(readings), and the rest is fitted again. Stops at a tenth of the
/// readings.
[[nodiscard]] std::vector<Contradiction> contradictions(Regression regression, double risk);

}  // namespace trivet::identification
