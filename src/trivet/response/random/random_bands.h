// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/response/random/random_response.h"

namespace trivet::response {

/// Root mean squares of random vibration in frequency bands.
struct RandomBands {
  std::vector<excitation::FrequencyBand> bands;
  /// Per channel and band [unit]: √∫S dω between the edges of the band; ∞ at an undamped resonance, NaN if it has no
  /// value.
  std::vector<std::vector<double>> rms;
};

/// The integrals are those of `random_response` with the spectra inside the band alone: exact over the poles or by
/// quadrature with the same accuracy, without a frequency grid. Bands without density have level 0.
/// @throws as `random_response`
[[nodiscard]] RandomBands random_bands(const assembly::Assembled& assembled,
                                       const std::vector<assembly::Channel>& channels, const RandomLoading& loading,
                                       const std::vector<excitation::FrequencyBand>& bands,
                                       const RandomOptions& options = {}, const foundation::Progress& progress = {});

}  // namespace trivet::response
