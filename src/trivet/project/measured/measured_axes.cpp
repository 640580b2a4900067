// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/measured_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/measured/universal_names.h"

namespace trivet::project {
namespace {

using exchange::UniversalAxis;
using exchange::UniversalFunction;
using exchange::UniversalFunctionType;
using exchange::UniversalQuantity;

/// Some programs round the factors of set 164.
constexpr double rounded_units = 1e-3;

/// A statement about the unit of the numbers of a function, or of one of its axes.
struct Statement {
  double factor = 1;  ///< to SI
  std::string words;
};

bool is_load(UniversalQuantity quantity) {
  return quantity == UniversalQuantity::excitation_force || quantity == UniversalQuantity::reaction_force;
}

bool same_unit(double a, double b) { return std::abs(a / b - 1) < rounded_units; }

bool turns(const exchange::UniversalPoint& point, const UniversalAxis& axis) {
  return std::abs(point.direction) > 3 || axis.stated.label_turns;
}

}  // namespace

std::optional<Quantity> quantity_of_numerator(const UniversalFunction& function) {
  const bool rotation = turns(function.response, function.numerator);
  switch (function.numerator.quantity) {
    case UniversalQuantity::displacement:
      return rotation ? Quantity::angle : Quantity::length;
    case UniversalQuantity::velocity:
      return rotation ? Quantity::angular_velocity : Quantity::velocity;
    case UniversalQuantity::acceleration:
      return rotation ? Quantity::angular_acceleration : Quantity::acceleration;
    case UniversalQuantity::reaction_force:
    case UniversalQuantity::excitation_force:
      return rotation ? Quantity::moment : Quantity::force;
    default:
      return std::nullopt;
  }
}

namespace {

std::string label_words(const char* axis, const std::string& label) {
  return fmt::format("the label {} of the {}", foundation::quoted(label), axis);
}

/// What set 164 and the label say about an axis.
std::vector<Statement> statements(const UniversalAxis& axis, const char* name) {
  std::vector<Statement> all;
  const exchange::UniversalUnitStatements& stated = axis.stated;
  if (stated.by_set)
    all.push_back({*stated.by_set, fmt::format("set 164 (the {} has {:.6g} in SI)", name, *stated.by_set)});
  if (stated.by_label) all.push_back({*stated.by_label, label_words(name, stated.label)});
  return all;
}

/// A unit in the label of the numerator that is not one of the type of the axis: of a ratio, "g/N", or of another
/// quantity.
std::optional<MeasuredUnit> any_unit_in_label(const UniversalFunction& function) {
  const UniversalAxis& axis = function.numerator;
  if (axis.stated.label.empty() || axis.stated.by_label) return std::nullopt;
  return measured_unit(axis.stated.label);
}

/// True if the label names a unit of another quantity than the type of the axis: "mm/s" of an acceleration.
bool is_of_another_quantity(const UniversalFunction& function) {
  const auto unit = any_unit_in_label(function);
  const auto of_axis = quantity_of_numerator(function);
  return unit && of_axis && unit->quantity != *of_axis;
}

/// A unit per load in the label of the numerator, "g/N", or the unit of an axis of unknown type, "m/s^2".
std::optional<MeasuredUnit> unit_in_label(const UniversalFunction& function) {
  if (is_of_another_quantity(function)) return std::nullopt;
  const UniversalAxis& axis = function.numerator;
  auto unit = any_unit_in_label(function);
  if (!unit || unit->per_load) return unit;
  if (function.denominator.stated.label.empty()) return unit;
  if (const auto whole = measured_unit("(" + axis.stated.label + ")/" + function.denominator.stated.label))
    return whole;
  return unit;
}

/// Every unit of the numbers that the file states. If it states that of the denominator alone, `given` must agree with
/// it, and completes it.
std::vector<Statement> statements(const UniversalFunction& function, bool per_load, const MeasuredUnit* given) {
  std::vector<Statement> all;
  std::vector<Statement> numerators = statements(function.numerator, "numerator");
  if (const auto unit = unit_in_label(function))
    (unit->per_load ? all : numerators)
        .push_back({unit->factor, label_words("numerator", function.numerator.stated.label)});
  std::vector<Statement> denominators = statements(function.denominator, "denominator");
  if (denominators.empty() || !per_load) denominators = {{1, ""}};
  if (all.empty() && numerators.empty() && per_load && given && given->per_load && !denominators.front().words.empty())
    numerators = {{given->factor * given->load, ""}};
  for (const Statement& numerator : numerators)
    for (const Statement& denominator : denominators)
      all.push_back({numerator.factor / denominator.factor,
                     numerator.words + (numerator.words.empty() || denominator.words.empty() ? "" : " and ") +
                         denominator.words});
  return all;
}

/// How a unit of the project relates to a function.
enum class Fit { fits, of_others, contradicts };

/// The quantity of a scalar function, or of an axis of unknown type, may be a translation or a rotation.
Fit fit_of_numerator(const MeasuredUnit& unit, const UniversalFunction& function) {
  const auto of_axis = quantity_of_numerator(function);
  const bool turn_known = function.response.direction != 0;
  if (turn_known && is_rotation(unit.quantity) != turns(function.response, function.numerator)) return Fit::of_others;
  if (!of_axis) return Fit::fits;
  if (is_motion(unit.quantity) != is_motion(*of_axis)) return Fit::of_others;
  return derivatives_of(unit.quantity) == derivatives_of(*of_axis) ? Fit::fits : Fit::contradicts;
}

Fit fit_of(const MeasuredUnit& unit, const UniversalFunction& function) {
  const bool load_known = is_load(function.denominator.quantity) && function.reference.direction != 0;
  if (unit.per_load && load_known && unit.load_turns != turns(function.reference, function.denominator))
    return Fit::of_others;
  return fit_of_numerator(unit, function);
}

foundation::Problem problem_of(const UniversalFunction& function, const std::string& source, const std::string& finding,
                               std::string rule, std::string remedy) {
  return {.origin = {source, function.line},
          .finding = fmt::format("function {}: {}", point_name(function.response), finding),
          .rule = std::move(rule),
          .remedy = std::move(remedy)};
}

const char* const state_it = "state it: unit = \"g/N\" or \"(m/s2)/N\"";

}  // namespace

/// The unit of the project for a function; none if it is for others. Of several that fit a scalar, the first.
const MeasuredUnit* MeasuredAxes::fitting(const UniversalFunction& function) {
  const MeasuredUnit* contradicting = nullptr;
  for (const MeasuredUnit& unit : given_) {
    const Fit fit = fit_of(unit, function);
    if (fit == Fit::of_others) continue;
    met_.insert(&unit);
    if (fit == Fit::fits) return &unit;
    contradicting = &unit;
  }
  return contradicting;
}

FunctionUnit MeasuredAxes::unit_of(const UniversalFunction& function) {
  const auto error = [&](const std::string& finding, const std::string& rule, const std::string& remedy) {
    return FunctionUnit{std::nullopt, problem_of(function, source_, finding, rule, remedy)};
  };
  const MeasuredUnit* given = fitting(function);
  const auto of_axis = quantity_of_numerator(function);
  if (given && fit_of(*given, function) == Fit::contradicts)
    return error(
        fmt::format("unit = {} of the project, but the numerator has the type {}", foundation::quoted(given->text),
                    static_cast<int>(function.numerator.quantity)),
        "the type of an axis states the quantity: 8 displacement, 11 velocity, 12 acceleration, 9 and 13 force",
        "correct `unit`, or the type in the file");
  const auto in_label = unit_in_label(function);
  const bool per_load =
      is_load(function.denominator.quantity) || (in_label && in_label->per_load) || (given && given->per_load);
  const bool plain = function.denominator.quantity == UniversalQuantity::unknown &&
      (function.type != UniversalFunctionType::frequency_response || (in_label && !in_label->per_load));
  const double applied =
      function.in_file_units ? 1 : function.numerator.applied_unit / function.denominator.applied_unit;
  const std::vector<Statement> stated = statements(function, per_load, given);
  if (given) {
    // Without its own load, the unit of the project is that of the numerator.
    double load = 1;
    if (per_load && !given->per_load) load = function.denominator.applied_unit;
    const double factor = given->factor / load;
    // An axis of general type with powers of length and force is stated by set 164 through these powers.
    const bool agrees = stated.empty() ||
        std::ranges::any_of(stated, [&](const Statement& one) { return same_unit(one.factor, factor); });
    if (!agrees)
      return error(
          fmt::format("unit = {} of the project against {}", foundation::quoted(given->text), stated.front().words),
          "the numbers have one unit", "remove `unit`, or correct the file");
    return {MeasuredUnit{.quantity = function.response.direction != 0 && of_axis ? *of_axis : given->quantity,
                         .factor = factor / applied,
                         .per_load = per_load,
                         .text = given->text},
            std::nullopt};
  }
  for (const Statement& one : stated)
    if (!same_unit(one.factor, stated.front().factor))
      return error(fmt::format("{} against {}", stated.front().words, one.words), "the numbers have one unit",
                   "state it: unit = \"g/N\" or \"(m/s2)/N\", whichever the numbers have");
  if (in_label && (!of_axis || *of_axis == in_label->quantity))
    return {MeasuredUnit{.quantity = in_label->quantity,
                         .factor = stated.front().factor / applied,
                         .per_load = per_load,
                         .text = in_label->text},
            std::nullopt};
  if (!of_axis || !(is_load(function.denominator.quantity) || plain) || function.in_file_units) return {};
  const bool other = is_of_another_quantity(function);
  if (other || (stated.empty() && !function.numerator.stated.label.empty()))
    return error(fmt::format("{} is not a known unit of {}", label_words("numerator", function.numerator.stated.label),
                             other ? fmt::format("an axis of type {}", static_cast<int>(function.numerator.quantity))
                                   : std::string("its quantity")),
                 "set 164 or the label states the unit of the numbers, the type of the axis their quantity", state_it);
  MeasuredUnit si{.quantity = *of_axis, .per_load = is_load(function.denominator.quantity)};
  si.assumed = !given_.empty() && stated.empty() && !function.denominator.stated.by_set;
  return {si, std::nullopt};
}

foundation::Problems MeasuredAxes::judge_idle_units() const {
  foundation::Problems found;
  for (const MeasuredUnit& unit : given_)
    if (!met_.contains(&unit))
      found.add({.origin = {source_},
                 .finding = fmt::format("unit = {} of the project fits no function", foundation::quoted(unit.text)),
                 .rule = "a unit is for functions of its quantity: translations or rotations, per force or per moment",
                 .remedy = "correct `unit`, or the types and directions in the file"});
  return found;
}

foundation::Problem assumed_units(const GivenUnits& given, const std::vector<std::string>& names,
                                  const std::string& source) {
  return {.severity = foundation::Severity::warning,
          .origin = {source},
          .finding = fmt::format("{} is not for {}, and the file states no unit of them", unit_words(given),
                                 foundation::comma_separated(names)),
          .rule = "translations and rotations, per force and per moment, have units of their own",
          .remedy = "they are read in SI; state all: unit = [\"g/N\", \"(rad/s2)/N\", \"(m/s2)/(N m)\"]"};
}

}  // namespace trivet::project
