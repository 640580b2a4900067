// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/abaqus_matrix.h"

#include "trivet/exchange/matrix_entries.h"
#include "trivet/exchange/user_element.h"

namespace trivet::exchange {
namespace {

/// Numbers between commas or blanks.
std::vector<std::string_view> fields(std::string_view line) {
  return line.find(',') == std::string_view::npos ? blank_separated(line) : cells(line, ',');
}

std::optional<LabelledEntry> read_entry(std::string_view line, int number, FileProblems& problems) {
  auto parts = fields(line);
  if (!parts.empty() && parts.back().empty()) parts.pop_back();
  std::optional<int> place[4];
  for (std::size_t i = 0; i < 4 && i < parts.size(); ++i) place[i] = whole_number(parts[i]);
  const auto value = parts.size() == 5 ? fortran_number(parts[4]) : std::nullopt;
  if (!value || !place[0] || !place[1] || !place[2] || !place[3]) {
    problems.error(number, "entry", in_quotes(line),
                   "an entry is row node, row component, column node, column component, finite number",
                   "write it in Abaqus with FORMAT=MATRIX INPUT, which names the nodes");
    return std::nullopt;
  }
  for (const int i : {1, 3})
    if (*place[i] < 1 || *place[i] > 6) {
      problems.error(number, "component", std::to_string(*place[i]),
                     "components are 1 to 6 (translations, then rotations)",
                     "remove temperatures, pressures and warping from the model");
      return std::nullopt;
    }
  return LabelledEntry{{*place[0], *place[1]}, {*place[2], *place[3]}, {0, 0, *value, 0, number}};
}

foundation::Expected<NamedMatrix> read_matrix_input(std::string_view text, FileProblems& problems) {
  std::vector<LabelledEntry> entries;
  int last = 0;
  for (Lines lines(text); !problems.enough() && lines.next();) {
    if (trimmed(lines.line()).empty() || lines.line().starts_with('*')) continue;
    last = lines.number();
    if (const auto entry = read_entry(lines.line(), last, problems)) entries.push_back(*entry);
  }
  if (problems.any()) return problems.refused();
  auto matrix = assembled(entries, std::nullopt, false, last, problems);
  if (!matrix) return problems.refused();
  return std::move(*matrix);
}

bool has_user_element(std::string_view text) {
  for (Lines lines(text); lines.next();)
    if (lower(lines.line().substr(0, 5)) == "*user") return true;
  return false;
}

}  // namespace

foundation::Expected<NamedMatrix> read_abaqus_matrix(std::string_view text, const std::string& source,
                                                     const std::string& type) {
  FileProblems problems(source);
  return has_user_element(text) ? read_user_element(text, lower(type), problems) : read_matrix_input(text, problems);
}

}  // namespace trivet::exchange
