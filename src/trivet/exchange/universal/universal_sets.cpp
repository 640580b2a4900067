// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

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

namespace {

constexpr std::string_view standard_delimiter = "    -1";
constexpr std::size_t type_width = 6;
constexpr int largest_set_type = 99999;
constexpr std::array read_set_types{15, 18, 55, 58, 82, 151, 164, 2411, 2414, 2420};

struct SetType {
  int number = 0;
  bool binary = false;
};

/// "58" or "58b" at the beginning of a line.
std::optional<SetType> set_type(std::string_view line) {
  const auto parts = blank_separated(line);
  if (parts.empty()) return std::nullopt;
  std::string_view text = parts.front();
  const bool binary = text.ends_with('b') || text.ends_with('B');
  if (binary) text.remove_suffix(1);
  const auto number = whole_number(text);
  if (!number || *number < 1 || *number > largest_set_type) return std::nullopt;
  return SetType{*number, binary};
}

/// A type in its columns, with nothing else in the line except for a binary set: hardly a comment.
bool is_type_line(std::string_view line) {
  const auto type = set_type(line);
  if (!type || line.size() < type_width) return false;
  const bool in_columns = std::isdigit(static_cast<unsigned char>(line[type_width - 1])) != 0;
  return in_columns && (type->binary || trimmed(line.substr(type_width)).empty());
}

bool is_read(int type) { return std::ranges::find(read_set_types, type) != read_set_types.end(); }

std::string_view without_line_end(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

SetProblems::SetProblems(FileProblems& problems, const UniversalSet& set)
    : problems_(problems), name_(fmt::format("set {} (type {}{}), ", set.number, set.type, set.binary ? "b" : "")) {}

void SetProblems::error(int line, const std::string& what, std::string finding, std::string rule, std::string remedy) {
  ++errors_;
  problems_.error(line, name_ + what, std::move(finding), std::move(rule), std::move(remedy));
}

void SetProblems::warning(int line, const std::string& what, std::string finding, std::string rule,
                          std::string remedy) {
  if (!reported_.insert(what).second) return;
  problems_.warning(line, name_ + what, std::move(finding), std::move(rule), std::move(remedy));
}

bool is_delimiter(std::string_view line) { return trimmed(line) == "-1"; }

std::string_view SetScanner::next_line() {
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end == std::string_view::npos ? end : end + 1);
  rest_.remove_prefix(line.size());
  ++line_;
  return without_line_end(line);
}

std::optional<UniversalSet> SetScanner::next() {
  std::string_view opening;
  while (!rest_.empty()) {
    const std::string_view line = next_line();
    if (trimmed(line).empty()) continue;
    if (is_delimiter(line)) {
      found_delimiter_ = true;
      opening = line;
      continue;
    }
    const bool not_opened = opening.empty();
    if (not_opened && !(just_closed_ && is_type_line(line))) {
      just_closed_ = false;
      if (!first_comment_) first_comment_ = TextLine{line, line_};
      continue;
    }
    just_closed_ = false;
    auto set = begin_set(line);
    if (set && not_opened)
      problems_.warning(line_ - 1, fmt::format("set {} (type {})", set->number, set->type),
                        "one line with -1 before it", "one such line closes a set and another opens the next",
                        "read as both; check that the set before it is complete");
    if (set && !set->binary) find_end(*set, not_opened ? standard_delimiter : opening);
    if (set) return set;
    opening = {};
  }
  return std::nullopt;
}

std::optional<UniversalSet> SetScanner::begin_set(std::string_view line) {
  ++sets_;
  const auto type = set_type(line);
  if (!type) {
    problems_.error(line_, fmt::format("set {}", sets_), in_quotes(line),
                    "the line after the opening -1 has the type of the set, 58 for example",
                    "was a line with -1 lost or added?");
    return std::nullopt;
  }
  return UniversalSet{
      .number = sets_, .type = type->number, .binary = type->binary, .line = line_, .type_line = line, .body = rest_};
}

void SetScanner::find_end(UniversalSet& set, std::string_view opening) {
  const std::string_view body = rest_;
  while (!rest_.empty()) {
    const std::size_t length = body.size() - rest_.size();
    const std::string_view line = next_line();
    const bool in_columns = line.starts_with(standard_delimiter);
    // Other sets may have a record with the only number -1 in other columns.
    if (!is_delimiter(line) || (!in_columns && !is_read(set.type) && line != opening)) continue;
    set.body = body.substr(0, length);
    just_closed_ = true;
    if (!in_columns || !opening.starts_with(standard_delimiter))
      SetProblems(problems_, set)
          .warning(in_columns ? set.line - 1 : line_, "delimiter", "-1 is in other columns", "it is in columns 5 and 6",
                   "read as a delimiter");
    return;
  }
  set.closed = false;
}

void SetScanner::continue_after(const UniversalSet& binary_set, std::size_t bytes_of_body) {
  const std::string_view passed = binary_set.body.substr(0, bytes_of_body);
  line_ = binary_set.line + static_cast<int>(std::ranges::count(passed, '\n'));
  rest_ = binary_set.body.substr(passed.size());
  just_closed_ = true;
}

}  // namespace trivet::exchange
