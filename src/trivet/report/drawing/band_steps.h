// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/results/format/in_documents.h"

namespace trivet::report {

/// Sets a curve to a step from edge to edge of each band, with gaps where bands do not meet.
/// @param bands  ascending  @param heights  as many
void set_steps(PanelCurve& curve, const std::vector<excitation::FrequencyBand>& bands,
               const std::vector<double>& heights, const project::DisplayUnits& display);

}  // namespace trivet::report
