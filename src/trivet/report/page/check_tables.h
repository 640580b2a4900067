// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/report/page/shown_case.h"

namespace trivet::report {

/// Checks of the data of a case and of the solution of its response, with a verdict on each.
[[nodiscard]] std::string checks_table(const ShownCase& shown);

}  // namespace trivet::report
