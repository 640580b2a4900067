// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "trivet/response/random/random_response.h"

/// What both ways to the variances of random vibration share.
namespace trivet::response {

/// A mean square ∫ ω^(2 derivative) |W|² S_yy dω wanted of some channels. The first moment is the variance of all
/// channels, the second that of their derivatives.
struct RandomMoment {
  std::vector<Eigen::Index> channels;
  int derivative = 0;
  std::optional<excitation::Weighting> weighting;
};

[[nodiscard]] std::vector<RandomMoment> random_moments(const std::vector<assembly::Channel>& channels,
                                                       const RandomOptions& options);
/// |W|², or 1.
[[nodiscard]] double weight(const RandomMoment& moment, double angular_frequency);
/// ω^(2 derivative) |W|².
[[nodiscard]] inline double multiplier(const RandomMoment& moment, double angular_frequency) {
  return weight(moment, angular_frequency) * std::pow(angular_frequency, 2 * moment.derivative);
}
/// The multiplier goes like ω to this power toward 0.
[[nodiscard]] int order_at_rest(const RandomMoment& moment);

/// S_jk(ω) [unit²/(rad/s)], see excitation::density_matrix; no entries if the two inputs have nothing in common.
[[nodiscard]] Eigen::VectorXcd cross_density(const RandomLoading& loading, std::size_t j, std::size_t k,
                                             const Eigen::VectorXd& omega);
/// Its largest delay, as panels of integration see it: with that of the pairs and the decay of coherence [s].
[[nodiscard]] double longest_delay(const RandomLoading& loading);
/// Power of ω with which a spectrum starts at 0; none if it starts later.
[[nodiscard]] std::optional<int> order_at_rest(const excitation::Spectrum& spectrum);

/// Where S or a weighting is not smooth besides the poles of the response: the poles of the weightings, and 0 for power
/// laws.
[[nodiscard]] Eigen::VectorXcd with_poles_of_input(const Eigen::VectorXcd& poles, const RandomLoading& loading,
                                                   const std::vector<RandomMoment>& moments);
/// Ends of graded panels over the band of all spectra; every breakpoint is one. Gaps where no spectrum holds are left
/// out by their weight 0.
[[nodiscard]] std::vector<double> panel_ends(const Eigen::VectorXcd& poles, const RandomLoading& loading,
                                             const std::vector<RandomMoment>& moments);

/// A pole so near the axis that a double cannot tell its damping.
[[nodiscard]] bool is_undamped(const std::complex<double>& pole, double fastest);
/// Undamped poles at ω > 0 within the band of the spectra.
[[nodiscard]] std::vector<Eigen::Index> undamped_poles_in_band(const Eigen::VectorXcd& poles,
                                                               const RandomLoading& loading);

/// Below this share of what its terms could make, an answer is nothing but round-off.
inline constexpr double vanishing_answer = 1e-12;

struct RandomVariances {
  Eigen::MatrixXd mean_square;                   ///< channels × moments
  Eigen::MatrixXd share;                         ///< channels × inputs, of the first moment [unit²]
  std::vector<std::vector<std::string>> reason;  ///< channels × moments: why there is none; empty where there is
  Eigen::VectorXd error;                         ///< per channel, relative, of the variance
  Eigen::VectorXd misfit;                        ///< the part of it that another way could mend
  std::vector<bool> vanishes;
  int solutions = 0;
};

[[nodiscard]] RandomVariances no_variances(Eigen::Index channels, std::size_t moments, std::size_t inputs);

}  // namespace trivet::response
