// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

/// States that do not act on each other: pairs, and groups of more states that no well-conditioned basis separates.
struct StateGroups {
  Eigen::Index pairs = 0;           ///< pair j: states j and pairs + j
  std::vector<Eigen::Index> dense;  ///< sizes of the groups that follow the pairs
};

/// F = X D Y with Y X = 1. A pair is one complex pole with its conjugate, or two real poles. States without any
/// coupling are added until the number of pairs is a multiple of `multiple`.
struct PairForm {
  StateGroups groups;
  Eigen::MatrixXd D;  ///< zero outside the groups
  Eigen::MatrixXd X;  ///< states of F × states of D
  Eigen::MatrixXd Y;  ///< states of D × states of F
};

/// Separates the states of ẋ = F x. States that are coupled by round-off of the diagonal alone, such as undamped modes,
/// keep their coordinates; others take eigenvectors, improved once with residuals in extended precision. States whose
/// eigenvectors are nearly parallel (the projector of a pair has a norm above 1000) remain one dense group.
[[nodiscard]] PairForm pair_form(const Eigen::MatrixXd& F, Eigen::Index multiple);

}  // namespace trivet::numerics
