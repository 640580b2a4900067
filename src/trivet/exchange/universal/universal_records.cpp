// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_records.h"

#include <fmt/format.h>

namespace trivet::exchange {
namespace {

/// The first part of a line that is not a finite number, or the line.
std::string_view wrong_part(std::string_view text) {
  for (const std::string_view part : blank_separated(text))
    if (!numbers_between_blanks(part)) return part;
  return text;
}

}  // namespace

std::vector<HeadLine> head_lines(const UniversalSet& set, std::size_t count) {
  std::vector<HeadLine> head;
  std::size_t end = 0;
  while (head.size() < count && end < set.body.size()) {
    const std::size_t begin = end;
    const std::size_t line_end = set.body.find('\n', begin);
    end = line_end == std::string_view::npos ? set.body.size() : line_end + 1;
    std::string_view text = set.body.substr(begin, end - begin);
    while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
    head.push_back({text, set.line + 1 + static_cast<int>(head.size()), end});
  }
  return head;
}

std::array<std::string, universal_id_lines> read_ids(const std::vector<HeadLine>& head, std::size_t present,
                                                     SetProblems& problems) {
  std::array<std::string, universal_id_lines> ids;
  if (present < universal_id_lines)
    problems.warning(head.front().line, "id lines", fmt::format("{} of {}", present, universal_id_lines),
                     "a set has five of them", "the others are read as NONE");
  for (std::size_t i = 0; i < present; ++i) {
    const std::string text = readable_line(head[i].text);
    if (trimmed(text).empty())
      problems.warning(head[i].line, "blank id line", "no text", "an id line without information has NONE",
                       "read as NONE");
    ids[i] = unless_none(text);
  }
  return ids;
}

std::optional<std::vector<double>> values_of_line(std::string_view text, int line, FieldWidths widths,
                                                  SetProblems& problems) {
  // Numbers without blanks between them are never one valid number, because each has its own decimal point.
  if (auto separated = numbers_between_blanks(text)) return separated;
  auto in_columns = numbers_in_columns(text, widths, BlankFields::end_the_line);
  if (in_columns)
    problems.warning(line, "values", "numbers without blanks between them", "numbers are separated by blanks",
                     "read in fixed columns");
  else
    problems.error(line, "values", in_quotes(wrong_part(text)),
                   "a line of values has finite numbers, in columns or with blanks",
                   "correct the line, or find the cause in the program that wrote it");
  return in_columns;
}

}  // namespace trivet::exchange
