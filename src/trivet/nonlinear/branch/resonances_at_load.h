// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/nonlinear/balance/steady_equations.h"
#include "trivet/nonlinear/machine/reference_machine.h"

namespace trivet::nonlinear {

/// Motions under the whole load that lie on curves of phase resonance: along such a curve the excitation feeds what is
/// dissipated, so that it is the backbone of a mode with the load that holds it there.
struct ResonancesAtLoad {
  int curves = 0;  ///< followed
  std::vector<SteadyEquations::Place> motions;
};

/// For each damped mode about rest whose resonance may come into the band, and each excited harmonic: the translation
/// and the rotation of nonlinear parts that it moves most are held at the phase of the linear resonance, and the load
/// is raised from a small one through the folds of the curve, at most 400 points of 64 such curves.
/// @param options  over frequency
[[nodiscard]] ResonancesAtLoad resonances_at_load(const ReferenceMachine& machine, const SteadyOptions& options,
                                                  Eigen::Index harmonics, double load_up_to,
                                                  const foundation::Progress& progress);

}  // namespace trivet::nonlinear
