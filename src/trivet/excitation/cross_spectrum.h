// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "trivet/excitation/spectrum.h"

namespace trivet::excitation {

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
