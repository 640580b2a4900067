// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "trivet/response/random/random_response.h"

/// Shared by both methods for the variances of random vibration.
namespace trivet::response {

/// A mean square ∫ ω^(2 derivative) |W|² S_yy dω of some channels. The first moment is the variance of all channels,
/// the second that of their derivatives.
struct RandomMoment {
  std::vector<Eigen::Index> channels;
  int derivative = 0;
  std::optional<excitation::Weighting> weighting;
};

[[nodiscard]] std::vector<RandomMoment> random_moments(const std::vector<assembly::Channel>& channels,
                                                       const RandomOptions& options);
/// |W|², or 1 without weighting.
[[nodiscard]] double weight(const RandomMoment& moment, double angular_frequency);
/// ω^(2 derivative) |W|².
[[nodiscard]] inline double multiplier(const RandomMoment& moment, double angular_frequency) {
  return weight(moment, angular_frequency) * std::pow(angular_frequency, 2 * moment.derivative);
}
/// Power of ω to which the multiplier is proportional toward ω = 0.
[[nodiscard]] int order_at_rest(const RandomMoment& moment);

/// Cross spectral density S_jk(ω) [unit²/(rad/s)], see excitation::density_matrix; empty if the two inputs are
/// uncorrelated.
[[nodiscard]] Eigen::VectorXcd cross_density(const RandomLoading& loading, std::size_t j, std::size_t k,
                                             const Eigen::VectorXd& omega);
/// Largest delay of the loading for integration panels, with the delays of the pairs and the decay of coherence [s].
[[nodiscard]] double longest_delay(const RandomLoading& loading);
/// Power of ω with which a spectrum starts at ω = 0; empty if it starts above 0.
[[nodiscard]] std::optional<int> order_at_rest(const excitation::Spectrum& spectrum);

/// `poles` and the points where S or a weighting is not smooth: poles of the weightings and, with pairs, zeros of the
/// densities.
[[nodiscard]] Eigen::VectorXcd with_poles_of_input(const Eigen::VectorXcd& poles, const RandomLoading& loading,
                                                   const std::vector<RandomMoment>& moments);
/// Boundaries of panels over the band of all spectra, graded toward these points and ω = 0, with every breakpoint. Gaps
/// between spectra have the weight 0.
[[nodiscard]] std::vector<double> panel_ends(const Eigen::VectorXcd& poles, const RandomLoading& loading,
                                             const std::vector<RandomMoment>& moments);

/// True if a pole is so near the axis that its damping is below double precision.
[[nodiscard]] bool is_undamped(const std::complex<double>& pole, double fastest);
/// Indices of undamped poles at ω > 0 within the band of the spectra.
[[nodiscard]] std::vector<Eigen::Index> undamped_poles_in_band(const Eigen::VectorXcd& poles,
                                                               const RandomLoading& loading);

/// Below this share of the magnitudes of its terms, a result is only round-off.
inline constexpr double vanishing_channel = 1e-12;

struct RandomVariances {
  Eigen::MatrixXd mean_square;                   ///< channels × moments
  Eigen::MatrixXd share;                         ///< channels × inputs, of the first moment [unit²]
  std::vector<std::vector<std::string>> reason;  ///< channels × moments: why it is missing, else empty
  Eigen::VectorXd error;                         ///< per channel, relative, of the variance
  Eigen::VectorXd misfit;                        ///< the part of `error` that another method may avoid
  std::vector<bool> vanishes;
  int solutions = 0;
};

[[nodiscard]] RandomVariances no_variances(Eigen::Index channels, std::size_t moments, std::size_t inputs);

}  // namespace trivet::response
