// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace trivet::documents {

/// Bytes as text, four characters for three bytes (RFC 4648), as pages store numbers and programs.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace trivet::documents
