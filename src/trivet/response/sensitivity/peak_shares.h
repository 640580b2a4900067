// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "trivet/response/sensitivity/peak_sensitivity.h"

namespace trivet::response {

/// What one undamped mode contributes to an answer: q = Σ φ_k a_k, y_k = cᵀφ_k a_k.
struct ModeShare {
  int mode = 0;               ///< number, from 1
  std::complex<double> part;  ///< y_k, in the unit of the channel
  double share = 0;           ///< Re(y_k ȳ)/|y|²: along y, negative where it works against it
};

/// What one element holds and takes, in the local directions of its deformation where its stiffness at rest says it
/// (element_directions).
struct ElementShare {
  double stored = 0;  ///< of the system's strain energy; with the others, `geometric` and `in_foundations` it sums to 1
  spatial::Vector6 by_direction = spatial::Vector6::Zero();  ///< of the system's strain energy: d_j(K d)_j; what they
                                                             ///< leave of `stored` is preload, relaxation, or inside
  double dissipated = 0;  ///< of the system's dissipated power
};

/// Where a steady vibration comes from, and where its energy is.
struct PeakShares {
  std::complex<double> value;    ///< y; 0 where it is unbounded
  std::vector<ModeShare> modes;  ///< in their order; empty where y is unbounded or 0
  double beyond_modes = 0;       ///< rest of y: coordinates without mass, missing modes, frequency dependence, a moving
                                 ///< ground; with the modes it sums to 1
  double strain_energy = 0;      ///< mean over a period [J]; where y is unbounded that of the mode with φᵀAφ = 1
  std::vector<ElementShare> elements;  ///< as the system's; shares are 0 where there is nothing to share
  double geometric = 0;                ///< share of the strain energy of preload and weight where bodies turn
  double in_foundations = 0;           ///< share of the strain energy of foundations that give
  double dissipated_power = 0;         ///< mean over a period [W]
  double system_damping = 0;           ///< share of it that Rayleigh or modal damping takes
  double by_foundations = 0;           ///< share of it that foundations take
};

/// At any ω > 0; an unbounded peak is looked at through its mode.
/// @throws NotComputable on an undamped resonance that the place does not call unbounded
[[nodiscard]] PeakShares peak_shares(const model::System& system, const assembly::Assembled& assembled,
                                     const Question& question, const PeakPlace& place);

/// |y| over the most that a motion of this size could give this channel, both measured with the masses of the
/// coordinates: 0 … 1. Far below 1e-9 a symmetry keeps the answer still, and what is computed is round-off.
[[nodiscard]] double alignment(const model::System& system, const assembly::Assembled& assembled,
                               const Question& question, const PeakPlace& place);

}  // namespace trivet::response
