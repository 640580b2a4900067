// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/measured_file.h"

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

/// Quantity by the type of the numerator.
std::optional<Quantity> quantity_of_axis(const UniversalFunction& function) {
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
  const auto of_axis = quantity_of_axis(function);
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
std::vector<Statement> statements(const UniversalFunction& function, bool per_load,
                                  const std::optional<MeasuredUnit>& given) {
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

/// A quantity of the project that an axis type cannot have; a scalar may be a rotation.
bool contradicts(Quantity given, Quantity of_axis, bool scalar) {
  if (given == of_axis) return false;
  const bool loads = of_axis == Quantity::force || of_axis == Quantity::moment;
  const bool given_load = given == Quantity::force || given == Quantity::moment;
  return !scalar || loads != given_load || derivatives_of(given) != derivatives_of(of_axis);
}

}  // namespace

void MeasuredAxes::error(const UniversalFunction& function, const std::string& finding, const std::string& rule,
                         const std::string& remedy) {
  if (!reported_.insert(finding).second) return;
  found_.error("", fmt::format("function {}: {}", point_name(function.response), finding), rule, remedy).origin = {
      source_, function.line};
}

std::optional<MeasuredUnit> MeasuredAxes::unit_of(const UniversalFunction& function) {
  const auto of_axis = quantity_of_axis(function);
  const auto in_label = unit_in_label(function);
  const bool per_load =
      is_load(function.denominator.quantity) || (in_label && in_label->per_load) || (given_ && given_->per_load);
  if (of_axis && given_ && contradicts(given_->quantity, *of_axis, function.response.direction == 0)) {
    error(function,
          fmt::format("unit = {} of the project, but the numerator has the type {}", foundation::quoted(given_->text),
                      static_cast<int>(function.numerator.quantity)),
          "the type of an axis states the quantity: 8 displacement, 11 velocity, 12 acceleration, 9 and 13 force",
          "correct `unit`, or the type in the file");
    return std::nullopt;
  }
  const bool plain = function.denominator.quantity == UniversalQuantity::unknown &&
      (function.type != UniversalFunctionType::frequency_response || (in_label && !in_label->per_load));
  const double applied =
      function.in_file_units ? 1 : function.numerator.applied_unit / function.denominator.applied_unit;
  const std::vector<Statement> stated = statements(function, per_load, given_);
  if (given_) {
    // Without its own load, the unit of the project is that of the numerator.
    double load = 1;
    if (per_load && !given_->per_load) load = function.denominator.applied_unit;
    const double factor = given_->factor / load;
    // An axis of general type with powers of length and force is stated by set 164 through these powers.
    const bool agrees = stated.empty() ||
        std::any_of(stated.begin(), stated.end(), [&](const Statement& one) { return same_unit(one.factor, factor); });
    if (!agrees) {
      error(function,
            fmt::format("unit = {} of the project against {}", foundation::quoted(given_->text), stated.front().words),
            "the numbers have one unit", "remove `unit`, or correct the file");
      return std::nullopt;
    }
    return MeasuredUnit{.quantity = function.response.direction != 0 && of_axis ? *of_axis : given_->quantity,
                        .factor = factor / applied,
                        .per_load = per_load,
                        .text = given_->text};
  }
  for (const Statement& one : stated)
    if (!same_unit(one.factor, stated.front().factor)) {
      error(function, fmt::format("{} against {}", stated.front().words, one.words), "the numbers have one unit",
            "state it: unit = \"g/N\" or \"(m/s2)/N\", whichever the numbers have");
      return std::nullopt;
    }
  if (in_label && (!of_axis || *of_axis == in_label->quantity))
    return MeasuredUnit{.quantity = in_label->quantity,
                        .factor = stated.front().factor / applied,
                        .per_load = per_load,
                        .text = in_label->text};
  if (!of_axis || !(is_load(function.denominator.quantity) || plain)) return std::nullopt;
  if (function.in_file_units) return std::nullopt;
  const bool other = is_of_another_quantity(function);
  if (other || (stated.empty() && !function.numerator.stated.label.empty())) {
    error(function,
          fmt::format("{} is not a known unit of {}", label_words("numerator", function.numerator.stated.label),
                      other ? fmt::format("an axis of type {}", static_cast<int>(function.numerator.quantity))
                            : std::string("its quantity")),
          "set 164 or the label states the unit of the numbers, the type of the axis their quantity",
          "state it: unit = \"g/N\" or \"(m/s2)/N\"");
    return std::nullopt;
  }
  return MeasuredUnit{*of_axis, 1, is_load(function.denominator.quantity), {}};
}

}  // namespace trivet::project
