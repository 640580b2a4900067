// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/exchange/universal/universal_functions.h"
#include "trivet/exchange/universal/universal_units.h"

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

/// SI value of the unit of an axis by set 164, or nullopt.
std::optional<double> unit_of_axis(const UniversalAxis& axis, UniversalMotion motion, const UniversalUnits& units) {
  const auto exponents = unit_exponents(axis.quantity, motion, axis.exponents);
  return exponents ? std::optional(unit_value(units, *exponents)) : std::nullopt;
}

/// Set 164 has units of length, force and temperature: it says nothing about radians, hertz or seconds.
bool is_in_units(const UniversalAxis& axis, UniversalMotion motion) {
  const auto exponents = unit_exponents(axis.quantity, motion, axis.exponents);
  return exponents && *exponents != UniversalExponents{};
}

/// Notes what the file states about the unit of an axis, and returns the unit of its numbers: by set 164, or else by
/// the label, or else SI. nullopt if none of them can say it.
std::optional<double> stated_unit(UniversalAxis& axis, UniversalMotion motion,
                                  const std::optional<UniversalUnits>& units) {
  const auto of_label = unit_of_label(axis.quantity, motion, axis.unit);
  axis.stated.label = axis.unit;
  if (of_label) {
    axis.stated.by_label = of_label->value;
    axis.stated.label_turns = of_label->turns;
    if (of_label->turns) motion = UniversalMotion::rotation;
  }
  const auto of_set = unit_of_axis(axis, motion, units.value_or(UniversalUnits{}));
  if (units && of_set && is_in_units(axis, motion)) axis.stated.by_set = of_set;
  if (axis.stated.by_set) return axis.stated.by_set;
  return of_label ? axis.stated.by_label : of_set;
}

/// Some programs round the factors of units.
constexpr double different_unit = 1e-3;

/// Two units of an abscissa. Those of the ordinates are compared where a function is used.
void compare_label_of_abscissa(const UniversalAxis& axis, int line, SetProblems& problems) {
  const auto &set = axis.stated.by_set, &label = axis.stated.by_label;
  if (!set || !label || std::abs(*set / *label - 1) < different_unit) return;
  problems.warning(line, "unit of the abscissa", in_quotes(axis.stated.label),
                   fmt::format("by set 164 one unit is {:.9g} in SI, and by this label {:.9g}", *set, *label),
                   "set 164 is used; multiply the numbers if the label is right");
}

void scale_abscissa(UniversalFunction& function, double unit) {
  function.abscissa_axis.applied_unit = unit;
  if (unit == 1) return;
  if (auto* even = std::get_if<EvenAbscissa>(&function.abscissa)) {
    even->first *= unit;
    even->step *= unit;
  } else {
    for (double& value : std::get<std::vector<double>>(function.abscissa)) value *= unit;
  }
  function.abscissa_axis.unit = si_unit_label(function.abscissa_axis.quantity, UniversalMotion::translation);
}

void scale_axis(UniversalAxis& axis, UniversalMotion motion, double unit) {
  axis.applied_unit = unit;
  if (unit != 1) axis.unit = si_unit_label(axis.quantity, axis.stated.label_turns ? UniversalMotion::rotation : motion);
}

void scale_ordinates(UniversalFunction& function, double numerator, double denominator) {
  scale_axis(function.numerator, motion_of_direction(function.response.direction), numerator);
  scale_axis(function.denominator, motion_of_direction(function.reference.direction), denominator);
  const double factor = numerator / denominator;
  for (std::complex<double>& value : function.values) value *= factor;
}

bool is_finite(const UniversalFunction& function) {
  const std::vector<double> abscissa = abscissa_values(function);
  return std::ranges::all_of(abscissa, [](double value) { return std::isfinite(value); }) &&
      std::ranges::all_of(function.values, [](const std::complex<double>& value) {
           return std::isfinite(value.real()) && std::isfinite(value.imag());
         });
}

}  // namespace

void convert_to_si(UniversalFunction& function, const std::optional<UniversalUnits>& units, int line,
                   SetProblems& problems) {
  const auto abscissa = stated_unit(function.abscissa_axis, UniversalMotion::translation, units);
  const auto numerator = stated_unit(function.numerator, motion_of_direction(function.response.direction), units);
  const auto denominator = stated_unit(function.denominator, motion_of_direction(function.reference.direction), units);
  compare_label_of_abscissa(function.abscissa_axis, line, problems);
  const OrdinateUnit ordinate = ordinate_unit(function.type);
  const bool known =
      abscissa && (ordinate == OrdinateUnit::none || (ordinate == OrdinateUnit::ratio && numerator && denominator));
  // Who uses a density or another square knows the unit of its numerator: `stated`.
  const bool square = ordinate == OrdinateUnit::unknown && abscissa && numerator;
  if (units && !is_si(*units) && !known) function.in_file_units = true;
  if (function.in_file_units && !square) {
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
