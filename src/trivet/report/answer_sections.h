// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/figures.h"
#include "trivet/study/answers.h"

namespace trivet::report {

/// Sections of the page for what a case asks for beside its harmonic characteristics: pictures, and tables of their key
/// numbers. HTML, needs no script.
[[nodiscard]] std::string answer_sections(const study::Answers& answers);

/// Their figures alone, those of each kind numbered in their file names.
[[nodiscard]] std::vector<Figure> answer_figures(const study::Answers& answers);

}  // namespace trivet::report
