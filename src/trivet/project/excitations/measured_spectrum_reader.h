// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/excitation/spectrum.h"
#include "trivet/model/excitation.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// `history = {file = "floor.csv"}` with `resolution = "0.25 Hz"`: the density of a record at equal times. A warning
/// says if few segments fit into it.
[[nodiscard]] std::optional<excitation::Spectrum> read_measured_spectrum(TableReader& psd, const model::Action& action);

}  // namespace trivet::project
