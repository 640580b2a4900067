// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/in_documents.h"

namespace trivet::report {

struct Tick {
  double value = 0;
  std::string label;  ///< empty: a minor tick
};

/// Round values (1, 2, 5 × 10ⁿ) inside [from, to], about `wanted` of them.
[[nodiscard]] std::vector<Tick> linear_ticks(double from, double to, int wanted);

/// Powers of ten inside [from, to], all labelled; with few decades also 2 and 5 times them, with less than one decade
/// linear_ticks: at least three.
[[nodiscard]] std::vector<Tick> decade_ticks(double from, double to);

/// Multiples of 30°, 45°, 90° or 180° inside [from, to] degrees.
[[nodiscard]] std::vector<Tick> angle_ticks(double from, double to);

}  // namespace trivet::report
