// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/block_plan.h"
#include "trivet/numerics/dynamic_matrices.h"
#include "trivet/numerics/load.h"

namespace trivet::numerics {

/// q(ω) = Z(ω)⁻¹ h(ω) of many coupled bodies: LDLᵀ by blocks of coordinates that belong together, eliminated in an order that is found once,
/// several frequencies at a time in lanes. Cost and memory grow linearly with the bodies of a chain or a tree.
class BlockSweep {
 public:
  /// Of symmetric matrices.
  BlockSweep(const DynamicMatrices& matrices, const Load& load);

  /// Responses at omega[0 … count), n × count, each column complete in itself: it depends on its own frequency only. Backward errors as in `SweepResult`;
  /// above `accepted_backward_error` (or NaN) the column must be solved with pivoting.
  /// @return for how many the residual was looked at in full, and refined if need be
  int solve(const double* omega, Eigen::Index count, Eigen::Ref<Eigen::MatrixXcd> response, Eigen::Ref<Eigen::VectorXd> backward_error) const;

  /// Complex multiply-adds for one frequency.
  [[nodiscard]] double multiply_adds() const { return plan_.multiply_adds; }

 private:
  BlockPlan plan_;
};

}  // namespace trivet::numerics
