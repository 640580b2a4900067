// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_units.h"

#include <cmath>
#include <cstdlib>
#include <span>
#include <string>

#include "trivet/exchange/text/text_lines.h"

namespace trivet::exchange {
namespace {

using Quantity = UniversalQuantity;

struct NamedUnit {
  std::string_view label;  ///< without blanks, brackets, ^ and *, in lower case; forces keep theirs
  double unit_value = 1;
};

constexpr double inch = 0.0254, foot = 0.3048, mil = inch / 1000, standard_gravity = 9.80665,
                 pound_force = 4.4482216152605, one_per_minute = 1.0 / 60, two_pi = 6.283185307179586,
                 degree = two_pi / 360;

constexpr NamedUnit lengths[] = {{"m", 1},       {"mm", 1e-3}, {"cm", 1e-2},     {"um", 1e-6},
                                 {"µm", 1e-6},   {"μm", 1e-6}, {"micron", 1e-6}, {"in", inch},
                                 {"inch", inch}, {"ft", foot}, {"mil", mil},     {"mils", mil}};
constexpr NamedUnit velocities[] = {{"m/s", 1},     {"mm/s", 1e-3}, {"cm/s", 1e-2},
                                    {"in/s", inch}, {"ips", inch},  {"ft/s", foot}};
constexpr NamedUnit accelerations[] = {{"m/s2", 1},
                                       {"m/s/s", 1},
                                       {"mm/s2", 1e-3},
                                       {"cm/s2", 1e-2},
                                       {"gal", 1e-2},
                                       {"in/s2", inch},
                                       {"ft/s2", foot},
                                       {"g", standard_gravity},
                                       {"gn", standard_gravity},
                                       {"g's", standard_gravity},
                                       {"gs", standard_gravity}};
constexpr NamedUnit forces[] = {{"N", 1},
                                {"mN", 1e-3},
                                {"kN", 1e3},
                                {"MN", 1e6},
                                {"daN", 10},
                                {"kgf", standard_gravity},
                                {"lbf", pound_force},
                                {"lb", pound_force}};
constexpr NamedUnit angles[] = {{"rad", 1}, {"mrad", 1e-3}, {"deg", degree}, {"°", degree}};
constexpr NamedUnit angular_velocities[] = {
    {"rad/s", 1}, {"mrad/s", 1e-3}, {"deg/s", degree}, {"°/s", degree}, {"rpm", two_pi / 60}};
constexpr NamedUnit angular_accelerations[] = {
    {"rad/s2", 1}, {"rad/s/s", 1}, {"mrad/s2", 1e-3}, {"deg/s2", degree}, {"°/s2", degree}};
constexpr NamedUnit moments[] = {{"Nm", 1},
                                 {"N·m", 1},
                                 {"N.m", 1},
                                 {"N-m", 1},
                                 {"Nmm", 1e-3},
                                 {"N·mm", 1e-3},
                                 {"N.mm", 1e-3},
                                 {"kNm", 1e3},
                                 {"kN·m", 1e3},
                                 {"kN.m", 1e3},
                                 {"lbfin", pound_force* inch},
                                 {"inlbf", pound_force* inch},
                                 {"lbin", pound_force* inch},
                                 {"inlb", pound_force* inch},
                                 {"lbfft", pound_force* foot},
                                 {"ftlbf", pound_force* foot},
                                 {"lbft", pound_force* foot},
                                 {"ftlb", pound_force* foot}};
constexpr NamedUnit times[] = {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}};
constexpr NamedUnit frequencies[] = {
    {"hz", 1}, {"khz", 1e3}, {"rad/s", 1 / two_pi}, {"rpm", one_per_minute}, {"cpm", one_per_minute}};

std::span<const NamedUnit> units_of(Quantity quantity, bool turns) {
  switch (quantity) {
    case Quantity::displacement:
      return turns ? std::span<const NamedUnit>(angles) : lengths;
    case Quantity::velocity:
      return turns ? std::span<const NamedUnit>(angular_velocities) : velocities;
    case Quantity::acceleration:
      return turns ? std::span<const NamedUnit>(angular_accelerations) : accelerations;
    case Quantity::reaction_force:
    case Quantity::excitation_force:
      return turns ? std::span<const NamedUnit>(moments) : forces;
    case Quantity::time:
      return times;
    case Quantity::frequency:
      return frequencies;
    default:
      return {};
  }
}

bool has_rotations(Quantity quantity) {
  return quantity == Quantity::displacement || quantity == Quantity::velocity || quantity == Quantity::acceleration ||
      quantity == Quantity::reaction_force || quantity == Quantity::excitation_force;
}

/// "[m/s²]", "m/sec^2" → "m/s2"
std::string plain_label(std::string_view label, bool keep_case) {
  std::string text;
  for (const char c : trimmed(label))
    if (std::string_view(" ^*()[]").find(c) == std::string_view::npos) text += c;
  const auto replace = [&](std::string_view part, std::string_view with) {
    if (const std::size_t at = text.find(part); at != std::string::npos) text.replace(at, part.size(), with);
  };
  replace("²", "2");
  if (!keep_case) text = lower(text);
  replace("seconds", "s");
  replace("sec", "s");
  return text;
}

}  // namespace

UniversalMotion motion_of_direction(int direction) {
  if (direction == 0) return UniversalMotion::scalar;
  return std::abs(direction) <= 3 ? UniversalMotion::translation : UniversalMotion::rotation;
}

std::optional<UniversalExponents> unit_exponents(Quantity quantity, UniversalMotion motion,
                                                 const UniversalExponents& given) {
  if (quantity == Quantity::general) return given;
  if (motion == UniversalMotion::scalar && given != UniversalExponents{}) return given;
  const bool turns = motion == UniversalMotion::rotation;
  switch (quantity) {
    case Quantity::unknown:
    case Quantity::strain:
    case Quantity::time:
    case Quantity::frequency:
    case Quantity::shaft_speed:
    case Quantity::order:
      return UniversalExponents{};
    case Quantity::displacement:
    case Quantity::velocity:
    case Quantity::acceleration:
      return UniversalExponents{.length = turns ? 0 : 1};
    case Quantity::reaction_force:
    case Quantity::excitation_force:
      return UniversalExponents{.length = turns ? 1 : 0, .force = 1};
    case Quantity::stress:
    case Quantity::pressure:
      return UniversalExponents{.length = turns ? -1 : -2, .force = 1};
    case Quantity::mass:
      return UniversalExponents{.length = turns ? 1 : -1, .force = 1};
    default:
      return std::nullopt;
  }
}

double unit_value(const UniversalUnits& units, const UniversalExponents& exponents) {
  return std::pow(units.length, -exponents.length) * std::pow(units.force, -exponents.force) *
      std::pow(units.temperature, -exponents.temperature);
}

bool is_si(const UniversalUnits& units) { return units.length == 1 && units.force == 1 && units.temperature == 1; }

std::string_view si_unit_label(Quantity quantity, UniversalMotion motion) {
  const bool turns = motion == UniversalMotion::rotation;
  switch (quantity) {
    case Quantity::displacement:
      return turns ? "rad" : "m";
    case Quantity::velocity:
      return turns ? "rad/s" : "m/s";
    case Quantity::acceleration:
      return turns ? "rad/s2" : "m/s2";
    case Quantity::reaction_force:
    case Quantity::excitation_force:
      return turns ? "N m" : "N";
    default:
      return "";
  }
}

std::optional<UniversalLabelUnit> unit_of_label(Quantity quantity, UniversalMotion motion, std::string_view label) {
  const std::string plain =
      plain_label(label, quantity == Quantity::reaction_force || quantity == Quantity::excitation_force);
  for (const bool turns : {false, true}) {
    if (motion == (turns ? UniversalMotion::translation : UniversalMotion::rotation)) continue;
    for (const NamedUnit& unit : units_of(quantity, turns))
      if (unit.label == plain) return UniversalLabelUnit{unit.unit_value, turns && has_rotations(quantity)};
  }
  return std::nullopt;
}

}  // namespace trivet::exchange
