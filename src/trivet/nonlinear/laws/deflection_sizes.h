// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/nonlinear/laws/deflections.h"

namespace trivet::nonlinear {

/// What changes and errors of deflections are compared with: translations with the largest translation, rotations with
/// the largest rotation. Metres and radians have no common measure, so that a large angle must not hide a travel that
/// it has nothing to do with; only round-off is small in both: the largest of a kind counts as at least a hundredth of
/// the one that needs the same energy as the largest of the other kind.
class DeflectionSizes {
 public:
  /// @param receptance  at ω = 0, deflections × deflections
  DeflectionSizes(const std::vector<Deflection>& deflections, const Eigen::MatrixXd& receptance);

  /// @param of  of each deflection, ≥ 0
  [[nodiscard]] Eigen::VectorXd largest_of_kind(const Eigen::VectorXd& of) const;

 private:
  std::vector<bool> is_rotation_;
  Eigen::VectorXd per_root_energy_;
};

}  // namespace trivet::nonlinear
