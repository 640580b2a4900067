// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/model/system.h"

namespace trivet::project {

/// "12.50 EUR" or "EUR 12.50": a number ≥ 0 and one word for the currency; none if the text is neither.
[[nodiscard]] std::optional<model::Price> price_from(const std::string& text);

/// "12.5 EUR"
[[nodiscard]] std::string price_words(const model::Price& price);

}  // namespace trivet::project
