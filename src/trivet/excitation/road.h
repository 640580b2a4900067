// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/excitation/spectrum.h"

namespace trivet::excitation {

/// Roughness of a road track by ISO 8608: G_d(n) = G_d(n₀) (n/n₀)^{−w} over the wave number n in cycles per
/// metre, n₀ = 0.1 1/m.
struct RoadRoughness {
  double roughness = 0;  ///< G_d(n₀) [m³] > 0
  double waviness = 2;   ///< w
  double wave_number_from = 0.011,
         wave_number_to = 2.83;  ///< [1/m], 0 < from < to: range of the classes in ISO 8608
};

/// Geometric mean of a class, 'A' (very good) to 'H': 16e-6 m³ · 4^k. The class limits are a factor of 2 above and
/// below.
/// @throws foundation::InvalidInput for another letter
[[nodiscard]] RoadRoughness road_class(char letter);

/// Spectrum of the road height [m²/(rad/s)] under a wheel at a speed > 0 [m/s]: ω = 2πnv.
[[nodiscard]] Spectrum road_spectrum(const RoadRoughness& road, double speed);

}  // namespace trivet::excitation
