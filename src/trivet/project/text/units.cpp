// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/units.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"

#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <shared_mutex>
#include <stdexcept>
#include <tuple>

namespace trivet::project {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

constexpr std::size_t longest_unit = 48;
using foundation::standard_gravity;

std::string unit_database;  // empty: that of the system

/// UDUNITS-2 with angle and energy as base dimensions and the units of rotating machinery added.
class UnitSystem {
 public:
  UnitSystem() {
    ut_set_error_message_handler(ut_ignore);
    system_ = ut_read_xml(unit_database.empty() ? nullptr : unit_database.c_str());
    if (!system_)
      throw std::runtime_error(
          "the unit database of UDUNITS-2 cannot be read" +
          (unit_database.empty() ? "; install the package libudunits2-data" : ": " + unit_database));
    const Unit radian(ut_new_base_unit(system_));
    name("radian", "rad", radian.get());
    name("degree", "deg", Unit(ut_scale(std::numbers::pi / 180, radian.get())).get());
    name("degrees", "°", Unit(ut_scale(std::numbers::pi / 180, radian.get())).get());
    const Unit turn(ut_scale(2 * std::numbers::pi, radian.get()));
    name("revolution", "rev", turn.get());
    const Unit second(parsed("s"));
    const Unit hertz(ut_divide(turn.get(), second.get()));
    name("hertz", "Hz", hertz.get());
    name("rpm", "rpm", Unit(ut_scale(1.0 / 60, hertz.get())).get());
    const Unit joule(ut_new_base_unit(system_));
    name("joule", "J", joule.get());
    name("watt", "W", Unit(ut_divide(joule.get(), second.get())).get());
    for (const auto& [word, symbol, joules] :
         {std::tuple{"calorie", "cal", 4.1868}, {"electron_volt", "eV", 1.602176634e-19}, {"erg", "erg", 1e-7}})
      name(word, symbol, Unit(ut_scale(joules, joule.get())).get());
    for (const char* plural : {"radians"}) name(plural, "rad", radian.get());
    for (const char* plural : {"turn", "turns", "revolutions"}) name(plural, "rev", turn.get());
    for (const char* plural : {"joules"}) name(plural, "J", joule.get());
    // Remove the units that the database derives from the dimensionless radian and from the newton metre of energy:
    // they would count as numbers or moments.
    for (const char* word : {"circle",
                             "circles",
                             "arc_degree",
                             "arc_degrees",
                             "angular_degree",
                             "angular_degrees",
                             "arcdeg",
                             "arc_minute",
                             "arc_minutes",
                             "angular_minute",
                             "angular_minutes",
                             "arcminute",
                             "arcminutes",
                             "arcmin",
                             "arc_second",
                             "arc_seconds",
                             "angular_second",
                             "angular_seconds",
                             "arcsecond",
                             "arcseconds",
                             "arcsec",
                             "grade",
                             "grades",
                             "steradian",
                             "steradians",
                             "sr",
                             "watts",
                             "calories",
                             "IT_calorie",
                             "IT_calories",
                             "thermochemical_calorie",
                             "thermochemical_calories",
                             "electron_volts",
                             "electronvolt",
                             "electronvolts",
                             "ergs",
                             "Btu",
                             "Btus",
                             "BTU",
                             "BTUs",
                             "IT_Btu",
                             "IT_Btus",
                             "EC_therm",
                             "EC_therms",
                             "US_therm",
                             "US_therms",
                             "therm",
                             "therms",
                             "thm",
                             "thermie",
                             "ton_TNT",
                             "tons_TNT",
                             "horsepower",
                             "British_horsepower",
                             "boiler_horsepower",
                             "shaft_horsepower",
                             "metric_horsepower",
                             "electric_horsepower",
                             "hp",
                             "horsepowers"})
      forget(word);
    name("newton_meter", "Nm", Unit(parsed("N m")).get());
    const Unit pound(parsed("lb")), pound_force(parsed("lbf")), foot(parsed("ft")), mile(parsed("mile"));
    name("ounce", "oz", Unit(ut_scale(1.0 / 16, pound.get())).get());  // not the fluid ounce of the database
    const Unit foot_per_second_squared(parsed("ft/s2"));
    name("slug", "slug", Unit(ut_divide(pound_force.get(), foot_per_second_squared.get())).get());
    const Unit hour(parsed("hour"));
    name("mile_per_hour", "mph", Unit(ut_divide(mile.get(), hour.get())).get());
    name("revolution_per_second", "rps", hertz.get());
    name("kilopond", "kp", Unit(parsed("kgf")).get());
    for (const char* word : {"lbs", "lbm"}) name(word, word, pound.get());
    name("newton_second", "Ns", Unit(parsed("N s")).get());
    name("newton_millimeter", "Nmm", Unit(parsed("N mm")).get());
    name("nautical_mile", "nmi", Unit(ut_scale(1852, Unit(parsed("m")).get())).get());
  }
  ~UnitSystem() { ut_free_system(system_); }
  UnitSystem(const UnitSystem&) = delete;
  UnitSystem& operator=(const UnitSystem&) = delete;

  ut_unit* parsed(const std::string& text) const { return ut_parse(system_, text.c_str(), UT_UTF8); }

  /// A unit by its name or symbol as it is, without a prefix.
  [[nodiscard]] bool has(const std::string& word) const {
    return Unit(ut_get_unit_by_name(system_, word.c_str())) || Unit(ut_get_unit_by_symbol(system_, word.c_str()));
  }

 private:
  void forget(const char* word) {
    for (const ut_encoding encoding : {UT_ASCII, UT_LATIN1, UT_UTF8}) {
      ut_unmap_name_to_unit(system_, word, encoding);
      ut_unmap_symbol_to_unit(system_, word, encoding);
    }
  }

  void name(const char* word, const char* symbol, const ut_unit* unit) {
    for (const ut_encoding encoding : {UT_ASCII, UT_LATIN1, UT_UTF8}) {
      ut_unmap_name_to_unit(system_, word, encoding);
      ut_unmap_symbol_to_unit(system_, symbol, encoding);
    }
    ut_map_name_to_unit(word, UT_UTF8, unit);
    ut_map_symbol_to_unit(symbol, UT_UTF8, unit);
  }

  ut_system* system_ = nullptr;
};

/// Read at the first unit; plain numbers do not need it.
const UnitSystem& unit_system() {
  static const UnitSystem system;
  return system;
}

/// True for a unit of letters and operators, with digits only as exponents right after a letter, a ^ or a minus. The
/// library also reads dates, logarithms, offsets and numbers inside a unit ("12 500 kg" would be 12 × 500 kg).
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

/// True if an SI prefix may stand before the unit: before units of the SI, and those usual with prefixes.
bool takes_prefix(std::string_view unit) {
  static constexpr std::array<std::string_view, 40> known = {
      "m",      "g",      "s",      "N",      "Pa",     "J",     "W",    "Hz",    "rad",    "K",
      "rpm",    "deg",    "bar",    "t",      "l",      "L",     "eV",   "Nm",    "metre",  "meter",
      "gram",   "gramme", "second", "newton", "pascal", "joule", "watt", "hertz", "radian", "degree",
      "kelvin", "tonne",  "liter",  "litre",  "bars",   "°",     "psi",  "lbf",   "Ns",     "Nmm"};
  if (std::ranges::find(known, unit) != known.end()) return true;
  return unit.ends_with('s') && unit.size() > 3 && takes_prefix(unit.substr(0, unit.size() - 1));
}

/// A word of the unit that is read as an SI prefix before a unit that takes none, "nmi" as a nano-mile; empty if none.
std::string word_with_odd_prefix(std::string_view text) {
  static constexpr std::array<std::string_view, 40> prefixes = {
      "yotta", "zetta", "exa",   "peta",  "tera",  "giga", "mega", "kilo",  "hecto", "deca",
      "deka",  "deci",  "centi", "milli", "micro", "nano", "pico", "femto", "atto",  "Y",
      "Z",     "E",     "P",     "T",     "G",     "M",    "k",    "h",     "da",    "d",
      "c",     "m",     "µ",     "μ",     "u",     "n",    "p",    "f",     "a",     "z"};
  const auto letter = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80 || c == '_';
  };
  for (std::size_t from = 0; from < text.size();) {
    if (!letter(text[from])) {
      ++from;
      continue;
    }
    std::size_t to = from;
    while (to < text.size() && letter(text[to])) ++to;
    std::string word(text.substr(from, to - from));
    from = to;
    for (const char* power : {"²", "³"})
      if (word.ends_with(power)) word.resize(word.size() - std::string(power).size());
    if (word.empty() || unit_system().has(word)) continue;
    const auto fits = [&](std::string_view prefix) {
      return word.starts_with(prefix) && takes_prefix(std::string_view(word).substr(prefix.size()));
    };
    const auto has_prefix = [&](std::string_view prefix) {
      return word.starts_with(prefix) && unit_system().has(word.substr(prefix.size()));
    };
    if (std::ranges::none_of(prefixes, fits) && std::ranges::any_of(prefixes, has_prefix)) return word;
  }
  return "";
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Conversion from one unit to another, or the reason why there is none.
struct Conversion {
  std::shared_ptr<const cv_converter> converter;
  std::string reason;
};

/// Why a unit of another quantity is rejected. Where a word of mass stands for a force, as in the "lb/in" and "kg/mm"
/// of catalogues, the reason has the unit to write.
std::string reason_against_other_quantity(const std::string& from, const ut_unit* target) {
  for (const MassForForce& word : masses_for_forces()) {
    const std::string meant = with_word_replaced(from, word.mass, word.force);
    if (meant == from) continue;
    const Unit unit(unit_system().parsed(meant));
    if (unit && ut_are_convertible(unit.get(), target) != 0)
      return foundation::quoted(from) + " has a mass where a force is expected; write \"" + meant + "\"";
  }
  return foundation::quoted(from) + " measures another quantity";
}

Conversion new_conversion(const std::string& given, const std::string& to) {
  const bool acceleration = to == si_unit(Quantity::acceleration) || to == density_unit(Quantity::acceleration);
  const std::string spelled = database_spelling(given, to),
                    from = acceleration ? with_word_replaced(spelled, "g", "standard_free_fall") : spelled;
  if (std::string reason = reason_against_ambiguous(from, to); !reason.empty()) return {nullptr, std::move(reason)};
  const Unit unit(unit_system().parsed(from));
  if (!unit) return {nullptr, foundation::quoted(given) + " is not a unit"};
  if (const std::string word = word_with_odd_prefix(from); !word.empty())
    return {nullptr, "\"" + word + "\" is no unit; SI prefixes stand before units of the SI only"};
  const Unit target(unit_system().parsed(to));
  if (!target) return {nullptr, foundation::quoted(to) + " is not a unit"};
  if (!ut_are_convertible(unit.get(), target.get()))
    return {nullptr, reason_against_other_quantity(given, target.get())};
  const std::shared_ptr<cv_converter> converter(ut_get_converter(unit.get(), target.get()), cv_free);
  const double zero = cv_convert_double(converter.get(), 0), one = cv_convert_double(converter.get(), 1),
               two = cv_convert_double(converter.get(), 2);
  const bool is_linear = std::abs(two - 2 * one + zero) <= 1e-12 * std::abs(two);
  const bool may_have_offset = to == si_unit(Quantity::temperature);
  if (!is_linear || (zero != 0 && !may_have_offset))
    return {nullptr, foundation::quoted(given) + " has an offset or is logarithmic"};
  return {converter, ""};
}

/// Looks up each pair once, under a lock: the library has global state, and many designs are read in parallel.
Conversion conversion(const std::string& from, const std::string& to) {
  static std::shared_mutex access;
  static std::map<std::pair<std::string, std::string>, Conversion> known;
  {
    const std::shared_lock reading(access);
    if (const auto found = known.find({from, to}); found != known.end()) return found->second;
  }
  const std::unique_lock writing(access);
  if (const auto found = known.find({from, to}); found != known.end()) return found->second;
  return known.emplace(std::pair(from, to), new_conversion(from, to)).first->second;
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

/// Factor of a usual unit, the same as that of the database; 0 for others. Reading the database takes longer than all
/// else that a small analysis needs.
double usual_factor(std::string_view unit, std::string_view si) {
  struct Usual {
    std::string_view unit, si;
    double factor;
  };
  static constexpr std::array<Usual, 22> usual = {{{"mm", "m", 1e-3},
                                                   {"cm", "m", 1e-2},
                                                   {"Hz", "rad/s", 2 * std::numbers::pi},
                                                   {"rpm", "rad/s", 2 * std::numbers::pi / 60},
                                                   {"deg", "rad", std::numbers::pi / 180},
                                                   {"g", "kg", 1e-3},
                                                   {"t", "kg", 1e3},
                                                   {"ms", "s", 1e-3},
                                                   {"mm/s", "m/s", 1e-3},
                                                   {"kN", "N", 1e3},
                                                   {"kN m", "N m", 1e3},
                                                   {"N/mm", "N/m", 1e3},
                                                   {"kN/m", "N/m", 1e3},
                                                   {"kN/mm", "N/m", 1e6},
                                                   {"kN m/rad", "N m/rad", 1e3},
                                                   {"N s/mm", "N s/m", 1e3},
                                                   {"kN s/m", "N s/m", 1e3},
                                                   {"kPa", "Pa", 1e3},
                                                   {"bar", "Pa", 1e5},
                                                   {"MPa", "Pa", 1e6},
                                                   {"GPa", "Pa", 1e9},
                                                   {"N/mm2", "Pa", 1e6}}};
  const auto found =
      std::ranges::find_if(usual, [&](const Usual& known) { return known.unit == unit && known.si == si; });
  return found == usual.end() ? 0 : found->factor;
}

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
  if (unit_text == expected) return value;  // SI needs no database; reading it takes longer than a small analysis
  if (const double factor = usual_factor(unit_text, expected); factor > 0) return value * factor;
  const Conversion found = conversion(std::string(unit_text), expected);
  if (!found.converter) return tl::make_unexpected(found.reason);
  return cv_convert_double(found.converter.get(), value);
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
  if (!found.converter) return std::nullopt;
  return cv_convert_double(found.converter.get(), 1);
}

void use_unit_database(const std::string& file) { unit_database = file; }

}  // namespace trivet::project
