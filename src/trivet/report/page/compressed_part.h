// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace trivet::report {

/// A part of the page that it unpacks when a reader wants it: gzip, as base64. The same text gives the same bytes.
/// @throws std::runtime_error for a text above 4 GiB, std::bad_alloc
[[nodiscard]] std::string compressed_part(std::string_view text);

}  // namespace trivet::report
