// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"

namespace trivet::response {

/// Contribution of one coordinate to a result: (displacement + s velocity + s² acceleration) · coordinate.
struct ChannelTerm {
  Eigen::Index row = 0;
  std::array<std::complex<double>, 3> by_power;  ///< of s⁰, s¹, s²
};

/// The nonzero terms of a channel.
struct ChannelTerms {
  int derivative = 0;
  std::vector<ChannelTerm> free, ground;
};

[[nodiscard]] std::vector<ChannelTerms> channel_terms(const std::vector<assembly::Channel>& channels);

/// All results at some frequencies, from direct solutions.
struct ChannelSamples {
  Eigen::MatrixXcd value;    ///< channels × frequencies; NaN if Z is singular
  Eigen::MatrixXd possible;  ///< sums of the magnitudes of the terms: a value far below is round-off
};

/// Samples at ω > 0 [rad/s], also with frequency-dependent elements.
[[nodiscard]] ChannelSamples channel_samples(const assembly::Assembled& assembled,
                                             const std::vector<assembly::Channel>& channels,
                                             const assembly::Loading& loading,
                                             const std::vector<double>& angular_frequency);

/// All delays in a loading [s], ascending; only 0 without a load.
[[nodiscard]] std::vector<double> delays_of(const assembly::Loading& loading);

/// The terms of one delay, with the delay removed.
[[nodiscard]] assembly::Loading undelayed(const assembly::Loading& loading, double delay);

/// Curves from the responses to each delayed part of the load, stacked in `parts`: Σ_d e^{−iωd} parts_d.
[[nodiscard]] Eigen::VectorXcd summed(const Eigen::VectorXcd& parts, const std::vector<double>& delays,
                                      double angular_frequency);

}  // namespace trivet::response
