// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "trivet/exports/linear_system.h"

namespace trivet::exports {

/// Version of the Functional Mock-up Interface.
enum class FmiVersion { two, three };

// Attributes of an XML element, each after a space; without a value, nothing is written.

/// ` name="a &lt; b"`; empty for an empty value.
[[nodiscard]] std::string attribute(const char* name, const std::string& value);
[[nodiscard]] std::string attribute(const char* name, std::size_t value);
/// Shortest digits that read back as the same number.
[[nodiscard]] std::string attribute(const char* name, const std::optional<double>& value);

/// Identifier of a mock-up unit, also the name of its shared library: the title with letters and digits of ASCII and _.
[[nodiscard]] std::string model_identifier(const LinearSystem& system);

/// Text of modelDescription.xml for model exchange and co-simulation. It depends only on its arguments and the version
/// of Trivet.
/// @param token  identifies this description and the resources that belong to it (GUID, instantiation token)
/// @throws foundation::InvalidInput if the system is wrong (see check), has a unit that is not coherent SI, or uses a
/// name that a variable of the unit needs
[[nodiscard]] std::string model_description(const LinearSystem& system, FmiVersion version, const std::string& token);

}  // namespace trivet::exports
