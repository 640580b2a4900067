// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/limit_line.h"
#include "trivet/excitation/frequency_bands.h"

/// Limit lines over frequency bands: each band is judged at its nominal midband frequency.
namespace trivet::study {

/// That frequency [rad/s]; an end of the line that differs by round-off is meant.
[[nodiscard]] double read_at(const excitation::FrequencyBand& band, const assembly::LimitLine& line);

/// True if the line has a limit there.
[[nodiscard]] bool covers(const assembly::LimitLine& line, const excitation::FrequencyBand& band);

}  // namespace trivet::study
