// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_functions.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "trivet/exchange/universal/universal_descriptions.h"
#include "trivet/exchange/universal/universal_function_values.h"
#include "trivet/exchange/universal/universal_sets.h"

namespace trivet::exchange {

namespace {

/// Distributes the numbers of the file to abscissa and values.
void distribute(const std::vector<double>& numbers, UniversalFunction& function) {
  const std::size_t per_point = numbers_per_point(function);
  auto* abscissa = std::get_if<std::vector<double>>(&function.abscissa);
  const std::size_t value_at = abscissa ? 1 : 0;
  function.values.reserve(numbers.size() / per_point);
  if (abscissa) abscissa->reserve(numbers.size() / per_point);
  for (std::size_t i = 0; i < numbers.size(); i += per_point) {
    if (abscissa) abscissa->push_back(numbers[i]);
    function.values.emplace_back(numbers[i + value_at], function.is_complex ? numbers[i + value_at + 1] : 0.0);
  }
}

/// An orbit, or a curve over rpm or force, may go back; time and frequency may not.
void check_abscissa(const UniversalFunction& function, int line, SetProblems& problems) {
  const auto* abscissa = std::get_if<std::vector<double>>(&function.abscissa);
  const UniversalQuantity quantity = function.abscissa_axis.quantity;
  if (!abscissa || (quantity != UniversalQuantity::time && quantity != UniversalQuantity::frequency)) return;
  for (std::size_t i = 1; i < abscissa->size(); ++i) {
    if ((*abscissa)[i] > (*abscissa)[i - 1]) continue;
    problems.error(line, "abscissa",
                   fmt::format("{:.9g} at point {} after {:.9g}", (*abscissa)[i], i + 1, (*abscissa)[i - 1]),
                   "times and frequencies increase",
                   "in text form they have six digits: export with even spacing, or in binary form");
    return;
  }
}

}  // namespace

UniversalFunctionSet read_universal_function(const UniversalSet& set, const std::optional<UniversalUnits>& units,
                                             SetProblems& problems) {
  auto head = read_function_head(set, problems);
  if (!head) return {};
  UniversalFunctionSet result;
  std::optional<std::vector<double>> numbers;
  if (set.binary) {
    auto binary = read_binary_values(set, *head, problems);
    if (!binary) return {};
    result.end = binary->end;
    numbers = std::move(binary->numbers);
  } else {
    numbers = read_text_values(set, *head, problems);
    if (!numbers) return {};
    check_end(set, problems);
  }
  head->function.line = set.line;
  distribute(*numbers, head->function);
  check_abscissa(head->function, head->points_line, problems);
  convert_to_si(head->function, units, head->points_line, problems);
  if (!problems.any()) result.function = std::move(head->function);
  return result;
}

namespace {

constexpr std::size_t records_after_ids = 6;
constexpr std::array form_widths{10, 10, 10, 13, 13, 13};
constexpr int largest_function_type = 27;
constexpr double largest_point_count = 1e15;

struct Columns {
  std::size_t first = 0, width = 0;
};
/// Record 6: type, identifier, version, load case, name, node and direction of the response and of the reference.
constexpr std::array<Columns, 10> place_columns{
    {{0, 5}, {5, 10}, {15, 5}, {20, 10}, {31, 10}, {41, 10}, {51, 4}, {56, 10}, {66, 10}, {76, 4}}};
constexpr std::size_t response_name = 4, reference_name = 7;
/// Records 8 to 11: quantity, powers of length, force and temperature.
constexpr std::array<Columns, 4> axis_number_columns{{{0, 10}, {10, 5}, {15, 5}, {20, 5}}};
constexpr Columns axis_label{26, 20}, axis_unit{47, 20};

bool is_name(std::size_t field) { return field == response_name || field == reference_name; }

/// Record 6.
struct FunctionPlace {
  std::array<int, 10> numbers{};
  UniversalPoint response, reference;
  bool in_columns = true;
};

/// Record 7.
struct DataForm {
  int ordinate_type = 0, spacing = 0;
  double points = 0, first = 0, step = 0, z_value = 0;
};

std::optional<int> whole_or_blank(std::string_view field) {
  return field.empty() ? std::optional(0) : whole_number(field);
}

FunctionPlace named(FunctionPlace place, std::string_view response, std::string_view reference) {
  const std::array<int, 10>& n = place.numbers;
  place.response = {unless_none(response), n[response_name + 1], n[response_name + 2]};
  place.reference = {unless_none(reference), n[reference_name + 1], n[reference_name + 2]};
  return place;
}

/// A number that does not end at the end of its columns: the line is probably shifted, or free.
bool ends_before_its_columns(std::string_view line, const Columns& columns) {
  const std::string_view last = text_in_columns(line, columns.first + columns.width - 1, 1);
  return last.empty() && !text_in_columns(line, columns.first, columns.width).empty();
}

std::optional<FunctionPlace> place_in_columns(std::string_view line) {
  FunctionPlace place;
  for (std::size_t i = 0; i < place_columns.size(); ++i) {
    if (is_name(i)) continue;
    const auto value = whole_or_blank(text_in_columns(line, place_columns[i].first, place_columns[i].width));
    if (!value) return std::nullopt;
    place.numbers[i] = *value;
    if (ends_before_its_columns(line, place_columns[i])) place.in_columns = false;
  }
  const auto name = [&](std::size_t i) {
    return text_in_columns(line, place_columns[i].first, place_columns[i].width);
  };
  return named(std::move(place), name(response_name), name(reference_name));
}

std::optional<FunctionPlace> place_between_blanks(std::string_view line) {
  const auto parts = blank_separated(line);
  FunctionPlace place{.in_columns = false};
  if (parts.size() != place_columns.size()) return std::nullopt;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_name(i)) continue;
    const auto value = whole_number(parts[i]);
    if (!value) return std::nullopt;
    place.numbers[i] = *value;
  }
  return named(std::move(place), parts[response_name], parts[reference_name]);
}

std::optional<FunctionPlace> function_place(std::string_view line) {
  if (trimmed(line).empty()) return std::nullopt;
  auto in_columns = place_in_columns(line);
  if (in_columns && in_columns->in_columns) return in_columns;
  auto separated = place_between_blanks(line);
  return separated ? separated : in_columns;
}

std::optional<DataForm> data_form(std::string_view line) {
  const auto numbers = numbers_of_record(line, form_widths, 3);
  if (!numbers) return std::nullopt;
  const std::vector<double>& n = *numbers;
  const auto type = as_whole_number(n[0]), spacing = as_whole_number(n[2]);
  if (!type || !spacing || *spacing < 0 || *spacing > 1 || n[1] != std::floor(n[1])) return std::nullopt;
  return DataForm{*type, *spacing, n[1], n[3], n[4], n[5]};
}

/// Number of id lines before records 6 and 7: five, or fewer if the file lacks some.
std::optional<std::size_t> id_lines_before_place(const std::vector<HeadLine>& head) {
  for (std::size_t ids = universal_id_lines + 1; ids-- > 0;)
    if (ids + 1 < head.size() && function_place(readable_line(head[ids].text)) && data_form(head[ids + 1].text))
      return ids;
  return std::nullopt;
}

void report_head(const UniversalSet& set, const std::vector<HeadLine>& head, SetProblems& problems) {
  if (head.size() < universal_id_lines + records_after_ids) {
    problems.error(set.line, "head", fmt::format("{} lines", head.size()), "eleven lines precede the values",
                   "was the file cut off?");
    return;
  }
  const bool place_is_right = function_place(readable_line(head[universal_id_lines].text)).has_value();
  const HeadLine& wrong = head[universal_id_lines + (place_is_right ? 1 : 0)];
  problems.error(wrong.line, place_is_right ? "record 7" : "record 6", in_quotes(wrong.text),
                 place_is_right ? "it has the type of the ordinates, the number of points, the spacing (0 or 1), the "
                                  "first abscissa, the step and z"
                                : "it has the type of the function, and node and direction of response and reference",
                 "correct the line, and check its columns");
}

std::optional<UniversalAxis> axis_of(std::string_view text) {
  std::array<int, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto value =
        whole_or_blank(text_in_columns(text, axis_number_columns[i].first, axis_number_columns[i].width));
    if (!value || (i > 0 && std::abs(*value) > 9)) return std::nullopt;
    numbers[i] = *value;
  }
  return UniversalAxis{static_cast<UniversalQuantity>(numbers[0]),
                       {numbers[1], numbers[2], numbers[3]},
                       unless_none(text_in_columns(text, axis_label.first, axis_label.width)),
                       unless_none(text_in_columns(text, axis_unit.first, axis_unit.width))};
}

/// Records 8 to 11.
bool read_axes(const std::vector<HeadLine>& lines, std::size_t first, UniversalFunction& function,
               SetProblems& problems) {
  UniversalAxis* axes[] = {&function.abscissa_axis, &function.numerator, &function.denominator, &function.z_axis};
  for (std::size_t i = 0; i < std::size(axes); ++i) {
    const std::string text = readable_line(lines[first + i].text);
    const auto axis = axis_of(text);
    if (!axis) {
      problems.error(lines[first + i].line, fmt::format("record {}", 8 + i), in_quotes(text),
                     "an axis has a quantity, three powers from -9 to 9 and two labels",
                     "correct the line, and check its columns");
      return false;
    }
    *axes[i] = *axis;
  }
  return true;
}

bool apply_form(const DataForm& form, const HeadLine& line, UniversalFunction& function, SetProblems& problems) {
  const int type = form.ordinate_type;
  if (type != 2 && type != 4 && type != 5 && type != 6) {
    problems.error(line.line, "ordinate type", fmt::format("{}", type),
                   "2 and 4 are real, 5 and 6 complex, in single and double precision", "correct the line");
  } else if (form.points < 1 || form.points > largest_point_count) {
    problems.error(line.line, "points", fmt::format("{:.0f}", form.points), "a function has at least one point",
                   "correct the line, or remove the set");
  } else if (form.spacing == 1 && form.points > 1 && !(form.step > 0)) {
    problems.error(line.line, "step", fmt::format("{:.9g}", form.step), "the step of an even abscissa is > 0",
                   "correct the line");
  } else {
    function.is_complex = type > 4;
    function.precision =
        type == 2 || type == 5 ? UniversalPrecision::single_precision : UniversalPrecision::double_precision;
    if (form.spacing == 1) function.abscissa = EvenAbscissa{form.first, form.step};
    else function.abscissa = std::vector<double>();
    function.z_value = form.z_value;
    return true;
  }
  return false;
}

void apply_place(const FunctionPlace& place, const HeadLine& line, UniversalFunction& function, SetProblems& problems) {
  const std::array<int, 10>& n = place.numbers;
  function.type = static_cast<UniversalFunctionType>(n[0]);
  function.identifier = n[1];
  function.version = n[2];
  function.load_case = n[3];
  function.response = place.response;
  function.reference = place.reference;
  if (!place.in_columns)
    problems.warning(line.line, "record 6", in_quotes(line.text), "its numbers end in columns 5, 15, 20, 30, 51, 55",
                     "read by the blanks between them; check node and direction");
  if (n[0] < 0 || n[0] > largest_function_type)
    problems.warning(line.line, "function type", fmt::format("{}", n[0]), "the types are 0 to 27", "kept as a number");
}

}  // namespace

std::optional<FunctionHead> read_function_head(const UniversalSet& set, SetProblems& problems) {
  const auto lines = head_lines(set, universal_id_lines + records_after_ids);
  const auto ids = id_lines_before_place(lines);
  if (!ids || lines.size() < *ids + records_after_ids) {
    report_head(set, lines, problems);
    return std::nullopt;
  }
  FunctionHead head;
  head.function.ids = read_ids(lines, *ids, problems);
  const HeadLine& place_line = lines[*ids];
  const HeadLine& form_line = lines[*ids + 1];
  apply_place(*function_place(readable_line(place_line.text)), place_line, head.function, problems);
  const DataForm form = *data_form(form_line.text);
  if (!apply_form(form, form_line, head.function, problems)) return std::nullopt;
  if (!read_axes(lines, *ids + 2, head.function, problems)) return std::nullopt;
  const HeadLine& last = lines[*ids + records_after_ids - 1];
  head.points = static_cast<std::size_t>(form.points);
  head.points_line = form_line.line;
  head.values_at = last.end;
  head.last_line = last.line;
  return head;
}

}  // namespace trivet::exchange
