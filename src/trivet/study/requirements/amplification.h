// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/verdict.h"

/// Does a machine pass more of an excitation to the ground than acts on it, where it runs?
namespace trivet::study {

/// Largest transmissibility where the machine runs, as far as the file states this: over the band of
/// `transmissibility`, of every `isolation`, or at the operating frequencies below. None if it states nothing.
/// @param judged  all requirements of this case
[[nodiscard]] std::optional<double> operating_transmissibility(const CaseContext& context,
                                                               const project::Analyses& analyses,
                                                               const std::vector<RequirementResult>& judged);

/// Which quantity that is, and where: "largest motion of seat over a motion of the ground along z, 2 … 60 Hz".
[[nodiscard]] std::string operating_transmissibility_words(const project::Analyses& analyses);

/// Warns of an excitation that is amplified at its operating frequency (T > 1), if no requirement speaks of forces on
/// the ground. Operating frequencies: the service speed of an unbalance; the band of `transmissibility` or of the
/// requirements, if it ends below twice its beginning: a wider one is a run-up.
[[nodiscard]] foundation::Problems amplification_warnings(const CaseContext& context,
                                                          const project::Analyses& analyses);

}  // namespace trivet::study
