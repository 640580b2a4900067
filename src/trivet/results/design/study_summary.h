// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/study/analyses/case_results.h"

namespace trivet::results {

/// A computed study on one screen: first what is violated, not judged, not computed or failed, or else the least
/// margin; then what happens at the speeds of the machine, and one line per case with its warnings, natural frequencies
/// and highest peak, the best design, and warnings and notes, each once with its cases.
/// @param results  of every case of the project, in its order
/// @param width  of its table [characters]
[[nodiscard]] std::string study_summary(const project::Project& project, const std::vector<study::CaseResults>& results,
                                        std::size_t width);

}  // namespace trivet::results
