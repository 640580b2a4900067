// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/study/select/mount_curves.h"
#include "trivet/study/select/mount_selection.h"

namespace trivet::study {

/// What a ranking makes small in the designs that hold: price, mass [kg], or the largest transmissibility as a share of
/// the allowed one. 0 for a ranking by margin.
[[nodiscard]] double order_key(MountOrder order, const MountDesign& design);

/// The same for combinations before they are judged; 0 where it is not known without this.
/// @throws foundation::InvalidInput if a mount has no price or mass, prices differ in currency, or no isolation is
/// required
[[nodiscard]] std::vector<double> order_keys(MountOrder order, const MountCombinations& all, const MountCurves& curves,
                                             const std::vector<std::size_t>& combinations,
                                             const foundation::Progress& progress);

}  // namespace trivet::study
