// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/block_plan.h"
#include "trivet/numerics/dynamic_matrices.h"
#include "trivet/numerics/load.h"

namespace trivet::numerics {

/// Complex numbers of many frequencies: number k of frequency f at [k · stride + f].
struct FrequencyPlanes {
  double* re = nullptr;
  double* im = nullptr;
  Eigen::Index stride = 0;
};

/// Some frequencies of one sweep, in the coordinates in which the matrices were given.
struct BlockBatch {
  const double* omega = nullptr;
  Eigen::Index count = 0;
  FrequencyPlanes free;              ///< what is added to each free entry
  FrequencyPlanes load;              ///< n planes, if the sweep has no load of its own
  FrequencyPlanes response;          ///< n planes, written
  double* backward_error = nullptr;  ///< written; above `accepted_backward_error`, or NaN, a frequency must be solved with pivoting
  bool measure_all = false;          ///< every residual in full; otherwise those that one fixed direction does not show to be small
};


/// q(ω) = Z(ω)⁻¹ h(ω) of many coupled bodies: LDLᵀ by blocks of coordinates that belong together, eliminated in an order that is found once,
/// several frequencies at a time in lanes. Cost and memory grow linearly with the bodies of a chain or a tree.
class BlockSweep {
 public:
  /// Of symmetric matrices.
  BlockSweep(const DynamicMatrices& matrices, const Load& load, const std::vector<FreeEntry>& free = {});
  /// With a load that is given for each frequency.
  explicit BlockSweep(const DynamicMatrices& matrices, const std::vector<FreeEntry>& free = {});

  /// Each frequency complete in itself: what comes out does not depend on the others. Backward errors as in `SweepResult`, seen through one fixed direction,
  /// and where that is doubtful measured in full and refined. Its memory is that of a few lanes, whatever the count; callable from several threads.
  /// @return for how many it was doubtful
  int solve(const BlockBatch& batch) const;
  /// The same with one column for each frequency.
  int solve(const double* omega, Eigen::Index count, Eigen::Ref<Eigen::MatrixXcd> response, Eigen::Ref<Eigen::VectorXd> backward_error) const;

  /// Complex multiply-adds for one frequency.
  [[nodiscard]] double multiply_adds() const { return plan_.multiply_adds; }

 private:
  BlockPlan plan_;
};

}  // namespace trivet::numerics
