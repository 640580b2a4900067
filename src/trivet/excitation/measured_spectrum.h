// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "trivet/excitation/spectrum.h"

namespace trivet::excitation {

/// Spectral density of a measured history by averaged segments.
struct MeasuredSpectrum {
  SpectrumTable table;       ///< straight lines between the lines of the transform, without the mean [unit²/Hz]
  double resolution_hz = 0;  ///< distance of the lines
  std::size_t segments = 0;  ///< each overlaps the next by half
  double line_error = 1;     ///< standard deviation of one line over its value, for a normal process
};

/// Averaged periodograms of Welch (IEEE Trans. Audio Electroacoust. 15 (1967) 70–73): segments that overlap by half,
/// each without its mean, weighted by a Hann window. One-sided. The mean square is the sum of the lines: the first and
/// last density also hold for half a line beyond. A sine of amplitude A, two lines or more above 0, adds A²/2.
/// @param values        samples at equal distances [unit]
/// @param step          of the samples > 0 [s]
/// @param resolution_hz largest distance of lines > 0 [Hz]; the length of a segment is the next one above with no prime
///                      factor beyond 5
/// @throws foundation::InvalidInput if no segment fits into the record, or a segment has fewer than 8 samples
[[nodiscard]] MeasuredSpectrum measured_spectrum(const std::vector<double>& values, double step, double resolution_hz);

}  // namespace trivet::excitation
