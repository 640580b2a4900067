// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/band_levels.h"

#include <array>
#include <cmath>
#include <variant>

#include "trivet/foundation/constants.h"

namespace trivet::results {
namespace {

/// The band of IEC 61260-1 with the ends of a piece, if there is one.
std::optional<excitation::FrequencyBand> band_of_piece(const excitation::SpectrumPiece& piece) {
  const auto is_close = [](double a, double b) { return std::abs(a - b) <= 1e-9 * b; };
  const double middle = std::sqrt(piece.from * piece.to) / foundation::two_pi;
  if (!(middle > 0) || piece.linear) return std::nullopt;
  for (const auto width : {excitation::BandWidth::third_octave, excitation::BandWidth::octave})
    if (const excitation::FrequencyBand band = excitation::nearest_band(width, middle);
        is_close(piece.from, band.from()) && is_close(piece.to, band.to()))
      return band;
  return std::nullopt;
}

/// The bands of the pieces, all of one width; empty if they are no such bands.
std::vector<excitation::FrequencyBand> bands_of(const excitation::Spectrum& spectrum) {
  std::vector<excitation::FrequencyBand> bands;
  for (const excitation::SpectrumPiece& piece : spectrum.pieces) {
    const std::optional<excitation::FrequencyBand> band = band_of_piece(piece);
    if (!band || (!bands.empty() && band->width != bands.front().width)) return {};
    bands.push_back(*band);
  }
  return bands;
}

/// How often levels of bands were differentiated: they were given in the quantity whose density is constant in each.
std::optional<int> derivatives_of_levels(const excitation::Spectrum& spectrum) {
  std::optional<int> times;
  for (const excitation::SpectrumPiece& piece : spectrum.pieces) {
    const double slope = piece.exponent() / 2;
    const int rounded = static_cast<int>(std::lround(slope));
    if (std::abs(slope - rounded) > 1e-6 || times.value_or(rounded) != rounded) return std::nullopt;
    times = rounded;
  }
  return times;
}

}  // namespace

std::string course_unit(const model::Action& action) {
  const bool turns = action.amplitude.head<3>().isZero(0);
  if (action.body) return turns ? "N m" : "N";
  static constexpr std::array ways = {"m", "m/s", "m/s²"}, angles = {"rad", "rad/s", "rad/s²"};
  const auto order = static_cast<std::size_t>(action.derivative);
  return turns ? angles[order] : ways[order];
}

std::optional<BandLevels> band_levels(const model::Excitation& excitation) {
  const auto* random = std::get_if<model::Random>(&excitation.course);
  if (!random) return std::nullopt;
  BandLevels levels;
  levels.bands = bands_of(random->spectrum);
  const std::optional<int> times = derivatives_of_levels(random->spectrum);
  if (levels.bands.empty() || !times) return std::nullopt;
  model::Action given = excitation.action;
  given.derivative -= *times;
  // A slope that no differentiation of levels gives: it is a density as it was given.
  if (given.body ? *times != 0 : given.derivative < 0 || given.derivative > 2) return std::nullopt;
  levels.width = levels.bands.front().width;
  levels.unit = course_unit(given);
  for (const excitation::SpectrumPiece& piece : excitation::differentiated(random->spectrum, -*times).pieces)
    levels.rms.push_back(excitation::rms({{piece}}));
  return levels;
}

}  // namespace trivet::results
