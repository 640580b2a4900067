// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"
#include "trivet/project/analyses/requirements.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Price and mass of all catalogue mounts together.
struct MountSums {
  std::optional<model::Price> price;  ///< none if a mount has none, or another currency
  std::optional<double> mass;         ///< none if a mount has none [kg]
};
[[nodiscard]] MountSums sums_of_mounts(const model::System& system);

/// The required price and mass against those of the mounts.
[[nodiscard]] std::vector<RequirementResult> mount_sums(const model::System& system,
                                                        const project::Requirements& required);

}  // namespace trivet::study
