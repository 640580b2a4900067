// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {

namespace {

using foundation::two_pi;

double density_of(const SpectrumPiece& p, double omega) {
  const double factor = p.factor == 0 ? 1 : std::pow(omega, p.factor);
  if (p.linear)
    return factor * (p.density_from + (p.density_to - p.density_from) * ((omega - p.from) / (p.to - p.from)));
  return factor * p.density_from * std::pow(omega / p.from, p.exponent());
}

/// ∫ (ω/reference)^p dω from a to b. At p = −1 it changes continuously to the logarithm.
double power_integral(double p, double reference, double a, double b) {
  if (a == 0) return b * std::pow(b / reference, p) / (p + 1);
  const double span = std::log(b / a), x = (p + 1) * span;
  return a * std::pow(a / reference, p) * span * (x == 0 ? 1 : std::expm1(x) / x);
}

double mean_square_of(const SpectrumPiece& p, double a, double b) {
  if (!p.linear)
    return p.density_from * std::pow(p.from, p.factor) * power_integral(p.exponent() + p.factor, p.from, a, b);
  const double slope = (p.density_to - p.density_from) / (p.to - p.from), at_a = p.density_from + slope * (a - p.from);
  if (p.factor == 0) return (at_a + 0.5 * slope * (b - a)) * (b - a);
  const double scale = std::pow(b, p.factor);
  return scale *
      ((p.density_from - slope * p.from) * power_integral(p.factor, b, a, b) +
       slope * b * power_integral(p.factor + 1, b, a, b));
}

}  // namespace

double SpectrumPiece::exponent() const {
  return density_to == density_from ? 0 : std::log(density_to / density_from) / std::log(to / from);
}

double density(const Spectrum& spectrum, double omega) {
  const auto& pieces = spectrum.pieces;
  if (pieces.empty() || !(omega >= pieces.front().from && omega <= pieces.back().to)) return 0;
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), omega,
                                      [](double w, const SpectrumPiece& p) { return w < p.from; });
  const SpectrumPiece& piece = *(after - 1);
  return omega <= piece.to ? density_of(piece, omega) : 0;
}

std::vector<double> breakpoints(const Spectrum& spectrum) {
  std::vector<double> points;
  for (const SpectrumPiece& piece : spectrum.pieces) {
    if (points.empty() || points.back() != piece.from) points.push_back(piece.from);
    points.push_back(piece.to);
  }
  return points;
}

double mean_square(const Spectrum& spectrum, double from, double to) {
  if (!(from <= to))
    throw foundation::InvalidInput(
        fmt::format("mean square in {}: the band must not be reversed", foundation::hertz_range(from, to, 6)));
  double sum = 0;
  for (const SpectrumPiece& piece : spectrum.pieces) {
    const double a = std::max(from, piece.from), b = std::min(to, piece.to);
    if (a < b) sum += mean_square_of(piece, a, b);
  }
  return sum;
}

double mean_square(const Spectrum& spectrum) { return mean_square(spectrum, spectrum.from(), spectrum.to()); }

double rms(const Spectrum& spectrum) { return std::sqrt(mean_square(spectrum)); }

Spectrum differentiated(Spectrum spectrum, int times) {
  if (times < 0 && !spectrum.pieces.empty() && spectrum.from() == 0)
    throw foundation::InvalidInput(
        "a spectrum that begins at 0 Hz cannot be integrated: its displacement has no finite mean square");
  for (SpectrumPiece& p : spectrum.pieces) {
    if (p.linear) {
      p.factor += 2 * times;
    } else {
      p.density_from *= std::pow(p.from, 2 * times);
      p.density_to *= std::pow(p.to, 2 * times);
    }
  }
  return spectrum;
}

Spectrum of_scaled_signal(Spectrum spectrum, double factor) {
  require_positive(std::abs(factor), "size of the factor", "");
  for (SpectrumPiece& p : spectrum.pieces) p.density_from *= factor * factor, p.density_to *= factor * factor;
  return spectrum;
}

Spectrum flat_spectrum(double density, double from, double to) {
  require_positive(density, "spectral density", "unit² s/rad");
  if (!(from >= 0 && from < to) || !std::isfinite(to))
    throw foundation::InvalidInput(
        fmt::format("band {:.6g} … {:.6g} Hz: it must begin at 0 or above and end higher", from / two_pi, to / two_pi));
  return {{SpectrumPiece{from, to, density, density, true}}};
}

foundation::Problems check(const SpectrumTable& table, const std::string& subject) {
  foundation::Problems problems;
  const std::vector<double>&f = table.frequencies_hz, &s = table.densities_per_hz;
  if (f.size() != s.size())
    problems.error(subject, fmt::format("{} frequencies and {} densities", f.size(), s.size()),
                   "each frequency has one density", "complete the rows");
  if (f.size() < 2) problems.error(subject, fmt::format("{} rows", f.size()), "a spectrum has two or more", "add rows");
  const bool logarithmic = table.interpolation == SpectrumTable::Interpolation::logarithmic;
  for (std::size_t i = 0; i < std::min(f.size(), s.size()); ++i) {
    const std::string row = fmt::format("row {}", i + 1);
    if (!std::isfinite(f[i]) || !std::isfinite(s[i]))
      problems.error(subject, fmt::format("{}: {} Hz, {}", row, f[i], s[i]), "numbers must be finite",
                     "fill the gap or remove the row");
    if (s[i] < 0)
      problems.error(subject, fmt::format("{}: density {:.6g} at {:.6g} Hz", row, s[i], f[i]),
                     "a power spectral density is a mean square per hertz and cannot be negative",
                     "check whether the table holds decibels");
    if (f[i] < 0 || (logarithmic && f[i] == 0))
      problems.error(
          subject, fmt::format("{}: frequency {:.6g} Hz", row, f[i]),
          logarithmic ? "logarithmic interpolation needs frequencies > 0" : "a one-sided spectrum has frequencies ≥ 0",
          logarithmic ? "begin above zero, or choose linear interpolation"
                      : "fold the negative half onto the positive one");
    if (i > 0 && f[i] <= f[i - 1])
      problems.error(subject, fmt::format("{}: {:.6g} Hz after {:.6g} Hz", row, f[i], f[i - 1]),
                     "frequencies must increase",
                     f[i] == f[i - 1] ? "for a jump, give two frequencies, however close" : "sort the rows");
  }
  if (!problems.has_errors() && std::ranges::all_of(s, [](double x) { return x == 0; }))
    problems.error(subject, "every density is 0", "a spectrum has a density > 0 somewhere",
                   "check the unit of the table");
  if (problems.has_errors() || !logarithmic) return problems;
  for (std::size_t i = 1; i < s.size(); ++i)
    if ((s[i] == 0) != (s[i - 1] == 0))
      problems.warning(subject, fmt::format("density 0 at {:.6g} Hz", s[i] == 0 ? f[i] : f[i - 1]),
                       "0 has no logarithm: between it and its neighbour the density is interpolated linearly",
                       "give a small density if that is not intended");
  return problems;
}

Spectrum from_table(const SpectrumTable& table) {
  foundation::refuse_errors(check(table, "spectrum"));
  Spectrum spectrum;
  for (std::size_t i = 0; i + 1 < table.frequencies_hz.size(); ++i) {
    const double a = table.densities_per_hz[i] / two_pi, b = table.densities_per_hz[i + 1] / two_pi;
    if (a == 0 && b == 0) continue;
    const bool linear = table.interpolation == SpectrumTable::Interpolation::linear || a == 0 || b == 0;
    spectrum.pieces.push_back({two_pi * table.frequencies_hz[i], two_pi * table.frequencies_hz[i + 1], a, b, linear});
  }
  return spectrum;
}

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
