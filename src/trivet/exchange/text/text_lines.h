// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::exchange {

/// Iterates over the lines of a text, numbered from 1; both kinds of line ends are removed.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  /// False at the end of the text.
  bool next();
  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] int number() const { return number_; }

 private:
  std::string_view rest_, line_;
  int number_ = 0;
};

/// A text whose lines end with carriage returns alone, as old programs write them, with line feeds instead; any other
/// text as it is.
[[nodiscard]] std::string with_line_feeds(std::string text);

[[nodiscard]] std::string_view trimmed(std::string_view text);
/// The parts between runs of blanks and tabs.
[[nodiscard]] std::vector<std::string_view> blank_separated(std::string_view line);
/// The trimmed parts between separators, including empty ones; none for a blank line.
[[nodiscard]] std::vector<std::string_view> cells(std::string_view line, char separator);
[[nodiscard]] std::string lower(std::string_view text);
/// At most 40 bytes of a text, in quotes, for a message.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The number if the whole text is one finite number.
[[nodiscard]] std::optional<double> number(std::string_view text);
/// The same in Fortran notation: also 1.5D+03 and 1.5+3.
[[nodiscard]] std::optional<double> fortran_number(std::string_view text);
[[nodiscard]] std::optional<int> whole_number(std::string_view text);

/// Problems of one file. After ten errors further ones are mostly consequences, and reading should stop.
class FileProblems {
 public:
  explicit FileProblems(std::string source) : source_(std::move(source)) {}
  void error(int line, std::string subject, std::string finding, std::string rule, std::string remedy);
  void warning(int line, std::string subject, std::string finding, std::string rule, std::string remedy);
  [[nodiscard]] bool any() const { return errors_ > 0; }
  [[nodiscard]] bool enough() const { return errors_ >= 10; }
  [[nodiscard]] const foundation::Problems& all() const { return problems_; }
  [[nodiscard]] tl::unexpected<foundation::Problems> refused() const { return tl::make_unexpected(problems_); }

 private:
  std::string source_;
  foundation::Problems problems_;
  int errors_ = 0;
};

}  // namespace trivet::exchange
