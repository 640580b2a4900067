// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "trivet/assembly/assembled.h"

namespace trivet::modal {

/// Rows of a body's free coordinates, and of the coordinates that follow it: of nodes, and inner ones of the elements
/// that hold it or these nodes.
struct BodyRows {
  std::vector<Eigen::Index> body, inner;
  std::vector<int> coordinates;  ///< of `body`, 0 … 5
  std::vector<bool> moving;      ///< the body, and the nodes that elements join to it
};
[[nodiscard]] BodyRows rows_of(const model::System& system, const assembly::Assembled& assembled, std::size_t body);

/// True if an end of the element is on something that moves.
[[nodiscard]] bool is_on(const model::Element& element, const std::vector<bool>& moving);

/// A body on its elements with all other bodies held: K φ = ω² A φ in its rows, first its own, then the inner ones.
struct OwnSystem {
  numerics::DynamicMatrices matrices;
  /// Share of the kinetic energy in each coordinate at the centre of mass, along body axes: φᵀEφ / φᵀAφ, φ in the own
  /// rows. E is not symmetric.
  std::array<Eigen::MatrixXd, 6> energy;
};
[[nodiscard]] OwnSystem own_system(const model::Body& body, const assembly::Assembled& assembled, const BodyRows& rows);

/// Its modes, λ = ω² ascending, φᵀAφ = norm = ±1.
struct OwnModes {
  Eigen::VectorXd lambda, norm;
  Eigen::MatrixXd shapes;
};
[[nodiscard]] OwnModes own_modes(const OwnSystem& own);

}  // namespace trivet::modal
