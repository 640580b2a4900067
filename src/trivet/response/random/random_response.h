// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/excitation/human_weighting.h"
#include "trivet/excitation/spectrum.h"
#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::response {

// Stationary random vibration: formulas, accuracy and limits in docs/random.md.

/// One stationary random input of zero mean: an action of amplitude 1, and the one-sided spectrum of its time history.
struct RandomInput {
  std::string name;
  assembly::Loading loading;      ///< may contain powers of s and delays (a wave under several ground points)
  excitation::Spectrum spectrum;  ///< [unit²/(rad/s)] with the `unit` of the action: N, m, m/s², …
};

/// Inputs that act together. Pairs that are not named are uncorrelated.
struct RandomLoading {
  std::vector<RandomInput> inputs;
  std::vector<excitation::InputPair> pairs;
};

/// Loading by all random excitations, or by those named.
/// @throws foundation::InvalidInput for a name that is not a random excitation
[[nodiscard]] RandomLoading random_loading(const model::System& system, const assembly::Assembled& assembled,
                                           const std::vector<std::string>& selected = {});

/// Errors: no input; an input that excites no free coordinate or has an empty spectrum; pairs that are impossible for
/// random processes.
[[nodiscard]] foundation::Problems check(const RandomLoading& loading, const std::string& subject);

/// A motion with human-vibration weighting of its acceleration; the channel may be a displacement, velocity or
/// acceleration.
struct WeightedChannel {
  std::size_t channel = 0;
  excitation::Weighting weighting = excitation::Weighting::Wk;
};

struct RandomOptions {
  std::vector<WeightedChannel> weighted;
  double accuracy =
      1e-8;  ///< relative error of each variance: limit for the pole–residue form, target of the quadrature
  int most_solutions = 200000;  ///< of the quadrature, over all inputs
};

/// The mean square of one result y over the band of the spectra, and what follows from it.
struct RandomChannel {
  std::string name;
  std::string unit;
  bool vanishes = false;                    ///< below round-off of its terms: all numbers are 0 or missing
  std::optional<double> rms;                ///< σ_y; empty if infinite or undefined, see `reason`
  std::optional<double> three_sigma;        ///< 3 σ_y
  std::optional<double> rms_of_derivative;  ///< σ_ẏ [unit/s]
  std::optional<double> zero_crossings;     ///< ν₀ = σ_ẏ/(2π σ_y), crossings of zero from below per second
  std::optional<double>
      weighted_rms;  ///< of the weighted acceleration [m/s² or rad/s²], if in `RandomOptions::weighted`
  std::vector<double> variance_share;  ///< per input, sums to 1; with coherent inputs single shares may be outside 0 …
                                       ///< 1; empty without rms
  bool infinite_rms = false, infinite_rms_of_derivative = false,
       infinite_weighted_rms = false;  ///< infinite, not undefined
  /// Relative error of the variance; NaN if no number is finite.
  double estimated_error = std::numeric_limits<double>::quiet_NaN();
  std::string reason;  ///< why a number is missing
};

/// Method of the variances.
enum class RandomMethod {
  poles,      ///< pole–residue form and its integrals, checked against direct solutions
  quadrature  ///< adaptive, over panels graded toward the poles
};
[[nodiscard]] const char* name(RandomMethod method);

struct RandomResponse {
  std::vector<RandomChannel> channels;  ///< one per channel
  RandomMethod method = RandomMethod::poles;
  std::string remark;       ///< why the quadrature was used, else empty
  int solutions = 0;        ///< direct solutions Z q = h, for the check or the quadrature
  double from = 0, to = 0;  ///< band of the spectra together [rad/s]
};

/// Variances ∫ Σ_jk H_j* S_jk H_k dω of every channel, of its derivative, and of its weighted acceleration, within the
/// band of the spectra, without a frequency grid: docs/random.md.
/// @throws foundation::InvalidInput for errors of `check`, or a weighted channel that does not exist or is not a motion
/// @throws foundation::NotComputable if the first panels of the quadrature need more than `most_solutions`
[[nodiscard]] RandomResponse random_response(const assembly::Assembled& assembled,
                                             const std::vector<assembly::Channel>& channels,
                                             const RandomLoading& loading, const RandomOptions& options = {},
                                             const foundation::Progress& progress = {});

/// One-sided power spectral densities of the channels, [unit²/(rad/s)]; times 2π for unit²/Hz.
struct RandomCurves {
  std::vector<double> angular_frequency;     ///< [rad/s]
  std::vector<std::vector<double>> density;  ///< per channel; NaN if the dynamic stiffness is singular
};

/// Spectral densities at the given ω, or, if there are none, on a grid over the band of the spectra that is dense
/// around the poles and includes every breakpoint. For plots only: the variances come from `random_response`.
[[nodiscard]] RandomCurves random_curves(const assembly::Assembled& assembled,
                                         const std::vector<assembly::Channel>& channels, const RandomLoading& loading,
                                         std::vector<double> angular_frequency = {},
                                         const foundation::Progress& progress = {});

}  // namespace trivet::response
