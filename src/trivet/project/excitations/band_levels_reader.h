// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/excitation/spectrum.h"
#include "trivet/model/excitation.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// `bands = "third-octave"` with `levels = [["1 Hz", "2.1 µm/s rms"], …]` or with `file` and its column `level`: the
/// density of the excitation that is constant in each band in the quantity of the levels. Levels of a motion are
/// displacements, velocities or accelerations, whatever the excitation is; their unit distinguishes them.
[[nodiscard]] std::optional<excitation::Spectrum> read_band_levels(TableReader& psd, const model::Action& action);

}  // namespace trivet::project
