// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_descriptions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/exchange/universal/universal_lines.h"

namespace trivet::exchange {
namespace {

constexpr std::size_t date_width = 10, code_width = 10, description_width = 20;
constexpr std::array factor_widths{25, 25, 25};

struct CodeFactors {
  double length = 0, force = 0;
};
/// Factors of the codes 1 to 8 and 10; code 9 has any.
constexpr std::array<CodeFactors, 11> factors_of_codes{{{},
                                                        {1, 1},
                                                        {3.280839895, 0.2248089431},
                                                        {1, 0.1019716213},
                                                        {3.280839895, 7.233013851},
                                                        {1e3, 1e3},
                                                        {1e2, 1e2},
                                                        {39.37007874, 0.2248089431},
                                                        {1e3, 0.1019716213},
                                                        {},
                                                        {1e3, 1}}};
/// Some programs round the factors.
constexpr double rounded_factors = 1e-3;
/// Beyond this the factor is a mistake.
constexpr double largest_factor = 1e9;

bool is_factor(double value) { return value >= 1 / largest_factor && value <= largest_factor; }

std::string date_and_time(std::string_view line) {
  const std::string date = unless_none(text_in_columns(line, 0, date_width));
  const std::string time = unless_none(text_in_columns(line, date_width, date_width));
  return date.empty() || time.empty() ? date + time : date + " " + time;
}

/// The numbers of all remaining lines, without blanks in columns of D25.17.
std::optional<std::vector<double>> factors(Lines& lines) {
  std::vector<double> numbers;
  while (lines.next()) {
    auto line = numbers_between_blanks(lines.line());
    if (!line) line = numbers_in_columns(lines.line(), factor_widths, BlankFields::end_the_line);
    if (!line) return std::nullopt;
    numbers.insert(numbers.end(), line->begin(), line->end());
  }
  return numbers;
}

/// The fourth number is the offset of the temperature.
std::ptrdiff_t factor_count(const std::vector<double>& numbers) {
  return std::min<std::ptrdiff_t>(3, std::ssize(numbers));
}

void warn_if_code_disagrees(const UniversalUnits& units, int line, SetProblems& problems) {
  if (units.code < 1 || units.code >= static_cast<int>(factors_of_codes.size())) return;
  const CodeFactors& standard = factors_of_codes[static_cast<std::size_t>(units.code)];
  const auto differs = [](double factor, double wanted) {
    return std::abs(factor - wanted) > rounded_factors * wanted;
  };
  if (standard.length == 0 || (!differs(units.length, standard.length) && !differs(units.force, standard.force)))
    return;
  problems.warning(line, "units",
                   fmt::format("code {} with the factors {:.9g} and {:.9g}", units.code, units.length, units.force),
                   fmt::format("this code has {:.9g} and {:.9g}", standard.length, standard.force),
                   "the factors are used; check the numbers");
}

}  // namespace

void check_end(const UniversalSet& set, SetProblems& problems) {
  if (set.closed) return;
  if (set.body.ends_with('\n'))
    problems.warning(set.line, "end", "no closing line with -1", "such a line ends a set",
                     "its content is read to the end of the file; was the file cut off?");
  else
    problems.error(set.line, "end", "the file ends within a line", "a line with -1 ends a set",
                   "was the file cut off?");
}

UniversalHeader read_universal_header(const UniversalSet& set, SetProblems& problems) {
  std::array<std::string, 7> text;
  Lines lines(set.body);
  for (std::size_t i = 0; i < text.size() && lines.next(); ++i) text[i] = readable_line(lines.line());
  check_end(set, problems);
  return {.model = unless_none(text[0]),
          .description = unless_none(text[1]),
          .database_program = unless_none(text[2]),
          .created = date_and_time(text[3]),
          .saved = date_and_time(text[4]),
          .program = unless_none(text[5]),
          .written = date_and_time(text[6])};
}

std::optional<UniversalUnits> read_universal_units(const UniversalSet& set, SetProblems& problems) {
  Lines lines(set.body);
  const std::string first = lines.next() ? readable_line(lines.line()) : std::string();
  UniversalUnits units;
  units.code = whole_number(text_in_columns(first, 0, code_width)).value_or(0);
  units.description = unless_none(text_in_columns(first, code_width, description_width));
  units.temperature_mode = whole_number(text_in_columns(first, code_width + description_width, code_width)).value_or(0);
  const auto read = factors(lines);
  const int line = set.line + 2;
  if (!read || read->size() < 2 || !std::all_of(read->begin(), read->begin() + factor_count(*read), is_factor)) {
    problems.error(line, "factors", read ? fmt::format("{}", fmt::join(*read, ", ")) : std::string("not a number"),
                   "the factors of length, force and temperature are numbers from 1e-9 to 1e9",
                   "correct the set, or remove it");
    return std::nullopt;
  }
  units.length = (*read)[0];
  units.force = (*read)[1];
  units.temperature = read->size() > 2 ? (*read)[2] : 1;
  units.temperature_offset = read->size() > 3 ? (*read)[3] : 0;
  warn_if_code_disagrees(units, line, problems);
  check_end(set, problems);
  return units;
}

}  // namespace trivet::exchange
