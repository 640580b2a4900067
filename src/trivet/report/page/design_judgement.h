// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/page/shown_case.h"

namespace trivet::report {

/// What the box counts, one row for each requirement, limit, clearance and map, with its worst case.
[[nodiscard]] std::string judgements_table(const std::vector<ShownCase>& cases, const project::DisplayUnits& display);

/// The box at the top of the page: red if any verdict is violated, amber if one is missing or a check of the data
/// failed, green if everything is met, and neither if the file requires nothing. It names the worst ones.
/// @param linked  the page shows the cases that it names, each after a click
[[nodiscard]] std::string judgement_box(const std::vector<ShownCase>& cases, bool linked);

}  // namespace trivet::report
