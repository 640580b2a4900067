// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

/// Warns where the ground is isolated from a force in total, but not at the single mounts: a transmissibility judges
/// the sum of their forces along the excitation, and in a resonance of pitch, roll or twist these cancel in the sum.
/// At each speed of `isolation` (of a band: at its ends and its natural frequencies) the magnitudes of the mounts'
/// forces must not add up to more than the exciting force. Of an exciting moment: the magnitudes of their moments about
/// the centre of the mounts, not to more than the same moment gives when it acts slowly. No warning where each mount
/// has a limit on its own force, nor where the total is amplified too: the requirement itself says so.
[[nodiscard]] foundation::Problems single_mount_warnings(const CaseContext& context, const project::Analyses& analyses);

}  // namespace trivet::study
