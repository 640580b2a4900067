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

/// Some frequencies of one sweep, in the coordinates of the given matrices.
struct BlockBatch {
  const double* omega = nullptr;
  Eigen::Index count = 0;
  Planes free;      ///< values added to the free entries
  Planes load;      ///< n planes, if the sweep has no fixed load
  Planes response;  ///< n planes, written
  double* backward_error =
      nullptr;  ///< written; above `accepted_backward_error`, or NaN, a frequency must be solved with pivoting
  bool measure_all =
      false;  ///< compute every residual in full; otherwise only those not small along one fixed direction
};

/// q(ω) = Z(ω)⁻¹ h(ω) of many coupled bodies: LDLᵀ by blocks of coordinates that belong together, in an elimination
/// order that is found once, several frequencies at a time in lanes. Cost and memory grow linearly with the number of
/// bodies of a chain or a tree.
class BlockSweep {
 public:
  /// Symmetric matrices; only the lower triangle is read.
  BlockSweep(const DynamicMatrices& matrices, const Load& load, const std::vector<FreeEntry>& free = {});
  /// With a load that is given for each frequency.
  explicit BlockSweep(const DynamicMatrices& matrices, const std::vector<FreeEntry>& free = {});

  /// Solves each frequency independently of the others. Backward errors as in `SweepResult`, along one fixed direction;
  /// doubtful ones are computed in full and refined. Callable from several threads, each with its own memory, of a size
  /// that does not depend on the count.
  /// @return number of doubtful frequencies
  int solve(const BlockBatch& batch, LineMemory& memory) const;

  /// Z(ω) in coordinates of unit mass diagonal, without the values added to free entries.
  [[nodiscard]] Eigen::MatrixXcd scaled_matrix(double omega) const;

  /// Complex multiply-adds for one frequency.
  [[nodiscard]] double multiply_adds() const { return plan_.multiply_adds; }

 private:
  BlockPlan plan_;
};

}  // namespace trivet::numerics
