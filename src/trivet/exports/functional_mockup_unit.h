// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/exports/fmi_version.h"
#include "trivet/exports/fmu_binaries.h"
#include "trivet/exports/linear_system.h"

namespace trivet::exports {

/// Bytes of a functional mock-up unit, for model exchange and co-simulation. The same arguments give the same bytes.
/// @throws foundation::InvalidInput if the system is wrong (see model_description) or there is no binary
[[nodiscard]] std::string functional_mockup_unit(const LinearSystem& system, FmiVersion version,
                                                 const FmuBinaries& binaries);

}  // namespace trivet::exports
