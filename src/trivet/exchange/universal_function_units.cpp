// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/exchange/universal_function_head.h"
#include "trivet/exchange/universal_functions.h"
#include "trivet/exchange/universal_units.h"

namespace trivet::exchange {
namespace {

using FunctionType = UniversalFunctionType;

/// Unit of the ordinates, in terms of the units of numerator and denominator.
enum class OrdinateUnit { ratio, none, unknown };

/// Programs disagree about the denominator of functions with the square of a unit, so those are unknown.
OrdinateUnit ordinate_unit(FunctionType type) {
  switch (type) {
    case FunctionType::general:
    case FunctionType::time_response:
    case FunctionType::frequency_response:
    case FunctionType::transmissibility:
    case FunctionType::spectrum:
    case FunctionType::orbit:
    case FunctionType::shock_response_spectrum:
    case FunctionType::order_function:
      return OrdinateUnit::ratio;
    case FunctionType::coherence:
    case FunctionType::mode_indicator:
    case FunctionType::partial_coherence:
    case FunctionType::multiple_coherence:
      return OrdinateUnit::none;
    default:
      return OrdinateUnit::unknown;
  }
}

/// SI value of the unit of an axis, or nullopt.
std::optional<double> unit_of_axis(const UniversalAxis& axis, UniversalMotion motion, const UniversalUnits& units) {
  const auto exponents = unit_exponents(axis.quantity, motion, axis.exponents);
  return exponents ? std::optional(unit_value(units, *exponents)) : std::nullopt;
}

/// Some programs round the factors of units.
constexpr double different_unit = 1e-3;

/// The label may say g or mm/s2 while the units of the file are SI, or none: then the numbers are probably in the unit
/// of the label.
void compare_label(const UniversalAxis& axis, const char* name, double unit, int line, SetProblems& problems) {
  const auto of_label = unit_value_of_label(axis.quantity, axis.unit);
  if (!of_label || std::abs(unit / *of_label - 1) < different_unit) return;
  problems.warning(
      line, fmt::format("unit of the {}", name), in_quotes(axis.unit),
      fmt::format("by set 164, or without it, one unit is {:.9g} in SI, and by this label {:.9g}", unit, *of_label),
      "set 164 is used; multiply the numbers if the label is right");
}

void compare_labels(const UniversalFunction& function, double abscissa, double numerator, double denominator, int line,
                    SetProblems& problems) {
  compare_label(function.abscissa_axis, "abscissa", abscissa, line, problems);
  if (ordinate_unit(function.type) != OrdinateUnit::ratio) return;
  if (motion_of_direction(function.response.direction) != UniversalMotion::rotation)
    compare_label(function.numerator, "numerator", numerator, line, problems);
  if (motion_of_direction(function.reference.direction) != UniversalMotion::rotation)
    compare_label(function.denominator, "denominator", denominator, line, problems);
}

void scale_abscissa(UniversalFunction& function, double unit) {
  if (unit == 1) return;
  if (auto* even = std::get_if<EvenAbscissa>(&function.abscissa)) {
    even->first *= unit;
    even->step *= unit;
  } else {
    for (double& value : std::get<std::vector<double>>(function.abscissa)) value *= unit;
  }
  function.abscissa_axis.unit = si_unit_label(function.abscissa_axis.quantity, UniversalMotion::translation);
}

void scale_ordinates(UniversalFunction& function, double numerator, double denominator) {
  if (numerator != 1)
    function.numerator.unit =
        si_unit_label(function.numerator.quantity, motion_of_direction(function.response.direction));
  if (denominator != 1)
    function.denominator.unit =
        si_unit_label(function.denominator.quantity, motion_of_direction(function.reference.direction));
  const double factor = numerator / denominator;
  for (std::complex<double>& value : function.values) value *= factor;
}

bool is_finite(const UniversalFunction& function) {
  const std::vector<double> abscissa = abscissa_values(function);
  return std::all_of(abscissa.begin(), abscissa.end(), [](double value) { return std::isfinite(value); }) &&
      std::all_of(function.values.begin(), function.values.end(), [](const std::complex<double>& value) {
           return std::isfinite(value.real()) && std::isfinite(value.imag());
         });
}

}  // namespace

void convert_to_si(UniversalFunction& function, const UniversalUnits& units, int line, SetProblems& problems) {
  const auto abscissa = unit_of_axis(function.abscissa_axis, UniversalMotion::translation, units);
  const auto numerator = unit_of_axis(function.numerator, motion_of_direction(function.response.direction), units);
  const auto denominator = unit_of_axis(function.denominator, motion_of_direction(function.reference.direction), units);
  compare_labels(function, abscissa.value_or(1), numerator.value_or(1), denominator.value_or(1), line, problems);
  const OrdinateUnit ordinate = ordinate_unit(function.type);
  const bool known =
      abscissa && (ordinate == OrdinateUnit::none || (ordinate == OrdinateUnit::ratio && numerator && denominator));
  if (!is_si(units) && !known) {
    function.in_file_units = true;
    problems.warning(
        line, "unit",
        fmt::format("function type {}, quantities {} and {} over {}", static_cast<int>(function.type),
                    static_cast<int>(function.numerator.quantity), static_cast<int>(function.denominator.quantity),
                    static_cast<int>(function.abscissa_axis.quantity)),
        "their unit is not known, and set 164 is not SI", "the ordinates are in the units of the file");
  }
  if (abscissa) scale_abscissa(function, *abscissa);
  if (known && ordinate == OrdinateUnit::ratio) scale_ordinates(function, *numerator, *denominator);
  if (!is_finite(function))
    problems.error(line, "unit", "infinite numbers in SI", "numbers are finite",
                   "check the factors of set 164 and the powers of the axes");
}

}  // namespace trivet::exchange
