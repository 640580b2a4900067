// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/model/system.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// A number that acts if its key is not written.
struct DefaultNumber {
  double value = 0;
  Quantity quantity = Quantity::pure;
};

/// Keys of such numbers that are no components of a table.
[[nodiscard]] const std::vector<std::string>& numbers_with_default();

/// Default at a path, for keys of which the file need not have any.
[[nodiscard]] std::optional<DefaultNumber> default_number(const std::vector<std::string>& keys);

/// Quantity of the number at a path of a document whose model has been read; none if there is no such number.
[[nodiscard]] std::optional<Quantity> quantity_at(const Node& document, const std::vector<std::string>& keys);

/// Warns at the line of a key: that it has no effect beside the others of its table, or of what its value leaves out.
void warn_at_key(TableReader& reader, const std::string& key, std::string finding, std::string rule,
                 std::string remedy);

/// "12.50 EUR" or "EUR 12.50": a number ≥ 0 and one word for the currency; none if the text is neither.
[[nodiscard]] std::optional<model::Price> price_from(const std::string& text);

/// "12.5 EUR"
[[nodiscard]] std::string price_words(const model::Price& price);

/// `key = [from, to]` in rad/s or with units, 0 ≤ from < to.
[[nodiscard]] std::optional<assembly::Band> read_band(TableReader& reader, const std::string& key);

}  // namespace trivet::project
