// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/excitation/shock_spectrum.h"
#include "trivet/foundation/problems.h"
#include "trivet/spatial/types.h"

namespace trivet::response {

/// One mode under an acceleration of the whole ground.
struct ModalShare {
  double angular_frequency = 0;  ///< [rad/s] > 0
  double damping_ratio =
      0;  ///< φᵀBφ/(2ω) (for a loss factor φᵀK_lossφ/(2ω²)); coupling of modes by damping is neglected
  double participation = 0;  ///< Γ = φᵀ(A r + A_fg e), φᵀAφ = 1, with r the static response to the unit ground motion e
                             ///< [√kg for a translation]
  double effective_mass = 0;         ///< Γ² [kg]
  double spectral_acceleration = 0;  ///< S_a(ω) [m/s²]; NaN outside the spectrum: the mode is excluded
};

/// Largest value of one result over time, estimated from its modal maxima.
struct CombinedChannel {
  std::string name;
  std::string unit;
  Eigen::VectorXd modal_maxima;              ///< per mode within the spectrum, with the sign for +S_a
  double square_root_of_sum_of_squares = 0;  ///< SRSS: for well separated natural frequencies
  double complete_quadratic = 0;             ///< CQC: also for close ones
};

struct EarthquakeResponse {
  std::vector<ModalShare> modes;    ///< all with ω > 0, ascending
  double effective_mass_share = 0;  ///< of the modes within the spectrum, over all modes with ω > 0
  std::vector<CombinedChannel> channels;
  foundation::Problems warnings;
};

/// Largest responses to an acceleration of the whole ground along `direction` (translation and rotation about the
/// ground origin, ground axes, of length 1 if the spectrum is that of this motion). The motion relative to the ground
/// is Γ S_a/ω² φ in each mode: displacements are relative to the ground, velocities are ω times them, accelerations ω²
/// times them and so absolute; forces are those of stiffness and mass.
/// @throws foundation::NotComputable for unsymmetric matrices or indefinite masses, modes that do not oscillate, and
/// results that are motions of the ground alone
[[nodiscard]] EarthquakeResponse earthquake_response(const assembly::Assembled& assembled,
                                                     const std::vector<assembly::Channel>& channels,
                                                     const excitation::ResponseSpectrum& spectrum,
                                                     const spatial::Vector6& direction);

}  // namespace trivet::response
