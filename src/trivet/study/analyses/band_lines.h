// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/assembly/limit_line.h"
#include "trivet/excitation/frequency_bands.h"
#include "trivet/study/analyses/case_context.h"

/// Limit lines over frequency bands: each band is judged at its nominal midband frequency.
namespace trivet::study {

/// That frequency [rad/s]; an end of the line that differs by round-off is meant.
[[nodiscard]] double read_at(const excitation::FrequencyBand& band, const assembly::LimitLine& line);

/// True if the line has a limit there.
[[nodiscard]] bool covers(const assembly::LimitLine& line, const excitation::FrequencyBand& band);

/// "excitation covers 60 % of the 50 Hz band", for every judged band that the spectra of the excitations fill only in
/// part: its level is that of this part. Empty if there is none.
[[nodiscard]] std::string partly_excited(const CaseContext& context, const project::LimitLineRequest& request,
                                         const std::vector<excitation::FrequencyBand>& bands);

}  // namespace trivet::study
