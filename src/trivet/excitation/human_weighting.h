// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

namespace trivet::excitation {

/// Frequency weighting of acceleration for its effect on people. [ISO 2631-1:1997 annex A; Wb: ISO 2631-4, Wm: ISO
/// 2631-2; all: ISO 8041-1 table 3, printed in the Larson Davis HVM200 reference manual, table 3.1]
enum class Weighting {
  Wb,  ///< vertical, in trains
  Wc,  ///< fore-and-aft at a backrest
  Wd,  ///< horizontal at a seat
  We,  ///< rotational
  Wf,  ///< motion sickness, vertical
  Wj,  ///< vertical at the head of a lying person
  Wk,  ///< vertical at a seat, all directions at the feet
  Wm   ///< all directions, in buildings
};

/// Corner frequencies [Hz] and quality factors of H = H_h H_l H_t H_s; infinity if a part is missing. Q₁ = Q₂ =
/// 1/√2.
struct WeightingParameters {
  double f1, f2;          ///< band limit: high pass and low pass of second order
  double f3, f4, q4;      ///< transition from acceleration to velocity
  double f5, q5, f6, q6;  ///< upward step
  double gain;
};
[[nodiscard]] WeightingParameters parameters(Weighting weighting);

/// H(s) as a ratio of two polynomials, coefficients of s⁰, s¹ …, s in rad/s: stable, and 0 at ω = 0 and ∞, so that
/// weighted mean squares can be integrated exactly.
struct RationalTransfer {
  std::vector<double> numerator;
  std::vector<double> denominator;
};
[[nodiscard]] RationalTransfer rational_transfer(Weighting weighting);

/// H(iω), ω ≥ 0 [rad/s]: the factor on an acceleration amplitude e^{+iωt}.
[[nodiscard]] std::complex<double> transfer(Weighting weighting, double angular_frequency);

/// Point at which vibration enters a person.
enum class ContactPoint { seat_surface, backrest, feet, standing };

/// Weighting and multiplying factor of one axis; k is in 1, for rotations in m/rad. k = 0: the axis is not assessed.
struct WeightedAxis {
  Weighting weighting = Weighting::Wk;
  double k = 0;
};

/// x, y, z, θx, θy, θz in the axes of the body (x forward, z up), for comfort. [ISO 2631-1:1997 section 8.2]
[[nodiscard]] std::array<WeightedAxis, 6> comfort_axes(ContactPoint contact);

/// x, y, z of the seat surface, for health: 1.4, 1.4, 1. [ISO 2631-1:1997 section 7.2]
[[nodiscard]] std::array<WeightedAxis, 3> health_axes();

/// Vibration total value √Σ (k a)² of weighted accelerations [m/s²] per axis, or of total values of several points.
[[nodiscard]] double vibration_total_value(std::span<const double> weighted_accelerations,
                                           std::span<const double> factors);

}  // namespace trivet::excitation
