// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/csv_field.h"

#include <fmt/compile.h>

namespace trivet::documents {

ShortestDigits::ShortestDigits(double value)
    : size_(static_cast<std::size_t>(fmt::format_to(characters_.data(), FMT_COMPILE("{}"), value) -
                                     characters_.data())) {}

}  // namespace trivet::documents
