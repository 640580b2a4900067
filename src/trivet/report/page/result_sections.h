// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/figures.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::report {

/// Sections of the page for the results of a case in addition to its harmonic characteristics: pictures and tables of
/// their key numbers. HTML without scripts.
[[nodiscard]] std::string result_sections(const project::Case& variant, const study::CaseResults& results);

/// Only their figures and those of the modes, numbered by kind in their file names.
[[nodiscard]] std::vector<Figure> result_figures(const project::Case& variant, const study::CaseResults& results);

/// Figures on the page.
[[nodiscard]] std::string figures_html(const std::vector<Figure>& figures);

}  // namespace trivet::report
