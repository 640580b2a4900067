// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>

#include "trivet/response/steady/static_response.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/design_neighbours.h"

namespace trivet::study {

/// The row of a result at rest in a model.
using RestRowOf = std::function<response::RestRow(const model::System&, const assembly::Assembled&)>;

/// Derivatives of ln|y| of a result at rest, per parameter: y = cᵀq_w + dᵀq_l + y₀ (response::StaticSolution), K₀ᵀμ =
/// c, Kᵀλ = d give dy = μᵀ(dQ_w − dK₀ q_w) + λᵀ(dQ_l − dK q_l) + dcᵀq_w + ddᵀq_l + dy₀.
[[nodiscard]] Eigen::RowVectorXd rest_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                             const RestRowOf& row_of);

}  // namespace trivet::study
