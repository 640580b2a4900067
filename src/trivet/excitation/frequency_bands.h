// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/excitation/spectrum.h"

/// Octave and third-octave bands of IEC 61260-1:2014 with the octave ratio G = 10^(3/10).
namespace trivet::excitation {

enum class BandWidth { octave, third_octave };

/// "octave", "third-octave".
[[nodiscard]] const char* name(BandWidth width);

/// The band `index`: midband frequency 10^(index/10) Hz of a third octave, 10^(3 index/10) Hz of an octave.
struct FrequencyBand {
  BandWidth width = BandWidth::third_octave;
  int index = 0;

  /// Nominal midband frequency [Hz]: 1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8, 10 …
  [[nodiscard]] double nominal_hz() const;
  [[nodiscard]] double midband_hz() const;  ///< exact [Hz]
  [[nodiscard]] double from() const;        ///< lower edge [rad/s], the upper one of the band below
  [[nodiscard]] double to() const;          ///< upper edge [rad/s]
  bool operator==(const FrequencyBand&) const = default;
};

/// The band with this nominal or exact midband frequency [Hz], within 0.5 %; none if there is no such band.
[[nodiscard]] std::optional<FrequencyBand> band_of(BandWidth width, double midband_hz);

/// The band whose midband frequency is nearest to this one [Hz] > 0.
[[nodiscard]] FrequencyBand nearest_band(BandWidth width, double hertz);

/// The band in which a tone [rad/s] > 0 is. One on an edge, to round-off, is in the band above.
[[nodiscard]] FrequencyBand band_of_tone(BandWidth width, double angular_frequency);

/// All bands that share more than round-off with the range from … to [rad/s], ascending. A range from 0 begins with the
/// band of `lowest_hz`, as there are infinitely many bands below.
[[nodiscard]] std::vector<FrequencyBand> bands_between(BandWidth width, double from, double to);
inline constexpr double lowest_hz = 0.1;

/// Density that is constant in each band and has the given rms there [unit]; bands of level 0 have no density.
/// @param bands  ascending; as many levels
[[nodiscard]] Spectrum spectrum_of_levels(const std::vector<FrequencyBand>& bands, const std::vector<double>& levels);

/// The part of a spectrum between two frequencies [rad/s].
[[nodiscard]] Spectrum in_range(const Spectrum& spectrum, double from, double to);

}  // namespace trivet::excitation
