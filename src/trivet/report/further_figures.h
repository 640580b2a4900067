// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/report/figures.h"

namespace trivet::report {

/// All figures of a case beside its harmonic characteristics: random response, motion in time, run-up, transmissibility, power, shock
/// response spectra, limit lines, operating shapes, map of designs. Of each what the case asks for.
[[nodiscard]] std::vector<Figure> further_figures(const study::Answers& answers);

}  // namespace trivet::report
