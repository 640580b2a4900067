// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/frequency_bands.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"

namespace trivet::excitation {
namespace {

/// Third octaves in one band.
int thirds(BandWidth width) { return width == BandWidth::octave ? 3 : 1; }

/// Upper edge of the band [rad/s]; the lower one is that of the band before, to the last digit.
double upper_edge(BandWidth width, int index) {
  return foundation::two_pi * std::pow(10.0, thirds(width) * (2 * index + 1) / 20.0);
}

}  // namespace

const char* name(BandWidth width) { return width == BandWidth::octave ? "octave" : "third-octave"; }

double FrequencyBand::nominal_hz() const {
  static constexpr std::array<double, 10> of_decade = {1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8};
  const int third = thirds(width) * index;
  const int decade = static_cast<int>(std::floor(third / 10.0));
  const double first = of_decade[static_cast<std::size_t>(third - 10 * decade)];
  return decade < 0 ? first / std::pow(10.0, -decade) : first * std::pow(10.0, decade);
}

double FrequencyBand::midband_hz() const { return std::pow(10.0, thirds(width) * index / 10.0); }

double FrequencyBand::from() const { return upper_edge(width, index - 1); }

double FrequencyBand::to() const { return upper_edge(width, index); }

FrequencyBand nearest_band(BandWidth width, double hertz) {
  assert(hertz > 0 && std::isfinite(hertz));
  return {width, static_cast<int>(std::lround(10 * std::log10(hertz) / thirds(width)))};
}

std::optional<FrequencyBand> band_of(BandWidth width, double midband_hz) {
  constexpr double rounding = 0.005;  // of a name: 3.16 for 3.15, 79.4 for 80
  if (!(midband_hz > 0 && std::isfinite(midband_hz))) return std::nullopt;
  const FrequencyBand band = nearest_band(width, midband_hz);
  const bool named = std::abs(midband_hz / band.nominal_hz() - 1) < rounding;
  const bool exact = std::abs(midband_hz / band.midband_hz() - 1) < rounding;
  return named || exact ? std::optional(band) : std::nullopt;
}

FrequencyBand band_of_tone(BandWidth width, double angular_frequency) {
  constexpr double rounding = 1e-9;
  FrequencyBand band = nearest_band(width, angular_frequency / foundation::two_pi);
  if (angular_frequency >= band.to() * (1 - rounding)) ++band.index;
  else if (angular_frequency < band.from() * (1 - rounding)) --band.index;
  return band;
}

std::vector<FrequencyBand> bands_between(BandWidth width, double from, double to) {
  constexpr double rounding = 1e-9;
  std::vector<FrequencyBand> bands;
  if (!(to > from && to > 0)) return bands;
  FrequencyBand band = nearest_band(width, from > 0 ? from / foundation::two_pi : lowest_hz);
  while (from > 0 && band.from() > from * (1 + rounding)) --band.index;
  while (band.to() <= from * (1 + rounding)) ++band.index;
  for (; band.from() < to * (1 - rounding); ++band.index) bands.push_back(band);
  return bands;
}

Spectrum spectrum_of_levels(const std::vector<FrequencyBand>& bands, const std::vector<double>& levels) {
  assert(bands.size() == levels.size() && "one level per band");
  Spectrum spectrum;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const double density = levels[i] * levels[i] / (bands[i].to() - bands[i].from());
    if (density > 0)
      spectrum.pieces.push_back(
          {.from = bands[i].from(), .to = bands[i].to(), .density_from = density, .density_to = density});
  }
  return spectrum;
}

Spectrum in_range(const Spectrum& spectrum, double from, double to) {
  Spectrum part;
  for (const SpectrumPiece& whole : spectrum.pieces) {
    const auto density_at = [&whole](double omega) {
      if (omega == whole.from) return whole.density_from;
      if (omega == whole.to) return whole.density_to;
      return whole.linear
          ? std::lerp(whole.density_from, whole.density_to, (omega - whole.from) / (whole.to - whole.from))
          : whole.density_from * std::pow(omega / whole.from, whole.exponent());
    };
    SpectrumPiece piece = whole;
    piece.from = std::max(whole.from, from);
    piece.to = std::min(whole.to, to);
    if (!(piece.to > piece.from)) continue;
    piece.density_from = density_at(piece.from);
    piece.density_to = density_at(piece.to);
    part.pieces.push_back(piece);
  }
  return part;
}

}  // namespace trivet::excitation
