// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

namespace trivet::documents {

/// A table of which some columns may be left out, with their headings.
struct FittedTable {
  std::string text;
  std::vector<std::string> left_out;
};

/// A table for the terminal: columns as wide as their widest entry, numbers right-aligned, words left. A table wider
/// than the screen is split into parts below each other, each with the first column.
class TextTable {
 public:
  /// @param together  number of columns after the first that are not separated: 2 for amplitude and phase
  /// @param screen    width of the screen [characters]
  /// @param numbers  columns that are right-aligned; empty: those that contain numbers only
  explicit TextTable(std::vector<std::string> header, std::size_t together = 1, std::size_t screen = 150,
                     std::vector<bool> numbers = {})
      : rows_{std::move(header)}, together_(together), screen_(screen), numbers_(std::move(numbers)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] std::string text() const;
  /// Columns that do not fit beside each other, from the right but for the first, those to keep, and the last if it has
  /// words: a verdict or a remark. They follow below with the first column, which must name each row, if that takes few
  /// lines; otherwise they are left out. If even those to keep do not fit, each row is a block with a line for each
  /// column.
  /// @param kept  columns to keep, if none are together
  [[nodiscard]] FittedTable fitted(const std::vector<bool>& kept) const;

 private:
  struct Layout {
    std::vector<std::size_t> widest;
    std::vector<bool> numeric;
  };
  [[nodiscard]] Layout layout() const;
  [[nodiscard]] std::string blocks() const;
  [[nodiscard]] std::vector<std::vector<bool>> parts_without(const std::vector<bool>& shown) const;
  [[nodiscard]] bool is_named_by_first_column() const;
  void add_part(const std::vector<bool>& shown, std::string& text) const;

  std::vector<std::vector<std::string>> rows_;
  std::size_t together_, screen_;
  std::vector<bool> numbers_;
};

/// Number of characters of a text of UTF-8 on the screen.
[[nodiscard]] std::size_t width_on_screen(const std::string& text);

/// A number with six significant digits, or a dash for NaN.
[[nodiscard]] std::string number_text(double value, int digits = 6);

/// A cell without a number.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// "12.3 %"; "0.005 %" if one decimal would show 0. Below 1e-9 there is only round-off.
[[nodiscard]] std::string percent(double share);

/// The value, or 0 if it is round-off of the largest of its kind.
[[nodiscard]] double without_round_off(double value, double largest);

}  // namespace trivet::documents
