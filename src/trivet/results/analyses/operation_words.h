// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/operation_types.h"

/// What happens at the speeds of a machine, in words for summary, verdict and report.
namespace trivet::results {

/// "At 980 rpm: largest velocity 1.24 mm/s rms, fan.bearing.x; largest force on the ground 45 N along z; …", with the
/// isolation and the natural frequency that is nearest to an excitation.
[[nodiscard]] Sentence operation_sentence(const study::OperatingSpeed& at);

/// "93.1 %, 23.2 dB", or "AMPLIFIED: T = 1.4, isolation −40 %, −2.92 dB".
[[nodiscard]] std::string isolation_words(double transmissibility);

/// "passes through it at 612 rpm", "near", "not excited"; empty for a distant one.
[[nodiscard]] std::string nearness_remark(const study::OperatingMode& mode);

}  // namespace trivet::results
