// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/design_neighbours.h"

namespace trivet::study {

/// Derivatives of ln of the share of kinetic energy in the purest coordinate of modes of a body on its elements, per
/// parameter. The shape moves by (K − λA) dφ − Aφ dλ = −(dK − λ dA) φ with 2 φᵀA dφ = −φᵀdA φ. Of equal frequencies the
/// shapes are those of the value, and stay as they are within their subspace.
/// @param modes  of modal::BodySuspension::modes, from 0
/// @returns  modes × parameters
[[nodiscard]] Eigen::MatrixXd decoupling_slopes(const CaseContext& context, const DesignNeighbours& neighbours,
                                                std::size_t body, const std::vector<std::size_t>& modes);

}  // namespace trivet::study
