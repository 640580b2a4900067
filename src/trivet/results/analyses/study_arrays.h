// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/labelled_arrays.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/explain/linear_system.h"
#include "trivet/study/map/design_sweep.h"

namespace trivet::results {

/// A, B, K, K_loss over (coordinate, column), with the names and units of the coordinates; load_power, load_delay [s]
/// and load, one row per term h = Σ s^power e^{−s delay} load, s = iω; exact, 1 or 0. Views of `matrices`, but for the
/// loads and a K_loss that is zero.
[[nodiscard]] LabelledArrays matrix_arrays(const study::SystemMatrices& matrices);

/// A, B, C, D, which are views of `system`, with the names and units of states, inputs and outputs.
[[nodiscard]] LabelledArrays linear_system_arrays(const study::LinearSystem& system);

/// "amplitude" over one axis per number and one over the results. A view of `sweep`.
[[nodiscard]] LabelledArrays sweep_arrays(const study::SweepRequest& request, const study::DesignSweep& sweep);

}  // namespace trivet::results
