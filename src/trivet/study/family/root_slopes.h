// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/design_neighbours.h"

namespace trivet::study {

/// Derivatives of ln ζ, ζ = −Re λ/|λ|, of a damped root, per parameter: dλ = −wᵀ dZ(λ) v / wᵀ (dZ/dλ) v with the left
/// and right vectors wᵀZ = 0, Zv = 0. Z(λ) = λ²A + λB + K + iK_loss, or the exact one of frequency-dependent elements.
/// Roots that agree within 1e-6 belong to one subspace, with the slopes of `separated_motions`.
/// @param index    in modal::Roots::list; not real
/// @param towards  how far each parameter may still move, with its sign
/// @returns  NaN for a defective pair, which has no slope
[[nodiscard]] Eigen::RowVectorXd damping_ratio_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                                      std::size_t index, const Eigen::VectorXd& towards);

}  // namespace trivet::study
