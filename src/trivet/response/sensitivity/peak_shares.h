// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "trivet/response/sensitivity/peak_sensitivity.h"

namespace trivet::response {

/// Contribution of one undamped mode to a result: q = Σ φ_k a_k, y_k = cᵀφ_k a_k.
struct ModeShare {
  int mode = 0;               ///< number, from 1
  std::complex<double> part;  ///< y_k, in the unit of the channel
  double share = 0;           ///< Re(y_k ȳ)/|y|²: along y, negative if it opposes y
};

/// Stored energy and dissipation of one element, and its energy in the local directions of its deformation
/// (element_directions).
struct ElementShare {
  double stored = 0;  ///< of the system's strain energy; the sum with the others, `geometric` and `in_foundations` is 1
  spatial::Vector6 by_direction = spatial::Vector6::Zero();  ///< of the system's strain energy: d_j(K d)_j; the rest of
                                                             ///< `stored` is preload, relaxation, or internal
  double dissipated = 0;                                     ///< of the system's dissipated power
};

/// Modal contributions to a steady vibration, and the distribution of its energy.
struct PeakShares {
  std::complex<double> value;    ///< y; 0 if it is unbounded
  std::vector<ModeShare> modes;  ///< in their order; empty if y is unbounded or 0
  double beyond_modes = 0;       ///< rest of y: coordinates without mass, missing modes, frequency dependence, a moving
                                 ///< ground; its sum with the modes is 1
  double strain_energy = 0;      ///< mean over a period [J]; if y is unbounded, that of the mode with φᵀAφ = 1
  std::vector<ElementShare> elements;  ///< in the order of the system; shares are 0 if the total is 0
  double geometric = 0;                ///< share of the strain energy: preload and weight with rotating bodies
  double in_foundations = 0;           ///< share of the strain energy: flexible foundations
  double dissipated_power = 0;         ///< mean over a period [W]
  double system_damping = 0;           ///< share of it: Rayleigh or modal damping
  double by_foundations = 0;           ///< share of it: foundations
};

/// The same shares of what is stored and what is dissipated: of the positive energies and powers alone, so that none
/// exceeds 1. Negative ones, of preload under compression, weight, negative stiffness or damping, are given back.
[[nodiscard]] PeakShares of_positive_parts(PeakShares shares);

/// Strain energies that are given back, over those that are stored.
[[nodiscard]] double given_back(const PeakShares& shares);

/// Shares at any ω > 0; for an unbounded peak, those of its mode.
/// @throws NotComputable on an undamped resonance that `place` does not mark as unbounded
[[nodiscard]] PeakShares peak_shares(const model::System& system, const assembly::Assembled& assembled,
                                     const SensitivityRequest& request, const PeakPlace& place);

/// |y| divided by the largest |y| that a motion of this size can cause in this channel, both weighted with the masses
/// of the coordinates: 0 … 1. Far below 1e-9, the result vanishes by symmetry, and the computed value is round-off.
[[nodiscard]] double alignment(const model::System& system, const assembly::Assembled& assembled,
                               const SensitivityRequest& request, const PeakPlace& place);

}  // namespace trivet::response
