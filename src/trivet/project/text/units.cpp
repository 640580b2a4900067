// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/units.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/unit_parser.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <mutex>
#include <shared_mutex>
#include <string_view>
#include <system_error>
#include <utility>

namespace trivet::project {
namespace {

constexpr std::size_t longest_unit = 48;
using foundation::standard_gravity;

/// True for a unit of letters and operators, with digits only as exponents right after a letter, a ^ or a minus: in
/// "12 500 kg" the number is not over.
bool is_plain_unit(std::string_view text) {
  const auto letter = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80 || c == '_' ||
        c == ')' || c == '%';
  };
  if (text.starts_with("1/")) text.remove_prefix(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], before = i > 0 ? text[i - 1] : ' ';
    if (letter(c) || c == '*' || c == '/' || c == '(' || c == ' ') continue;
    const bool exponent = std::isdigit(static_cast<unsigned char>(c)) &&
        (letter(before) || before == '^' || before == '-' || std::isdigit(static_cast<unsigned char>(before)));
    const bool sign = (c == '-' || c == '^') && (letter(before) || (c == '-' && before == '^'));
    const bool product = c == '.' && letter(before) && i + 1 < text.size() && letter(text[i + 1]);
    if (!exponent && !sign && !product) return false;
  }
  return text.size() <= longest_unit;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Conversion from one unit to another, value · factor + offset, or the reason why there is none.
struct Conversion {
  double factor = 0, offset = 0;
  std::string reason;
};

double with_power_of_ten(double mantissa, int ten) {
  const double power = std::pow(10.0, std::abs(ten));  // exact up to 10^22
  return ten < 0 ? mantissa / power : mantissa * power;
}

/// Why a unit of another quantity is rejected. Where a word of mass stands for a force, as in the "lb/in" and "kg/mm"
/// of catalogues, the reason has the unit to write.
std::string reason_against_other_quantity(const std::string& from, const UnitValue& target) {
  for (const MassForForce& word : masses_for_forces()) {
    const std::string meant = with_word_replaced(from, word.mass, word.force);
    if (meant == from) continue;
    const auto unit = parsed_unit(meant);
    if (unit && unit->dimension == target.dimension)
      return foundation::quoted(from) + " has a mass where a force is expected; write \"" + meant + "\"";
  }
  return foundation::quoted(from) + " measures another quantity";
}

Conversion refused_unit(std::string reason) { return {0, 0, std::move(reason)}; }

Conversion new_conversion(const std::string& given, const std::string& to) {
  const bool acceleration = to == si_unit(Quantity::acceleration) || to == density_unit(Quantity::acceleration);
  const std::string spelled = one_spelling(given, to),
                    from = acceleration ? with_word_replaced(spelled, "g", "standard_free_fall") : spelled;
  if (std::string reason = reason_against_ambiguous(from, to); !reason.empty()) return refused_unit(std::move(reason));
  const auto unit = parsed_unit(from);
  if (!unit && has_odd_prefix(unit.error()))
    return refused_unit("\"" + unit.error() + "\" is no unit; SI prefixes stand before units of the SI only");
  if (!unit) return refused_unit(foundation::quoted(given) + " is not a unit");
  const auto target = parsed_unit(to);
  if (!target) return refused_unit(foundation::quoted(to) + " is not a unit");
  if (unit->dimension != target->dimension) return refused_unit(reason_against_other_quantity(given, *target));
  const double one = with_power_of_ten(target->mantissa, target->ten), offset = (unit->offset - target->offset) / one;
  if (offset != 0 && to != si_unit(Quantity::temperature))
    return refused_unit(foundation::quoted(given) + " has an offset");
  return {with_power_of_ten(unit->mantissa / target->mantissa, unit->ten - target->ten), offset, ""};
}

/// Each pair is looked up once; many designs are read in parallel.
Conversion conversion(const std::string& from, const std::string& to) {
  static std::shared_mutex access;
  static std::map<std::pair<std::string, std::string>, Conversion> known;
  {
    const std::shared_lock reading(access);
    if (const auto found = known.find({from, to}); found != known.end()) return found->second;
  }
  const std::unique_lock writing(access);
  return known.try_emplace(std::pair(from, to), new_conversion(from, to)).first->second;
}

}  // namespace

const char* si_unit(Quantity quantity) {
  switch (quantity) {
    case Quantity::pure:
      return "1";
    case Quantity::length:
      return "m";
    case Quantity::area:
      return "m2";
    case Quantity::volume:
      return "m3";
    case Quantity::mass:
      return "kg";
    case Quantity::inertia:
      return "kg m2";
    case Quantity::angle:
      return "rad";
    case Quantity::angular_frequency:
      return "rad/s";
    case Quantity::time:
      return "s";
    case Quantity::per_time:
      return "1/s";
    case Quantity::time_per_length:
      return "s/m";
    case Quantity::time_per_angle:
      return "s/rad";
    case Quantity::force:
      return "N";
    case Quantity::moment:
      return "N m";
    case Quantity::energy:
      return "J";
    case Quantity::acceleration:
      return "m/s2";
    case Quantity::velocity:
      return "m/s";
    case Quantity::angular_velocity:
      return "rad/s";
    case Quantity::angular_acceleration:
      return "rad/s2";
    case Quantity::force_per_length:
      return "N/m";
    case Quantity::force_per_angle:
      return "N/rad";
    case Quantity::moment_per_length:
      return "N m/m";
    case Quantity::moment_per_angle:
      return "N m/rad";
    case Quantity::force_per_length_squared:
      return "N/m2";
    case Quantity::force_per_length_cubed:
      return "N/m3";
    case Quantity::moment_per_angle_squared:
      return "N m/rad2";
    case Quantity::moment_per_angle_cubed:
      return "N m/rad3";
    case Quantity::damping_force_per_length:
      return "N s/m";
    case Quantity::damping_force_per_velocity_squared:
      return "N s2/m2";
    case Quantity::damping_moment_per_velocity_squared:
      return "N m s2/rad2";
    case Quantity::damping_force_per_angle:
      return "N s/rad";
    case Quantity::damping_moment_per_length:
      return "N m s/m";
    case Quantity::damping_moment_per_angle:
      return "N m s/rad";
    case Quantity::pressure:
      return "Pa";
    case Quantity::density:
      return "kg/m3";
    case Quantity::mass_length:
      return "kg m";
    case Quantity::temperature:
      return "K";
  }
  return "";
}

std::string printed_si_unit(Quantity quantity) {
  if (quantity == Quantity::pure) return "";
  std::string printed;
  for (const char c : std::string(si_unit(quantity))) printed += c == '2' ? "²" : c == '3' ? "³" : std::string(1, c);
  return printed;
}

namespace {

/// A number and its unit in this SI unit.
tl::expected<double, std::string> converted(std::string_view text, const std::string& expected) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value))
    return tl::make_unexpected("it does not start with a finite number");
  const std::string_view unit_text = trimmed(text.substr(to_size(end - text.data())));
  if (unit_text.empty())
    return tl::make_unexpected(expected == "1" ? "a number in quotes without a unit" : "the unit is missing");
  if (unit_text.starts_with(',')) return tl::make_unexpected("write a decimal point, not a comma");
  if (!is_plain_unit(unit_text)) return tl::make_unexpected(foundation::quoted(unit_text) + " is not a unit");
  if (unit_text == "g" && expected == si_unit(Quantity::acceleration)) return value * standard_gravity;
  if (unit_text == expected) return value;
  const Conversion found = conversion(std::string(unit_text), expected);
  if (!found.reason.empty()) return tl::make_unexpected(found.reason);
  return value * found.factor + found.offset;
}

}  // namespace

tl::expected<double, std::string> to_si(std::string_view text, Quantity quantity) {
  return converted(text, si_unit(quantity));
}

std::string density_unit(Quantity quantity) { return "(" + std::string(si_unit(quantity)) + ")2/Hz"; }

tl::expected<double, std::string> to_density(std::string_view text, Quantity quantity) {
  return converted(text, density_unit(quantity));
}

std::optional<double> unit_ratio(const std::string& unit, const std::string& other) {
  if (!is_plain_unit(unit) || !is_plain_unit(other) || unit.empty() || other.empty()) return std::nullopt;
  if (unit == "g" || other == "g")  // beside an acceleration it is the standard gravity
    if (const auto above = to_si("1 " + unit, Quantity::acceleration),
        below = to_si("1 " + other, Quantity::acceleration);
        above && below)
      return *above / *below;
  const Conversion found = conversion(unit, other);
  if (!found.reason.empty()) return std::nullopt;
  return found.factor;
}

}  // namespace trivet::project
