// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "fmu/instance.h"

namespace trivet::fmu {

/// A new instance of the model in `system.txt` of the resources, or null with a report in the log.
/// @param token  must be the token of the model  @param folder  determines the path of the resources, and may throw
[[nodiscard]] Instance* new_instance(InterfaceKind kind, const char* token, const std::function<std::string()>& folder,
                                     const Log& log, bool reports_events) noexcept;

}  // namespace trivet::fmu
