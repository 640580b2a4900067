// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/case_context.h"
#include "trivet/study/verdict.h"

namespace trivet::study {

/// One mount at rest as linear functions of the coordinates.
struct MountRows {
  Eigen::RowVectorXd compression, deflection;  ///< along its axis [N, m]
  double compression_at_rest = 0, deflection_at_rest = 0;
};
[[nodiscard]] MountRows mount_rows(const model::System& system, const assembly::Assembled& assembled,
                                   const model::Element& element);

/// Least factor by which a compression [N] may grow or fall within its range.
[[nodiscard]] double margin_in_range(double compression, const Eigen::Vector2d& range);

/// Static force of each catalogue mount along its axis, and its deflection, against the ranges of its maker.
[[nodiscard]] std::vector<RequirementResult> mount_loads(const CaseContext& context);

}  // namespace trivet::study
