// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/model/system.h"

namespace trivet::results {

/// Measured levels of the bands of a random excitation, as they were given: in the quantity whose density is constant
/// in every band.
struct BandLevels {
  excitation::BandWidth width = excitation::BandWidth::third_octave;
  std::string unit;                              ///< SI, of the levels: "m/s"
  std::vector<excitation::FrequencyBand> bands;  ///< ascending; those without motion are left out
  std::vector<double> rms;                       ///< of each band [unit]
};

/// None if the excitation is not random, or if its spectrum was given in another way.
[[nodiscard]] std::optional<BandLevels> band_levels(const model::Excitation& excitation);

/// SI unit of the course of an excitation: of its force or moment, or of the motion that it prescribes.
[[nodiscard]] std::string course_unit(const model::Action& action);

}  // namespace trivet::results
