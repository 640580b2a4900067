// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/exports/fmi_version.h"
#include "trivet/exports/fmu_binaries.h"
#include "trivet/exports/linear_system.h"

namespace trivet::exports {

/// Bytes of a functional mock-up unit, for model exchange and co-simulation. The same arguments give the same bytes.
/// @throws foundation::InvalidInput if the system is wrong (see model_description) or there is no binary
[[nodiscard]] std::string functional_mockup_unit(const LinearSystem& system, FmiVersion version,
                                                 const FmuBinaries& binaries);

/// Writes it to a file, as a whole or not at all. An earlier file is replaced if it is empty or begins like a ZIP
/// archive.
/// @throws foundation::InvalidInput as above, or if the target must not be replaced or its folder is not writable
/// @throws std::runtime_error if it cannot be written
void write_fmu(const LinearSystem& system, FmiVersion version, const FmuBinaries& binaries,
               const std::filesystem::path& target);

}  // namespace trivet::exports
