// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/problem_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/message_list.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::engine {
namespace {

/// A line of the file, without a line break; empty if it cannot be read.
std::string line_of(const foundation::Origin& origin, const Source& source) {
  std::ifstream file;
  std::istringstream given;
  const bool is_given = source.text && origin.source == source.name;
  if (is_given) given.str(*source.text);
  else file.open(origin.source);
  std::istream& stream = is_given ? static_cast<std::istream&>(given) : file;
  std::string line;
  for (int number = 0; number < origin.line; ++number)
    if (!std::getline(stream, line)) return "";
  return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

/// The place of the value of the key that ends the subject; npos if the line has the key not once.
std::size_t value_of_key(const std::string& line, const std::string& subject) {
  const std::string key = subject.substr(subject.rfind('.') + 1);
  std::size_t found = std::string::npos;
  if (key.empty()) return found;
  for (std::size_t at = line.find(key); at != std::string::npos; at = line.find(key, at + 1)) {
    const bool begins = at == 0 || std::string_view(" \t{,.\"").find(line[at - 1]) != std::string_view::npos;
    const std::size_t equals = line.find_first_not_of(" \t\"", at + key.size());
    if (!begins || equals == std::string::npos || line[equals] != '=') continue;
    if (found != std::string::npos) return std::string::npos;  // one of several values: the line is marked
    found = line.find_first_not_of(" \t", equals + 1);
  }
  return found;
}

/// One past the end of a value of TOML that begins there.
std::size_t end_of_value(const std::string& line, std::size_t begin) {
  char quote = '\0';
  int depth = 0;
  std::size_t end = begin;
  for (; end < line.size(); ++end) {
    const char c = line[end];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
      continue;
    }
    if (c == '"' || c == '\'') quote = c;
    else if (c == '[' || c == '{') ++depth;
    else if ((c == ']' || c == '}') && --depth <= 0) return depth < 0 ? end : end + 1;
    else if ((c == ',' && depth == 0) || c == '#') break;
  }
  return line.find_last_not_of(" \t", end - 1) + 1;
}

/// The line, and carets below the value of the problem or, if the line has none, below its text.
std::string marked_line(const foundation::Problem& problem, const Source& source) {
  constexpr std::size_t longest = 160;
  const std::string line = line_of(problem.origin, source);
  if (line.empty() || line.size() > longest) return "";
  std::size_t begin = value_of_key(line, problem.subject);
  const bool has_value = begin != std::string::npos;
  if (!has_value) begin = line.find_first_not_of(" \t");
  const std::size_t end = has_value ? std::max(end_of_value(line, begin), begin + 1) : line.size();
  const std::string number = std::to_string(problem.origin.line);
  const auto width = [](const std::string& text) { return documents::width_on_screen(foundation::on_one_line(text)); };
  return fmt::format("  {} | {}\n  {} | {}{}\n", number, foundation::on_one_line(line), std::string(number.size(), ' '),
                     std::string(width(line.substr(0, begin)), ' '),
                     std::string(width(line.substr(begin, end - begin)), '^'));
}

}  // namespace

std::string message_list_with_lines(const foundation::Problems& problems, const Source& source) {
  constexpr std::size_t most_with_lines = 10;
  if (problems.list().size() > most_with_lines) return foundation::message_list(problems);
  std::string text;
  for (const foundation::Problem& problem : problems.list()) {
    text += foundation::message(problem) + "\n";
    if (problem.origin.line > 0 && !problem.origin.source.empty()) text += marked_line(problem, source);
  }
  return text;
}

}  // namespace trivet::engine
