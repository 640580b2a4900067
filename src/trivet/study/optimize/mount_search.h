// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "trivet/study/optimize/optimization.h"

namespace trivet::study {

/// The best combination of mounts for numbers that are optimised too.
struct MountSearch {
  project::Project best;    ///< the project with the mounts of this combination
  Eigen::VectorXd numbers;  ///< what its numbers reached, as shares of their ranges
  OptimizedMounts found;
};

/// If there are more combinations than are optimised, all are ordered by the bounds of MountCombinations at the given
/// numbers and a few others; the first ones are judged completely with these. The numbers of the best, or of all, are
/// optimised from the given ones and from the best of a few looks over their ranges. If the price is minimised,
/// the numbers of the cheapest combinations are optimised until some meet every requirement. Nothing if no choice takes
/// part in the request.
/// @throws foundation::InvalidInput if only mounts vary, or a mount cannot be used at its places; NotComputable if no
/// combination has a design that can be judged
/// @param enough  true if combinations that are left are not to be tried
[[nodiscard]] std::optional<MountSearch> mount_search(const project::Project& project,
                                                      const project::OptimizeRequest& request,
                                                      const foundation::Progress& progress,
                                                      const std::function<bool()>& enough = {});

}  // namespace trivet::study
