// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/road.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {
namespace {

constexpr double reference_wave_number = 0.1;  // n₀ [1/m]
constexpr double class_a_mean = 16e-6;         // [m³]; each further class is four times rougher

}  // namespace

RoadRoughness road_class(char letter) {
  if (letter < 'A' || letter > 'H')
    throw foundation::InvalidInput(fmt::format("road class '{}': ISO 8608 has the classes A to H", letter));
  return {.roughness = class_a_mean * std::pow(4, letter - 'A')};
}

Spectrum road_spectrum(const RoadRoughness& road, double speed) {
  require_positive(road.roughness, "roughness of a road", "m³");
  require_finite(road.waviness, "waviness of a road", "");
  if (!(road.wave_number_from > 0 && road.wave_number_from < road.wave_number_to) ||
      !std::isfinite(road.wave_number_to))
    throw foundation::InvalidInput(fmt::format("road: wave numbers {:.6g} … {:.6g} 1/m, must be > 0 and ascend",
                                               road.wave_number_from, road.wave_number_to));
  require_positive(speed, "speed", "m/s");
  const double radians_per_wave_number = 2 * std::numbers::pi * speed;
  const auto density = [&](double n) {
    return road.roughness * std::pow(n / reference_wave_number, -road.waviness) / radians_per_wave_number;
  };
  return {{SpectrumPiece{radians_per_wave_number * road.wave_number_from, radians_per_wave_number * road.wave_number_to,
                         density(road.wave_number_from), density(road.wave_number_to)}}};
}

}  // namespace trivet::excitation
