// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_functions.h"

#include <fmt/format.h>

#include "trivet/exchange/universal/universal_descriptions.h"
#include "trivet/exchange/universal/universal_function_head.h"
#include "trivet/exchange/universal/universal_function_values.h"

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

}  // namespace trivet::exchange
