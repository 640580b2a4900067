// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/documents/document.h"
#include "trivet/study/optimize/optimization.h"

/// What the machines within the tolerances have of the best design.
namespace trivet::results {

/// "99 % of the machines", "the worst machines found".
[[nodiscard]] std::string robust_subject(const study::RobustOptimum& robust);

/// "machines that meet every requirement: 99.4 % (95 % confidence: 99.3 % … 99.5 %), wanted 99 %".
[[nodiscard]] std::string robust_verdict(const study::RobustOptimum& robust);

/// Adds the yields and margins beside those without tolerances.
void add_robust(const study::Optimization& found, documents::Document& document);

}  // namespace trivet::results
