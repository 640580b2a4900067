// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivet::exchange {

/// One field of a bulk data card, and the line it stands in.
struct Field {
  std::string_view text;
  int line = 0;
};

/// A card of Nastran bulk data with its continuations: all data fields in one row, eight a line in small and free
/// field, four a line in large field.
struct Card {
  int line = 0;
  std::vector<Field> fields;
};

/// Blanks in the place of tabs, to the next multiple of eight columns.
[[nodiscard]] std::string without_tabs(std::string_view text);

/// All cards of that name (small letters) up to ENDDATA; other lines are passed over. The views point into `text`.
[[nodiscard]] std::vector<Card> bulk_cards(std::string_view text, std::string_view name);

}  // namespace trivet::exchange
