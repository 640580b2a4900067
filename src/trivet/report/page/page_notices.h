// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/page/shown_case.h"

namespace trivet::report {

/// Checks of the data of a case and of the solution of its response, with a verdict on each.
[[nodiscard]] std::string checks_table(const ShownCase& shown);

/// The verdict on the design, then warnings, failed checks and rigid-body modes of all cases; equal texts once, with
/// their cases. @param linked  the page shows the cases, each after a click
[[nodiscard]] std::string page_notices(const std::vector<ShownCase>& cases, bool linked);

/// One row for each case; a button selects the case.
[[nodiscard]] std::string glance_table(const std::vector<ShownCase>& cases);

/// Name of a case, its faults and its changes from the base model.
[[nodiscard]] std::string case_head(const ShownCase& shown, std::size_t cases);

}  // namespace trivet::report
