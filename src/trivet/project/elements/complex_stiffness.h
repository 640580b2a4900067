// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Largest negative eigenvalue of the scaled loss matrix that rounding, or noise of a measurement, explains.
inline constexpr double rounded_loss = 1e-6, noisy_loss = 0.02;

/// Adds the imaginary part of a constant complex stiffness (N, K, end axes) to the law of an element: a loss factor if
/// it is a multiple of the real part, which the law already has; else a stiffness K' + iK'' that is the same at every
/// frequency. Problems are reported at the key `file`.
void set_loss(TableReader& reader, const elements::Matrix12& loss, const model::Span& span, model::Element& element);

}  // namespace trivet::project
