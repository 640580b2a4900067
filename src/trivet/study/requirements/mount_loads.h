// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"
#include "trivet/project/analyses/requirements.h"
#include "trivet/response/machinery/load_sharing.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// One mount at rest as linear functions of the coordinates, whatever moves it; loads as in `response::RatedLoad`,
/// along its own axes, which turn with its end N.
struct MountRows {
  Eigen::Matrix<double, 3, Eigen::Dynamic> load;  ///< along its axes [N]
  Eigen::RowVectorXd deflection;                  ///< along e3, after creep [m]
  Eigen::Vector3d load_at_rest = Eigen::Vector3d::Zero();
  double deflection_at_rest = 0;
};
[[nodiscard]] MountRows mount_rows(const model::System& system, const assembly::Assembled& assembled,
                                   const model::Element& element);

/// Least factor by which a load [N] may grow or fall within its range; 0 on the other side of zero than the range.
[[nodiscard]] double margin_in_range(double load, const Eigen::Vector2d& range);

/// True where the margin in its range grows with the load: nearer to the end next to zero than to the other one.
[[nodiscard]] bool is_near_lower_end(double load, const Eigen::Vector2d& range);

/// Share of its range that a load takes: of the end on its side of zero; infinite if the range has none there.
[[nodiscard]] double share_of_range(double load, const Eigen::Vector2d& range);

/// Loads of all catalogue mounts at rest; none if they cannot be computed, for this reason.
struct MountsAtRest {
  std::vector<response::RatedLoad> loads;
  std::string reason;
};
[[nodiscard]] MountsAtRest mounts_at_rest(const CaseContext& context);

/// Static loads of each catalogue mount along its axes, and its deflection after creep, against the ranges of its
/// maker. A noticeable load in a direction without a range is not judged.
[[nodiscard]] std::vector<RequirementResult> mount_loads(const CaseContext& context);

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
