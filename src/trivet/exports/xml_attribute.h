// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

/// Attributes of an XML element, each after a space; without a value, nothing is written.
namespace trivet::exports {

/// ` name="a &lt; b"`; empty for an empty value.
[[nodiscard]] std::string attribute(const char* name, const std::string& value);
[[nodiscard]] std::string attribute(const char* name, std::size_t value);
/// Shortest digits that read back as the same number.
[[nodiscard]] std::string attribute(const char* name, const std::optional<double>& value);

}  // namespace trivet::exports
