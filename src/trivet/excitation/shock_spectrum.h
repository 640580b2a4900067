// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <string>
#include <vector>

#include "trivet/excitation/signal.h"
#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// Response of one oscillator, initially at rest, to a base shock: largest and smallest absolute acceleration of its
/// mass [unit of the signal], while the signal runs (primary) and from the start of its last piece on (residual), and
/// its largest relative displacement.
struct ShockResponse {
  double angular_frequency = 0;                        ///< natural frequency [rad/s]
  double primary_largest = 0, primary_smallest = 0;    ///< ≥ 0, ≤ 0
  double residual_largest = 0, residual_smallest = 0;  ///< ≥ 0, ≤ 0
  double relative_displacement = 0;                    ///< |z| of the mass relative to the base [unit s²]

  [[nodiscard]] double largest() const { return std::max(primary_largest, residual_largest); }
  [[nodiscard]] double smallest() const { return std::min(primary_smallest, residual_smallest); }
  [[nodiscard]] double primary() const { return std::max(primary_largest, -primary_smallest); }
  [[nodiscard]] double residual() const { return std::max(residual_largest, -residual_smallest); }
  [[nodiscard]] double maximax() const { return std::max(primary(), residual()); }
  [[nodiscard]] double pseudo_velocity() const { return angular_frequency * relative_displacement; }  ///< [unit s]
};

/// Shock response spectrum of a base acceleration u that ends with a constant value (usually 0): z̈ + 2ζωż + ω²z = −u,
/// acceleration of the mass −2ζωż − ω²z. The motion is a Taylor series, exact to round-off, on steps of at most one
/// radian, and every extremum within a step is found from the roots of its derivative; the extrema are accurate to
/// about 1e-12 of the largest. [Terms: ISO 18431-4]
/// @param angular_frequencies  [rad/s] > 0
/// @param damping_ratio        0 ≤ ζ < 1; a quality factor Q is 1/(2ζ)
/// @throws foundation::InvalidInput for numbers out of range, and for a last piece that is not constant: its response
/// has no largest value
[[nodiscard]] std::vector<ShockResponse> shock_spectrum(const Signal& base_acceleration,
                                                        const std::vector<double>& angular_frequencies,
                                                        double damping_ratio,
                                                        const foundation::Progress& progress = {});

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
