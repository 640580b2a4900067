// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/universal_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "trivet/foundation/plain_text.h"
#include "trivet/model/system.h"

namespace trivet::project {

std::string point_name(const exchange::UniversalPoint& point) {
  const int direction = std::abs(point.direction);
  if (direction < 1 || direction > 6) return fmt::format("{}:scalar", point.node);
  return fmt::format("{}:{}{}", point.node, point.direction < 0 ? "-" : "+", model::coordinate_names[direction - 1]);
}

std::string universal_kind(const exchange::UniversalFunction& function) {
  using enum exchange::UniversalFunctionType;
  static const std::map<exchange::UniversalFunctionType, const char*> names = {
      {time_response, "time response"},
      {auto_spectrum, "auto spectrum"},
      {cross_spectrum, "cross spectrum"},
      {frequency_response, "frequency response"},
      {transmissibility, "transmissibility"},
      {coherence, "coherence"},
      {auto_correlation, "auto correlation"},
      {cross_correlation, "cross correlation"},
      {power_spectral_density, "power spectral density"},
      {energy_spectral_density, "energy spectral density"},
      {spectrum, "spectrum"},
      {shock_response_spectrum, "shock response spectrum"},
      {order_function, "order function"},
  };
  const auto name = names.find(function.type);
  const std::string kind = name == names.end() ? "function" : name->second;
  const std::string type = fmt::format("{} (type {})", kind, static_cast<int>(function.type));
  if (may_be_over_frequency(function)) return type;
  return fmt::format("{} over an abscissa of type {}", type, static_cast<int>(function.abscissa_axis.quantity));
}

std::string universal_kinds(const std::vector<exchange::UniversalFunction>& functions) {
  std::map<std::string, std::size_t> kinds;
  for (const exchange::UniversalFunction& function : functions) ++kinds[universal_kind(function)];
  std::vector<std::string> words;
  for (const auto& [kind, count] : kinds) words.push_back(fmt::format("{} × {}", count, kind));
  return words.empty() ? "no functions" : foundation::comma_separated(words);
}

namespace {

using exchange::UniversalFunction;
using exchange::UniversalQuantity;

std::string in_small_letters(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

enum class Evidence { frequency, none, other };

/// What the labels of an axis of unknown quantity say.
Evidence evidence(const exchange::UniversalAxis& axis) {
  if (!axis.unit.empty()) return in_small_letters(axis.unit) == "hz" ? Evidence::frequency : Evidence::other;
  return in_small_letters(axis.label).starts_with("freq") ? Evidence::frequency : Evidence::none;
}

void check_order(const UniversalFunction& function, const foundation::Origin& origin, foundation::Problems& found) {
  const std::vector<double> hertz = exchange::abscissa_values(function);
  const auto falls = std::ranges::adjacent_find(hertz, [](double a, double b) { return !(b > a); });
  if (falls == hertz.end()) return;
  found
      .error("",
             fmt::format("function {}: {:.6g} Hz at point {} after {:.6g} Hz", point_name(function.response),
                         *(falls + 1), falls - hertz.begin() + 2, *falls),
             "frequencies increase", "sort the points of the function, or export it with even spacing")
      .origin = origin;
}

}  // namespace

bool may_be_over_frequency(const UniversalFunction& function) {
  const UniversalQuantity abscissa = function.abscissa_axis.quantity;
  return abscissa == UniversalQuantity::frequency || abscissa == UniversalQuantity::unknown;
}

bool same_frequencies(const std::vector<double>& one, const std::vector<double>& other) {
  // 1.00000E+01 is rounded by up to 5e-6 of its value; both numbers, and a step summed up, by that.
  constexpr double digits_of_text = 1e-5;
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](double a, double b) {
    return std::abs(a - b) <= digits_of_text * std::max(std::abs(a), std::abs(b));
  });
}

foundation::Problems judge_abscissas(const std::vector<const UniversalFunction*>& functions,
                                     const std::string& source) {
  foundation::Problems found;
  const UniversalFunction* first_unknown = nullptr;
  std::size_t unknown = 0;
  for (const UniversalFunction* function : functions) {
    const foundation::Origin origin{source, function->line};
    check_order(*function, origin, found);
    if (function->abscissa_axis.quantity != UniversalQuantity::unknown) continue;
    const Evidence said = evidence(function->abscissa_axis);
    if (said == Evidence::other)
      found
          .error("",
                 fmt::format("function {}: its abscissa has no quantity and the unit {}",
                             point_name(function->response), foundation::quoted(function->abscissa_axis.unit)),
                 "functions over frequency [Hz] are compared: an abscissa of type 18",
                 "export it over frequency, or correct the axis")
          .origin = origin;
    if (said != Evidence::none) continue;
    if (unknown++ == 0) first_unknown = function;
  }
  if (first_unknown)
    found
        .warning("",
                 fmt::format("{} with an abscissa of unknown quantity, the first is {}",
                             unknown == 1 ? "one function" : fmt::format("{} functions", unknown),
                             point_name(first_unknown->response)),
                 "type 18 states a frequency", "its numbers are read as Hz; check that they are")
        .origin = {source, first_unknown->line};
  return found;
}

}  // namespace trivet::project
