// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <list>

#include "fmu/linear_model.h"
#include "fmu/matrix.h"

namespace trivet::fmu {

/// The exact solution over a step h with inputs u + u' t: x(h) = F x + G u + H u'.
struct StepMatrix {
  double step = 0;     ///< h [s]
  Matrix from_states;  ///< F, n × n
  Matrix from_inputs;  ///< G, n × m
  Matrix from_slopes;  ///< H, n × m
};

/// From the exponential of the matrix [A h, B h, 0; 0, 0, I; 0, 0, 0].
/// @param step  [s], > 0  @throws std::runtime_error if it is not finite
[[nodiscard]] StepMatrix step_matrix(const LinearModel& model, double step);

/// The step matrices of the last few sizes of steps.
class StepMatrices {
 public:
  /// The matrix of the size that is nearest to `step` and differs by at most `tolerance` [s]; a new one if there is no
  /// such size. It is valid until the next call. @throws as step_matrix
  const StepMatrix& nearest(const LinearModel& model, double step, double tolerance);
  /// Number of matrices computed so far.
  [[nodiscard]] std::size_t computed() const { return computed_; }

 private:
  std::list<StepMatrix> recent_;  ///< the last one used is first
  std::size_t computed_ = 0;
};

}  // namespace trivet::fmu
