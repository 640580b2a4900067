// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/analyses/case_results.h"

/// Key numbers of each kind of result as HTML; empty if the case did not request it.
namespace trivet::report {

/// Folds and largest motions of nonlinear machines.
[[nodiscard]] std::string steady_tables(const study::CaseResults& results);

}  // namespace trivet::report
