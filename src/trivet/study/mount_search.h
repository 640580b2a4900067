// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/study/optimization.h"

namespace trivet::study {

/// The best combination of mounts for numbers that are optimised too.
struct MountSearch {
  project::Project best;  ///< the project with the mounts of this combination
  OptimizedMounts found;
};

/// All combinations are ordered by the bounds of MountCombinations at the given numbers. The first ones are judged
/// completely with these numbers, and the numbers of the best of them optimised from there. If the price is minimised,
/// the numbers of the cheapest combinations are optimised until some meet every requirement. Nothing if no choice takes
/// part in the request.
/// @throws foundation::InvalidInput if only mounts vary, or a mount cannot be used at its places; NotComputable if no
/// combination has a design that can be judged
[[nodiscard]] std::optional<MountSearch> mount_search(const project::Project& project,
                                                      const project::OptimizeRequest& request,
                                                      const foundation::Progress& progress);

}  // namespace trivet::study
