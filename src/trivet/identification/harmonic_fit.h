// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

namespace trivet::identification {

/// Columns 1, s … s^order with s = −1 … 1 over the record, then cos nφ, sin nφ, φ = ω(t − t_first), n = 1 … harmonics.
[[nodiscard]] Eigen::MatrixXd harmonic_columns(const Eigen::VectorXd& time, double angular_frequency, int order,
                                               int harmonics);

/// Least-squares fit with the data for its uncertainty.
struct HarmonicFit {
  Eigen::MatrixXd unit_covariance;  ///< (AᵀA)⁻¹
  Eigen::MatrixXd coefficients;     ///< one column per signal
  Eigen::MatrixXd residuals;
  Eigen::VectorXd noise;  ///< standard deviation of the residuals of each signal
};
[[nodiscard]] HarmonicFit harmonic_fit(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& signals);

/// Angular frequency [rad/s] of the strongest oscillation of a signal that also has harmonics and a drift of the given
/// order: counted from its zero crossings (with fewer than three, from trials of 0.6 to 3.4 cycles per record), then
/// refined by least squares. Empty for a signal without motion.
[[nodiscard]] std::optional<double> frequency_of(const Eigen::VectorXd& time, const Eigen::VectorXd& signal, int order,
                                                 int harmonics);

}  // namespace trivet::identification
