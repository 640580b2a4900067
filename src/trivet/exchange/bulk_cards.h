// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivet::exchange {

/// One field of a bulk data card, and its line number.
struct Field {
  std::string_view text;
  int line = 0;
};

/// A card of Nastran bulk data with its continuations: all data fields in one list, eight per line in small and free
/// field format, four per line in large field format.
struct Card {
  int line = 0;
  std::vector<Field> fields;
};

/// Text with tabs replaced by blanks up to the next multiple of eight columns.
[[nodiscard]] std::string without_tabs(std::string_view text);

/// All cards of this name (lower case) up to ENDDATA; other lines are skipped. The views point into `text`.
[[nodiscard]] std::vector<Card> bulk_cards(std::string_view text, std::string_view name);

}  // namespace trivet::exchange
