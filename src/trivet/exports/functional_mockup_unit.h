// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exports/linear_system.h"
#include "trivet/exports/model_description.h"

namespace trivet::exports {

/// The shared library of mock-up units (apps/fmu) for several systems; empty if there is none for a system.
struct FmuBinaries {
  std::string_view linux_x86_64;
  std::string_view windows_x86_64;
  std::string_view licence;  ///< text that must accompany them; may be empty
};

/// Those that were built with this program.
[[nodiscard]] FmuBinaries built_fmu_binaries();

/// Bytes of a functional mock-up unit, for model exchange and co-simulation. The same arguments give the same bytes.
/// @throws foundation::InvalidInput if the system is wrong (see model_description) or there is no binary
[[nodiscard]] std::string functional_mockup_unit(const LinearSystem& system, FmiVersion version,
                                                 const FmuBinaries& binaries);

}  // namespace trivet::exports
