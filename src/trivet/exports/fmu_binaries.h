// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace trivet::exports {

/// The shared library of mock-up units (apps/fmu) for several systems; empty if there is none for a system.
struct FmuBinaries {
  std::string_view linux_x86_64;
  std::string_view windows_x86_64;
  std::string_view licence;  ///< text that must accompany them; may be empty
};

/// Those that were built with this program.
[[nodiscard]] FmuBinaries built_fmu_binaries();

}  // namespace trivet::exports
