// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/exports/fmi_version.h"
#include "trivet/exports/linear_system.h"

namespace trivet::exports {

/// Identifier of a mock-up unit, also the name of its shared library: the title with letters and digits of ASCII and _.
[[nodiscard]] std::string model_identifier(const LinearSystem& system);

/// Text of modelDescription.xml for model exchange and co-simulation. It depends only on its arguments and the version
/// of Trivet.
/// @param token  identifies this description and the resources that belong to it (GUID, instantiation token)
/// @throws foundation::InvalidInput if the system is wrong (see check), has a unit that is not coherent SI, or uses a
/// name that a variable of the unit needs
[[nodiscard]] std::string model_description(const LinearSystem& system, FmiVersion version, const std::string& token);

}  // namespace trivet::exports
