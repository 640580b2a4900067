// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Negative eigenvalue of the scaled loss matrix that its rounding explains, and that noise of a measurement does.
inline constexpr double rounded_loss = 1e-6, noisy_loss = 0.02;

/// The imaginary part of a constant complex stiffness (N, K, end axes) into the law of an element: a loss factor where
/// it is one multiple of the real part, which the law already holds; else a stiffness K' + iK'' that is the same at
/// every frequency. Problems go to the key `file`.
void take_loss(TableReader& reader, const elements::Matrix12& loss, const model::Span& span, model::Element& element);

}  // namespace trivet::project
