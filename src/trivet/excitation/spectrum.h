// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::excitation {

/// One piece of a power spectral density between two frequencies: ω^`factor` times a power law through its two ends, or
/// times a straight line.
struct SpectrumPiece {
  double from = 0, to = 0;  ///< [rad/s], 0 ≤ from < to; a power law has from > 0
  double density_from = 0;  ///< at `from`, without the factor
  double density_to = 0;    ///< at `to`, without the factor
  bool linear = false;      ///< if false, a power law with both densities > 0
  int factor = 0;           ///< even power of ω from differentiation

  /// Exponent p of density_from (ω/from)^p. Power laws only.
  [[nodiscard]] double exponent() const;
};

/// One-sided power spectral density over angular frequency, [unit²/(rad/s)]: mean square = ∫₀^∞ S dω. Zero outside its
/// pieces. A density per hertz is S(f) = 2π S(ω).
struct Spectrum {
  std::vector<SpectrumPiece> pieces;  ///< ascending, without overlap

  [[nodiscard]] double from() const { return pieces.empty() ? 0 : pieces.front().from; }
  [[nodiscard]] double to() const { return pieces.empty() ? 0 : pieces.back().to; }
};

/// Density S(ω) [unit²/(rad/s)]; at a joint of two pieces that of the upper one, at the upper end that of the last.
[[nodiscard]] double density(const Spectrum& spectrum, double angular_frequency);

/// All ends of pieces [rad/s], ascending, each once. Between them S is smooth.
[[nodiscard]] std::vector<double> breakpoints(const Spectrum& spectrum);

/// Mean square ∫S dω from one frequency to another [unit²], in closed form.
[[nodiscard]] double mean_square(const Spectrum& spectrum, double from, double to);
[[nodiscard]] double mean_square(const Spectrum& spectrum);
[[nodiscard]] double rms(const Spectrum& spectrum);

/// The spectrum of the n-th derivative: S ω^{2n}; n < 0 integrates.
/// @throws foundation::InvalidInput for n < 0 if the spectrum begins at ω = 0: the mean square would be infinite
[[nodiscard]] Spectrum differentiated(Spectrum spectrum, int times);

/// Spectrum factor² · S of a signal times `factor`.
[[nodiscard]] Spectrum of_scaled_signal(Spectrum spectrum, double factor);

/// Constant density in a band, 0 ≤ from < to [rad/s]; density > 0 [unit²/(rad/s)].
[[nodiscard]] Spectrum flat_spectrum(double density, double from, double to);

/// A table of a spectral density over frequency in Hz, [unit²/Hz].
struct SpectrumTable {
  enum class Interpolation {
    logarithmic,  ///< straight lines over log f and log S; over f and S in a piece with a zero at one end
    linear        ///< straight lines over f and S
  };
  std::vector<double> frequencies_hz;
  std::vector<double> densities_per_hz;
  Interpolation interpolation = Interpolation::logarithmic;
};

/// Errors: unequal counts, fewer than two rows, numbers not finite, negative density, negative frequency or zero with
/// logarithmic interpolation, frequencies that do not increase, only zeros. Warning: a piece with a zero at one end,
/// which is therefore linear.
[[nodiscard]] foundation::Problems check(const SpectrumTable& table, const std::string& subject);

/// @throws foundation::InvalidInput with the first error of `check`
[[nodiscard]] Spectrum from_table(const SpectrumTable& table);

}  // namespace trivet::excitation
