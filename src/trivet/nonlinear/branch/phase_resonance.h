// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/interruption.h"
#include "trivet/nonlinear/branch/steady_branch.h"

namespace trivet::nonlinear {

/// Motions in which a result lags the excitation by a given phase, over the load factor: at 90° they are the resonances
/// of the forced machine (phase resonance), and where the load turns, detached curves of motions begin or join others.
/// @param options  over the load factor, with `at_phase`
/// @throws foundation::NotComputable if there is no such motion at the lower end of the load
[[nodiscard]] SteadyBranch phase_resonances(const model::System& system, const SteadyOptions& options,
                                            const References& references, const foundation::Progress& progress);

}  // namespace trivet::nonlinear
