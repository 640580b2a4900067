// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "trivet/modal/modes.h"

namespace trivet::modal {

/// Vectors of a singular matrix: Z right = 0 and leftᵀ Z = 0, as columns.
struct NullVectors {
  Eigen::MatrixXcd left, right;
};

/// By inverse iteration. @param scale  D that makes D Z D comparable, see numerics::unit_scale
/// @param count  dimension of the null space
[[nodiscard]] NullVectors null_vectors(const Eigen::MatrixXcd& Z, const Eigen::VectorXd& scale, Eigen::Index count);

/// Descriptions of the motions that no element restrains: "the system is free to slide along y", "… to turn about z
/// through (…) m", and for relative motions of parts the bodies that move. Empty if every motion is restrained.
[[nodiscard]] std::vector<std::string> free_motions(const model::System& system, const assembly::Assembled& assembled,
                                                    const Modes& modes);

}  // namespace trivet::modal
