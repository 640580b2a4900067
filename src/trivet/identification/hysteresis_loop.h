// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <limits>
#include <optional>
#include <string>

#include "trivet/foundation/problems.h"

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

/// Force against displacement of one harmonic test, as recorded by the rig: any number of cycles, noisy, drifting, not
/// centred.
struct LoopRecord {
  std::string name;
  Eigen::VectorXd time;          ///< [s], strictly increasing; empty: equally spaced samples
  Eigen::VectorXd displacement;  ///< [m], of the moved end
  Eigen::VectorXd force;         ///< [N], exerted by the rig along the displacement (or [rad], [N m])
  /// [rad/s] as stated by the rig; NaN: taken from the time. Needed for the viscous coefficient if there is no time.
  double angular_frequency = std::numeric_limits<double>::quiet_NaN();
};

struct LoopOptions {
  double confidence = 0.95;  ///< in (0, 1)
  int drift_order = 1;       ///< of the polynomial removed from displacement and force, 0 … 3
  int harmonics = 5;         ///< highest number fitted, 1 … 20; fewer if a cycle has less than four samples for each
};

/// A value and the half-width of its confidence interval.
struct Estimate {
  double value = 0;
  double half_width = 0;
};

/// Signals are Re Σ x̂_n e^{inφ}. X = |x̂₁| is the amplitude; W = ∮F dx = π Σ n Im(F̂_n x̂_n*) the loss energy per cycle.
struct LoopFit {
  std::string name;
  int cycles = 0;                               ///< whole cycles that were used
  std::optional<double> angular_frequency;      ///< [rad/s]
  Estimate amplitude;                           ///< X [m]
  Estimate loss_energy;                         ///< W [J]
  Estimate stiffness;                           ///< k = Re(F̂₁/x̂₁) [N/m]
  std::optional<Estimate> viscous_coefficient;  ///< W/(π ω X²) [N s/m], if ω is known
  Estimate loss_factor;                         ///< W/(π k X²)
  std::complex<double> dynamic_stiffness;       ///< F̂₁/x̂₁ [N/m]
  double dynamic_stiffness_deviation = 0;  ///< standard deviation of its real part, and of its imaginary part [N/m]
  Eigen::VectorXcd displacement_harmonics, force_harmonics;  ///< x̂_n, F̂_n, n = 1 …
  double displacement_distortion = 0, force_distortion = 0;  ///< rms of the higher harmonics / fundamental
  double displacement_drift = 0, force_drift = 0;  ///< change of the removed trend over the cycles used [m], [N]
  double displacement_noise = 0, force_noise = 0;  ///< standard deviation of the residuals [m], [N]
  /// Scatter of F̂₁/x̂₁ from cycle to cycle / that of white noise; widens the intervals if significant.
  double cycle_scatter = 1;
  foundation::Problems warnings;
};

/// Stiffness, loss energy, viscous coefficient and loss factor of a loop, after finding its frequency and removing
/// offset and drift. Problems: samples that are not finite, columns of different length, time that does not increase,
/// less than one cycle, fewer than eight samples per cycle, no motion.
/// @throws InvalidInput if an option is out of its range
[[nodiscard]] foundation::Expected<LoopFit> loop_fit(const LoopRecord& record, const LoopOptions& options = {});

}  // namespace trivet::identification
