// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "trivet/response/steady/static_response.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/design_neighbours.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Derivatives of ln|y| at fixed frequencies, frequencies × parameters: y = cᵀq with Zq = h gives
/// dy = λᵀ(dh − dZ q) + dcᵀq with Zᵀλ = c. At a maximum of |y| its shift does not count.
/// @param result  names the curve
/// @param frequencies  [rad/s]; 0 stands for the limit at rest
[[nodiscard]] Eigen::MatrixXd curve_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                           const RequirementResult& result, const std::vector<double>& frequencies);

/// Derivatives of ln of the share of kinetic energy in the purest coordinate of modes of a body on its elements, per
/// parameter. The shape moves by (K − λA) dφ − Aφ dλ = −(dK − λ dA) φ with 2 φᵀA dφ = −φᵀdA φ. Of equal frequencies the
/// shapes are those of the value, and stay as they are within their subspace.
/// @param modes  of modal::BodySuspension::modes, from 0
/// @returns  modes × parameters
[[nodiscard]] Eigen::MatrixXd decoupling_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                                std::size_t body, const std::vector<std::size_t>& modes);

/// The row of a result at rest in a model.
using RestRowOf = std::function<response::RestRow(const model::System&, const assembly::Assembled&)>;

/// Derivatives of ln|y| of a result at rest, per parameter: y = cᵀq_w + dᵀq_l + y₀ (response::StaticSolution), K₀ᵀμ =
/// c, Kᵀλ = d give dy = μᵀ(dQ_w − dK₀ q_w) + λᵀ(dQ_l − dK q_l) + dcᵀq_w + ddᵀq_l + dy₀.
[[nodiscard]] Eigen::RowVectorXd rest_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                             const RestRowOf& row_of);

/// Derivatives of ln ζ, ζ = −Re λ/|λ|, of a damped root, per parameter: dλ = −wᵀ dZ(λ) v / wᵀ (dZ/dλ) v with the left
/// and right vectors wᵀZ = 0, Zv = 0. Z(λ) = λ²A + λB + K + iK_loss, or the exact one of frequency-dependent elements.
/// Roots that agree within 1e-6 belong to one subspace, with the slopes of `separated_motions`.
/// @param index    in modal::Roots::list; not real
/// @param towards  how far each parameter may still move, with its sign
/// @returns  NaN for a defective pair, which has no slope
[[nodiscard]] Eigen::RowVectorXd damping_ratio_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                                      std::size_t index, const Eigen::VectorXd& towards);

}  // namespace trivet::study
