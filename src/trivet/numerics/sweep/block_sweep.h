// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/lanes/line_memory.h"
#include "trivet/numerics/lanes/planes.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/load.h"
#include "trivet/numerics/sweep/block_plan.h"

namespace trivet::numerics {

/// Some frequencies of one sweep, in the coordinates in which the matrices were given.
struct BlockBatch {
  const double* omega = nullptr;
  Eigen::Index count = 0;
  Planes free;      ///< what is added to each free entry
  Planes load;      ///< n planes, if the sweep has no load of its own
  Planes response;  ///< n planes, written
  double* backward_error =
      nullptr;  ///< written; above `accepted_backward_error`, or NaN, a frequency must be solved with pivoting
  bool measure_all =
      false;  ///< every residual in full; otherwise those that one fixed direction does not show to be small
};

/// q(ω) = Z(ω)⁻¹ h(ω) of many coupled bodies: LDLᵀ by blocks of coordinates that belong together, eliminated in an
/// order that is found once, several frequencies at a time in lanes. Cost and memory grow linearly with the bodies of a
/// chain or a tree.
class BlockSweep {
 public:
  /// Of symmetric matrices, of which the lower triangle is read.
  BlockSweep(const DynamicMatrices& matrices, const Load& load, const std::vector<FreeEntry>& free = {});
  /// With a load that is given for each frequency.
  explicit BlockSweep(const DynamicMatrices& matrices, const std::vector<FreeEntry>& free = {});

  /// Each frequency complete in itself: what comes out does not depend on the others. Backward errors as in
  /// `SweepResult`, seen through one fixed direction, and where that is doubtful measured in full and refined. Callable
  /// from several threads, each with memory of its own, whose size does not depend on the count.
  /// @return for how many it was doubtful
  int solve(const BlockBatch& batch, LineMemory& memory) const;

  /// Z(ω) in coordinates of unit mass diagonal, without what is added to free entries.
  [[nodiscard]] Eigen::MatrixXcd scaled_matrix(double omega) const;

  /// Complex multiply-adds for one frequency.
  [[nodiscard]] double multiply_adds() const { return plan_.multiply_adds; }

 private:
  BlockPlan plan_;
};

}  // namespace trivet::numerics
