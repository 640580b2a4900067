// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/matrix_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/exchange/named_matrix.h"
#include "trivet/exchange/text/text_lines.h"

namespace trivet::exchange {

namespace {

constexpr std::size_t small_width = 8, large_width = 16, small_fields = 8, large_fields = 4;

struct CardLine {
  std::string_view first;  ///< name or mark of continuation
  std::vector<std::string_view> fields;
};

CardLine free_fields(std::string_view line) {
  const auto parts = cells(line, ',');
  CardLine result{parts.front(), {}};
  const std::size_t count = result.first.find('*') != std::string_view::npos ? large_fields : small_fields;
  for (std::size_t i = 1; i <= count; ++i) result.fields.push_back(i < parts.size() ? parts[i] : std::string_view{});
  return result;
}

CardLine fixed_fields(std::string_view line) {
  CardLine result{trimmed(line.substr(0, small_width)), {}};
  const bool large = result.first.find('*') != std::string_view::npos;
  const std::size_t width = large ? large_width : small_width;
  for (std::size_t i = 0; i < (large ? large_fields : small_fields); ++i) {
    const std::size_t at = small_width + i * width;
    result.fields.push_back(at < line.size() ? trimmed(line.substr(at, width)) : std::string_view{});
  }
  return result;
}

bool is_continuation(std::string_view first) {
  return first.empty() || first.starts_with('+') || first.starts_with('*');
}

}  // namespace

std::string without_tabs(std::string_view text) {
  std::string result;
  std::size_t column = 0;
  for (const char c : text) {
    if (c == '\t') {
      const std::size_t blanks = small_width - column % small_width;
      result.append(blanks, ' ');
      column += blanks;
    } else {
      result += c;
      column = c == '\n' ? 0 : column + 1;
    }
  }
  return result;
}

std::vector<Card> bulk_cards(std::string_view text, std::string_view name) {
  std::vector<Card> cards;
  bool wanted = false;
  for (Lines lines(text); lines.next();) {
    const std::string_view line = lines.line().substr(0, lines.line().find('$'));
    if (trimmed(line).empty()) continue;
    const CardLine parts = line.find(',') != std::string_view::npos ? free_fields(line) : fixed_fields(line);
    if (!is_continuation(parts.first)) {
      const std::string card = lower(parts.first.substr(0, parts.first.find('*')));
      if (card == "enddata") break;
      wanted = card == name;
      if (wanted) cards.push_back({lines.number(), {}});
    }
    if (!wanted) continue;
    for (const std::string_view field : parts.fields) cards.back().fields.push_back({field, lines.number()});
  }
  return cards;
}

namespace {

/// Fields of the header card, after its name.
enum HeaderField { name_field, zero_field, form_field, type_field, output_field, polar_field, header_fields };
constexpr std::size_t first_entry = 4, fields_of_entry = 4;

struct DmigHeader {
  Triangles triangles = Triangles::both;
  bool is_complex = false;
  bool polar = false;
};

bool is_header(const Card& card) { return card.fields[zero_field].text == "0"; }

std::vector<std::string> names_of(const std::vector<Card>& cards) {
  std::vector<std::string> names;
  for (const Card& card : cards)
    if (const std::string name = lower(card.fields[name_field].text); std::ranges::find(names, name) == names.end())
      names.push_back(name);
  return names;
}

/// Name of the requested matrix, in lower case.
std::optional<std::string> chosen_name(const std::vector<std::string>& names, const std::string& wanted,
                                       FileProblems& problems) {
  std::string listed;
  for (const std::string& name : names)
    if (listed.size() < 200) listed += (listed.empty() ? "" : ", ") + name;
  if (names.empty()) {
    problems.error(0, "DMIG", "no such card", "a DMIG matrix is a header card and one card per column",
                   "write the matrices to a punch file in that program");
  } else if (wanted.empty() && names.size() > 1) {
    problems.error(0, "name", fmt::format("the file has {} matrices: {}", names.size(), listed),
                   "one of them is the stiffness", "name it");
  } else if (!wanted.empty() && std::ranges::find(names, lower(wanted)) == names.end()) {
    const std::string near = foundation::nearest_name(lower(wanted), names);
    problems.error(0, "name", in_quotes(wanted), "the file has " + listed,
                   near.empty() ? "name one of these" : fmt::format("did you mean \"{}\"?", near));
  } else {
    return wanted.empty() ? names.front() : lower(wanted);
  }
  return std::nullopt;
}

std::optional<DmigHeader> read_header(const Card& card, FileProblems& problems) {
  const auto field = [&](std::size_t i) {
    return i < card.fields.size() ? whole_number(card.fields[i].text) : std::nullopt;
  };
  const int form = field(form_field).value_or(0), type = field(type_field).value_or(0),
            polar = field(polar_field).value_or(0);
  if (form != 1 && form != 6)
    problems.error(card.line, "IFO", in_quotes(card.fields[form_field].text),
                   "a stiffness is square (1) or symmetric (6)", "is this the right matrix?");
  if (type < 1 || type > 4)
    problems.error(card.line, "TIN", in_quotes(card.fields[type_field].text),
                   "it is 1 or 2 for real, 3 or 4 for complex numbers", "correct the header card");
  if (polar < 0 || polar > 1)
    problems.error(card.line, "POLAR", fmt::format("{}", polar), "it is 0 or 1", "correct the header card");
  if (problems.any()) return std::nullopt;
  return DmigHeader{form == 6 ? Triangles::one : Triangles::both, type > 2, polar == 1};
}

std::optional<Label> label(const Field& point, const Field& component, FileProblems& problems) {
  const auto node = whole_number(point.text);
  const auto number = component.text.empty() ? std::optional(0) : whole_number(component.text);
  if (node && *node > 0 && number && *number >= 0 && *number <= 6) return Label{*node, *number};
  problems.error(point.line, "grid point",
                 fmt::format("{}, component {}", in_quotes(point.text), in_quotes(component.text)),
                 "a grid point is a number above 0, its component 1 to 6, or blank for a scalar point",
                 "correct the card, and check its columns");
  return std::nullopt;
}

void read_column(const Card& card, const DmigHeader& header, std::vector<LabelledEntry>& entries,
                 FileProblems& problems) {
  const auto column = label(card.fields[1], card.fields[2], problems);
  if (!column) return;
  for (std::size_t at = first_entry; at + fields_of_entry <= card.fields.size() && !problems.enough();
       at += fields_of_entry) {
    const Field* field = &card.fields[at];
    if (std::all_of(field, field + fields_of_entry, [](const Field& f) { return f.text.empty(); })) continue;
    const auto row = label(field[0], field[1], problems);
    const auto first = fortran_number(field[2].text);
    const auto second = field[3].text.empty() ? std::optional(0.0) : fortran_number(field[3].text);
    if (!first || !second) {
      problems.error(field->line, "entry", in_quotes(first ? field[3].text : field[2].text),
                     "it must be a finite number", "correct the card, and check its columns");
    } else if (!header.is_complex && *second != 0) {
      problems.error(field->line, "entry", fmt::format("imaginary part {:.9g}", *second),
                     "the header declares the matrix as real (TIN)", "correct the header card, and check the columns");
    } else if (row) {
      const double phase = *second * std::numbers::pi / 180;
      entries.push_back({*row,
                         *column,
                         {0, 0, header.polar ? *first * std::cos(phase) : *first,
                          header.polar ? *first * std::sin(phase) : *second, field->line}});
    }
  }
}

}  // namespace

foundation::Expected<NamedMatrix> read_nastran_dmig(std::string_view given, const std::string& source,
                                                    const std::string& wanted) {
  FileProblems problems(source);
  const std::string text = without_tabs(given);
  std::vector<Card> cards = bulk_cards(text, "dmig");
  const auto name = chosen_name(names_of(cards), wanted, problems);
  if (!name) return problems.refused();
  std::erase_if(cards, [&](const Card& card) { return lower(card.fields[name_field].text) != *name; });
  if (!is_header(cards.front())) {
    problems.error(cards.front().line, "DMIG", "a column card of " + in_quotes(*name), "its header card comes first",
                   "was the file cut off?");
    return problems.refused();
  }
  const auto header = read_header(cards.front(), problems);
  std::vector<LabelledEntry> entries;
  for (std::size_t i = 1; header && i < cards.size() && !problems.enough(); ++i) {
    if (is_header(cards[i]))
      problems.error(cards[i].line, "DMIG", "a second header card of " + in_quotes(*name), "a matrix has one",
                     "remove one of the two matrices");
    else read_column(cards[i], *header, entries, problems);
  }
  if (problems.any()) return problems.refused();
  auto matrix = assembled(entries, header->triangles, header->is_complex, cards.front().line, problems);
  if (!matrix) return problems.refused();
  return std::move(*matrix);
}

}  // namespace trivet::exchange
