// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/excitation/shock_spectrum.h"

namespace trivet::study {

/// Shock response spectrum of one time excitation.
struct ShockSpectrumResult {
  std::string excitation;
  std::string unit;  ///< of the spectrum: m/s²
  double damping_ratio = 0;
  std::vector<excitation::ShockResponse> spectrum;
};

}  // namespace trivet::study
