// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// An earthquake response spectrum: largest absolute (pseudo) acceleration S_a [m/s²] of an oscillator over its natural
/// frequency, for one damping ratio; straight lines over log ω and log S_a, undefined outside.
struct ResponseSpectrum {
  std::vector<double> angular_frequencies;  ///< [rad/s] > 0, increasing
  std::vector<double> accelerations;        ///< [m/s²] > 0
  double damping_ratio = 0.05;
};

/// The same from a table over natural period [s], increasing and > 0. A period 0 (the ground acceleration) does not
/// exist on a logarithmic axis: give a short period instead.
[[nodiscard]] ResponseSpectrum over_period(const std::vector<double>& periods, const std::vector<double>& accelerations,
                                           double damping_ratio);

/// Errors: unequal counts, fewer than two rows, numbers not finite or not > 0, frequencies that do not increase,
/// damping ratio outside [0, 1).
[[nodiscard]] foundation::Problems check(const ResponseSpectrum& spectrum, const std::string& subject);

/// Spectral acceleration S_a(ω) [m/s²]. @throws foundation::InvalidInput outside the table
[[nodiscard]] double spectral_acceleration(const ResponseSpectrum& spectrum, double angular_frequency);

/// √Σ rᵢ² of modal maxima, for well separated frequencies.
[[nodiscard]] double square_root_of_sum_of_squares(const Eigen::VectorXd& modal_maxima);

/// Correlation of two modal responses to white noise, ρ = 8√(ζᵢζⱼ) (βζᵢ + ζⱼ) β^{3/2} / ((1 − β²)² + 4ζᵢζⱼβ(1 + β²) +
/// 4(ζᵢ² + ζⱼ²)β²), β = ωᵢ/ωⱼ. Frequencies > 0, 0 ≤ ζ < 1. [Der Kiureghian, Earthquake Engineering and Structural
/// Dynamics 9 (1981) 419–435]
[[nodiscard]] double modal_correlation(double omega_i, double omega_j, double zeta_i, double zeta_j);

/// Complete quadratic combination √(Σᵢⱼ rᵢ ρᵢⱼ rⱼ); the modal maxima keep their signs.
[[nodiscard]] double complete_quadratic_combination(const Eigen::VectorXd& modal_maxima,
                                                    const Eigen::VectorXd& angular_frequencies,
                                                    const Eigen::VectorXd& damping_ratios);

}  // namespace trivet::excitation
