// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/unit_table.h"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <string>

#include "trivet/foundation/constants.h"

namespace trivet::project {
namespace {

constexpr Dimension pure{}, length{1}, volume{3}, mass{0, 1}, time{0, 0, 1}, velocity{1, 0, -1}, acceleration{1, 0, -2},
    force{1, 1, -2}, impulse{1, 1, -1}, moment{2, 1, -2}, pressure{-1, 1, -2}, viscosity{-1, 1, -1},
    diffusivity{2, 0, -1}, angle{0, 0, 0, 1}, speed{0, 0, -1, 1}, energy{0, 0, 0, 0, 1}, power{0, 0, -1, 0, 1},
    temperature{0, 0, 0, 0, 0, 1}, current{0, 0, 0, 0, 0, 0, 1}, charge{0, 0, 1, 0, 0, 0, 1},
    voltage{0, 0, -1, 0, 1, 0, -1};

constexpr bool prefixes = true;
constexpr double pi = std::numbers::pi, gravity = foundation::standard_gravity;
constexpr double pound = 0.45359237, foot = 0.3048, inch = 0.0254, mile = 1609.344, nautical_mile = 1852;
constexpr double pound_force = pound * gravity, psi = 4.4482216152605 / (inch * inch), mercury = 133.322387415;
constexpr double zero_celsius = 273.15, rankine = 5.0 / 9, zero_fahrenheit = 459.67 * rankine;

/// Symbols are read as they are written; words in upper and lower case, and with the s of a plural.
struct Row {
  const char *symbols, *words;
  UnitValue value;
  bool takes_prefix = false;
};

/// Sources: the SI brochure (9th edition) with the units accepted beside the SI; the definitions of the yard and the
/// pound of 1959; the conventional values of gravity, atmosphere, calorie and millimetre of mercury.
constexpr Row rows[] = {
    {"%", "percent", {1, -2, pure}},
    {"ppm", "", {1, -6, pure}},
    {"m", "meter metre", {1, 0, length}, prefixes},
    {"in", "inch inches international_inch international_inches", {inch, 0, length}},
    {"ft", "foot feet international_foot international_feet", {foot, 0, length}},
    {"yd", "yard international_yard", {3 * foot, 0, length}},
    {"mi", "mile international_mile", {mile, 0, length}},
    {"", "mil", {2.54, -5, length}},
    {"nmi", "nautical_mile nmile", {nautical_mile, 0, length}},
    {"", "micron", {1, -6, length}},
    {"Å", "angstrom", {1, -10, length}},
    {"l L", "liter litre", {1, -3, volume}, prefixes},
    {"cc", "", {1, -6, volume}},
    {"kg", "kilogram kilogramme", {1, 0, mass}},
    {"g", "gram gramme", {1, -3, mass}, prefixes},
    {"t", "tonne metric_ton", {1, 3, mass}, prefixes},
    {"lb lbs lbm", "pound avoirdupois_pound", {pound, 0, mass}},
    {"oz", "ounce avoirdupois_ounce", {pound / 16, 0, mass}},
    {"", "grain", {pound / 7000, 0, mass}},
    {"slug", "slug", {pound_force / foot, 0, mass}},
    {"", "short_ton", {2000 * pound, 0, mass}},
    {"", "long_ton", {2240 * pound, 0, mass}},
    {"s", "second sec", {1, 0, time}, prefixes},
    {"min", "minute", {60, 0, time}},
    {"h hr", "hour", {3600, 0, time}},
    {"d", "day", {86400, 0, time}},
    {"", "week", {604800, 0, time}},
    {"kt kts", "knot international_knot", {nautical_mile / 3600, 0, velocity}},
    {"mph", "mile_per_hour miles_per_hour", {mile / 3600, 0, velocity}},
    {"", "standard_free_fall gravity", {gravity, 0, acceleration}},
    {"Gal", "gal", {1, -2, acceleration}},
    {"N", "newton", {1, 0, force}, prefixes},
    {"kgf kp", "kilogram_force kilograms_force force_kilogram kilopond", {gravity, 0, force}},
    {"gf", "gram_force grams_force force_gram pond", {gravity, -3, force}},
    {"lbf", "pound_force pounds_force force_pound", {4.4482216152605, 0, force}, prefixes},
    {"ozf", "ounce_force ounces_force force_ounce", {4.4482216152605 / 16, 0, force}},
    {"", "kip", {4.4482216152605, 3, force}},
    {"", "poundal", {pound * foot, 0, force}},
    {"dyn", "dyne", {1, -5, force}},
    {"Ns", "newton_second", {1, 0, impulse}, prefixes},
    {"Nm", "newton_meter newton_metre", {1, 0, moment}, prefixes},
    {"Nmm", "newton_millimeter newton_millimetre", {1, -3, moment}, prefixes},
    {"Pa", "pascal", {1, 0, pressure}, prefixes},
    {"bar", "bar", {1, 5, pressure}, prefixes},
    {"psi", "", {psi, 0, pressure}, prefixes},
    {"ksi", "", {psi, 3, pressure}},
    {"atm", "atmosphere standard_atmosphere", {101325, 0, pressure}},
    {"at", "technical_atmosphere", {98066.5, 0, pressure}},
    {"mmHg mm_Hg", "torr", {mercury, 0, pressure}},
    {"inHg in_Hg", "", {25.4 * mercury, 0, pressure}},
    {"", "poise", {1, -1, viscosity}},
    {"St", "stokes", {1, -4, diffusivity}},
    {"rad", "radian", {1, 0, angle}, prefixes},
    {"deg °", "degree", {pi / 180, 0, angle}, prefixes},
    {"rev", "revolution turn rotation cycle", {2 * pi, 0, angle}},
    {"Hz", "hertz", {2 * pi, 0, speed}, prefixes},
    {"rps cps", "revolution_per_second revolutions_per_second", {2 * pi, 0, speed}},
    {"rpm", "revolution_per_minute revolutions_per_minute", {2 * pi / 60, 0, speed}, prefixes},
    {"J", "joule", {1, 0, energy}, prefixes},
    {"cal", "calorie", {4.1868, 0, energy}},
    {"eV", "electron_volt electronvolt", {1.602176634, -19, energy}, prefixes},
    {"erg", "erg", {1, -7, energy}},
    {"W", "watt", {1, 0, power}, prefixes},
    {"K °K", "kelvin degK degree_kelvin degrees_kelvin", {1, 0, temperature}, prefixes},
    {"°C ℃",
     "degC deg_C degreeC degreesC degree_C degrees_C celsius degree_Celsius degrees_Celsius",
     {1, 0, temperature, zero_celsius}},
    {"°F ℉",
     "degF deg_F degreeF degreesF degree_F degrees_F fahrenheit degree_Fahrenheit degrees_Fahrenheit",
     {rankine, 0, temperature, zero_fahrenheit}},
    {"°R", "degR deg_R degree_R degrees_R degree_rankine degrees_rankine", {rankine, 0, temperature}},
    {"A", "ampere amp", {1, 0, current}, prefixes},
    {"C", "coulomb", {1, 0, charge}, prefixes},
    {"V", "volt", {1, 0, voltage}, prefixes},
};

struct Prefix {
  std::string_view text;
  int ten;
};
constexpr Prefix all_prefixes[] = {
    {"yotta", 24}, {"zetta", 21}, {"exa", 18},   {"peta", 15},   {"tera", 12},  {"giga", 9},   {"mega", 6},
    {"kilo", 3},   {"hecto", 2},  {"deca", 1},   {"deka", 1},    {"deci", -1},  {"centi", -2}, {"milli", -3},
    {"micro", -6}, {"nano", -9},  {"pico", -12}, {"femto", -15}, {"atto", -18}, {"Y", 24},     {"Z", 21},
    {"E", 18},     {"P", 15},     {"T", 12},     {"G", 9},       {"M", 6},      {"k", 3},      {"h", 2},
    {"da", 1},     {"d", -1},     {"c", -2},     {"m", -3},      {"µ", -6},     {"μ", -6},     {"u", -6},
    {"n", -9},     {"p", -12},    {"f", -15},    {"a", -18},     {"z", -21}};

bool equal_in_any_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

/// True if one of the words, separated by spaces, is `same`.
template <typename Same>
bool any_word(std::string_view words, const Same& same) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (same(words.substr(0, end))) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

/// Neither "feets" nor an s behind a symbol.
bool takes_plural(std::string_view name) {
  return name.size() > 2 && !name.ends_with("feet") && !name.ends_with("inches");
}

const Row* row_of(std::string_view word) {
  for (const Row& row : rows)
    if (any_word(row.symbols, [&](std::string_view symbol) { return symbol == word; })) return &row;
  const std::string_view singular = word.ends_with('s') ? word.substr(0, word.size() - 1) : word;
  for (const Row& row : rows)
    if (any_word(row.words, [&](std::string_view name) {
          return equal_in_any_case(name, word) || (takes_plural(name) && equal_in_any_case(name, singular));
        }))
      return &row;
  return nullptr;
}

}  // namespace

std::optional<UnitValue> unit_of_word(std::string_view word) {
  if (const Row* row = row_of(word)) return row->value;
  for (const Prefix& prefix : all_prefixes) {
    if (!word.starts_with(prefix.text)) continue;
    const Row* row = row_of(word.substr(prefix.text.size()));
    if (row == nullptr || !row->takes_prefix) continue;
    UnitValue value = row->value;
    value.ten += prefix.ten;
    return value;
  }
  return std::nullopt;
}

bool has_odd_prefix(std::string_view word) {
  return !unit_of_word(word) && std::ranges::any_of(all_prefixes, [&](const Prefix& prefix) {
    return word.starts_with(prefix.text) && row_of(word.substr(prefix.text.size())) != nullptr;
  });
}

}  // namespace trivet::project
