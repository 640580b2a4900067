// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "trivet/identification/load_cases.h"
#include "trivet/spatial/types.h"

namespace trivet::identification {

/// The passive, stress-free matrix nearest to a given symmetric one. Distances are taken per entry, divided by √(C_ii
/// C_jj); a diagonal entry below a thousandth of the mean of its kind (translation, rotation) counts as that
/// thousandth.
struct SemidefiniteMatrix {
  spatial::Matrix12 stiffness;
  double distance = 0;           ///< Frobenius norm of the change / that of the matrix, scaled
  double lowest_eigenvalue = 0;  ///< of the scaled matrix before the change; the largest is of the order of 1
};

/// Nearest positive semidefinite matrix without strain energy in a rigid motion of ends `arm` [m] apart (from N to K).
/// @throws InvalidInput unless the matrix is finite and the means of its translational and rotational diagonals are > 0
[[nodiscard]] SemidefiniteMatrix nearest_semidefinite(const spatial::Matrix12& stiffness, const Eigen::Vector3d& arm);

/// Assumption on the element. Both are symmetric.
enum class Unknowns {
  self_balanced,   ///< 21 constants: the end wrenches balance and a rigid motion needs no force
  full_symmetric,  ///< 78 constants: the rigid-motion residual is a result; both ends must be moved
};

struct StiffnessFitOptions {
  Unknowns unknowns = Unknowns::self_balanced;
  double confidence = 0.95;   ///< of every interval, in (0, 1)
  bool zero_offsets = false;  ///< a constant reading per measured channel (tare, preload) is identified too
  /// Standard deviation of each channel of the wrench [N, N m], > 0: only their ratios are used, the level is
  /// estimated. If any measured channel is NaN, the noise of all channels is estimated from their own residuals.
  Vector12 standard_deviation = Vector12::Constant(std::numeric_limits<double>::quiet_NaN());
  double outlier_risk = 0.05;         ///< chance that a good data set has one reading reported as an outlier, in (0, 1)
  bool nearest_semidefinite = false;  ///< also give the nearest passive matrix
};

/// One measured channel of one load case, for a residual plot.
struct Reading {
  int load_case = 0;  ///< index
  int channel = 0;    ///< 0 … 11
  double measured = 0, fitted = 0;
  double residual = 0;  ///< measured − fitted
  double standardised =
      0;  ///< residual / its standard deviation, with leverage; 0 if the reading alone determines a constant
  double leverage = 0;  ///< 0 … 1
};

/// A reading that contradicts the others.
struct Outlier {
  int load_case = 0, channel = 0;
  double deviation = 0;    ///< measured − predicted by the other readings [N, N m]
  double studentised = 0;  ///< deviation / its standard deviation from the other readings
  double limit = 0;        ///< of |studentised| (Student, Bonferroni over all readings)
};

struct StiffnessFit {
  Matrix12 stiffness;   ///< symmetric, in the element's frame
  Matrix12 half_width;  ///< of the confidence interval of every entry
  Eigen::MatrixXd
      covariance;  ///< of the constants: lower triangle of the K-end block (21) or of the matrix (78), by rows
  Eigen::Matrix<double, 12, 6> rigid_residual;  ///< C G; round-off if self-balanced
  Eigen::Matrix<double, 12, 6> rigid_residual_half_width;
  double scaled_rigid_residual = 0;  ///< largest entry / √(K_ii K_jj)
  Vector12 offset;                   ///< identified zero reading per channel; 0 if not requested, NaN if not measured
  Vector12 noise;                    ///< estimated standard deviation of each channel; NaN if not measured
  double degrees_of_freedom = 0;
  double condition = 0;  ///< of the scaled design
  std::vector<Reading> readings;
  std::vector<Outlier> outliers;                   ///< reported, never removed
  double lowest_eigenvalue = 0;                    ///< of the matrix / √(K_ii K_jj)
  std::optional<SemidefiniteMatrix> semidefinite;  ///< if requested and the diagonal is positive in the mean
  foundation::Problems warnings;
};

/// The symmetric 12×12 stiffness of an element with ends `arm` [m] apart (from N to K), by weighted least squares, with
/// the uncertainty of every entry. Errors of the imposed displacements are not modelled: they count as noise of the
/// wrenches. Problems: unusable cases, and motions that no load case excites.
/// @throws InvalidInput if an option is out of its range
[[nodiscard]] foundation::Expected<StiffnessFit> identified_stiffness(const std::vector<LoadCase>& cases,
                                                                      const Eigen::Vector3d& arm,
                                                                      const StiffnessFitOptions& options = {});

}  // namespace trivet::identification
