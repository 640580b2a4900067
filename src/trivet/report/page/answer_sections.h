// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/drawing/figures.h"
#include "trivet/study/analyses/answers.h"

namespace trivet::report {

/// Sections of the page for the answers of a case in addition to its harmonic characteristics: pictures and tables of
/// their key numbers. HTML without scripts.
[[nodiscard]] std::string answer_sections(const project::Case& variant, const study::Answers& answers);

/// Only their figures, numbered by kind in their file names.
[[nodiscard]] std::vector<Figure> answer_figures(const study::Answers& answers);

}  // namespace trivet::report
