// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/exports/linear_system.h"

namespace trivet::exports {

/// The numbers of a system as the shared library of a mock-up unit reads them (apps/fmu/linear_model.h): the shortest
/// digits that read back as the same number, matrices by rows.
[[nodiscard]] std::string system_text(const LinearSystem& system, const std::string& token);

}  // namespace trivet::exports
