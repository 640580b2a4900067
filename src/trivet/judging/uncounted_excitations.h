// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"

namespace trivet::judging {

/// Warns of engine orders and random motion that limits on amplitudes do not count: they are those of harmonic motion.
/// None where the orders have a limit with `speed`, or the random motion a requirement on the rms, of the same result;
/// nor for a limit that names its excitations. The same of engine orders and an isolation that names no force.
void warn_of_uncounted_excitations(const model::System& system, const project::Analyses& request,
                                   foundation::Problems& problems);

}  // namespace trivet::judging
