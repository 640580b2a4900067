// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/report/drawing/figures.h"
#include "trivet/study/optimize/design_front.h"

namespace trivet::report {

/// The front of two objectives with its knee, the line between its ends, and the given design if it is near.
[[nodiscard]] Figure front_figure(const study::DesignFront& front, const std::string& title);

}  // namespace trivet::report
