// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "trivet/excitation/signal.h"
#include "trivet/foundation/interruption.h"

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

}  // namespace trivet::excitation
