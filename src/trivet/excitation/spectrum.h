// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
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

/// Roughness of a road track by ISO 8608: G_d(n) = G_d(n₀) (n/n₀)^{−w} over the wave number n in cycles per
/// metre, n₀ = 0.1 1/m.
struct RoadRoughness {
  double roughness = 0;  ///< G_d(n₀) [m³] > 0
  double waviness = 2;   ///< w
  double wave_number_from = 0.011,
         wave_number_to = 2.83;  ///< [1/m], 0 < from < to: range of the classes in ISO 8608
};

/// Geometric mean of a class, 'A' (very good) to 'H': 16e-6 m³ · 4^k. The class limits are a factor of 2 above and
/// below.
/// @throws foundation::InvalidInput for another letter
[[nodiscard]] RoadRoughness road_class(char letter);

/// Spectrum of the road height [m²/(rad/s)] under a wheel at a speed > 0 [m/s]: ω = 2πnv.
[[nodiscard]] Spectrum road_spectrum(const RoadRoughness& road, double speed);

/// Coherence of two points on a wave: γ² = at_zero · exp(−2 decay · distance/wavelength), wavelength = 2π speed/ω.
/// Constant without decay. [Davenport, Quarterly Journal of the Royal Meteorological Society 87 (1961) 194–211: γ =
/// exp(−decay distance/wavelength)]
struct Coherence {
  double at_zero = 1;   ///< γ² at ω = 0, between 0 and 1
  double decay = 0;     ///< ≥ 0
  double distance = 0;  ///< [m] ≥ 0
  double speed = 0;     ///< [m/s], > 0 if there is a decay
};

/// γ²(ω), between 0 and 1.
[[nodiscard]] double coherence(const Coherence& law, double angular_frequency);

/// Relation of input `second` to input `first` (indices from 0): coherence, and delay [s] of `second`.
struct InputPair {
  std::size_t first = 0, second = 0;
  Coherence coherence = {};
  double delay = 0;
};

/// Random inputs with their spectra. Pairs that are not listed are uncorrelated.
struct RandomInputs {
  std::vector<Spectrum> spectra;
  std::vector<InputPair> pairs;
};

/// Hermitian matrix of one-sided spectral densities S_jk = E[x̂_j* x̂_k], so that S_12 = γ √(S_1 S_2) e^{−iωτ} if input 2
/// is later by τ. A response y = Σ H_j x_j has S_yy = Σ_jk H_j* S_jk H_k. [unit²/(rad/s)]
[[nodiscard]] Eigen::MatrixXcd density_matrix(const RandomInputs& inputs, double angular_frequency);

/// Errors: pairs that do not exist, name one input twice or are given twice; numbers out of range; a matrix of
/// coherences with a negative eigenvalue, which no random process has, checked at all breakpoints and at points between
/// them.
[[nodiscard]] foundation::Problems check(const RandomInputs& inputs, const std::string& subject);

}  // namespace trivet::excitation
