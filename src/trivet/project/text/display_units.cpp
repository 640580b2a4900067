// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/display_units.h"

#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

using Member = std::string DisplayUnits::*;
constexpr std::array<std::pair<const char*, Member>, 4> base_units = {{{"m", &DisplayUnits::length},
                                                                       {"N", &DisplayUnits::force},
                                                                       {"rad", &DisplayUnits::angle},
                                                                       {"kg", &DisplayUnits::mass}}};
constexpr std::array levels = {Level::amplitude, Level::peak_to_peak, Level::rms};

struct Kind {
  const char* key;
  const char* si;
  const char* examples;
};
constexpr std::array<Kind, 5> kinds = {{{"length", "m", "\"mm\", \"in\" or \"mil\""},
                                        {"force", "N", "\"kN\" or \"lbf\""},
                                        {"angle", "rad", "\"deg\" or \"mrad\""},
                                        {"mass", "kg", "\"lb\""},
                                        {"frequency", "rad/s", "\"Hz\" or \"rpm\""}}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// "m/s²" → "m/s2", which `parsed_unit` reads.
std::string with_plain_powers(std::string unit) {
  for (const auto& [power, digit] : {std::pair{"²", "2"}, std::pair{"³", "3"}, std::pair{"·", " "}})
    for (std::size_t at = unit.find(power); at != std::string::npos; at = unit.find(power))
      unit.replace(at, std::string(power).size(), digit);
  return unit;
}

/// The words of a unit, each replaced if it is a base unit.
std::string replaced(const DisplayUnits& units, const std::string& si_unit) {
  std::string result;
  for (std::size_t at = 0; at < si_unit.size();) {
    std::size_t end = at;
    while (end < si_unit.size() && is_letter(si_unit[end])) ++end;
    if (end == at) {
      result += si_unit[at++];
      continue;
    }
    std::string word = si_unit.substr(at, end - at);
    for (const auto& [name, member] : base_units)
      if (word == name) {
        word = units.*member;
        break;
      }
    result += word;
    at = end;
  }
  return result;
}

}  // namespace

ShownUnit shown_unit(const DisplayUnits& units, const std::string& si_unit) {
  for (const std::string& density : {std::string("²/Hz"), std::string("²/(rad/s)")}) {
    if (!si_unit.ends_with(density)) continue;
    const std::string of = si_unit.substr(0, si_unit.size() - density.size());
    const bool in_parentheses = of.starts_with('(') && of.ends_with(')');
    const ShownUnit one = shown_unit(units, in_parentheses ? of.substr(1, of.size() - 2) : of);
    return {(in_parentheses ? "(" + one.unit + ")" : one.unit) + density, one.factor * one.factor};
  }
  const std::string unit = replaced(units, si_unit);
  if (unit == si_unit) return {si_unit, 1};
  const auto factor = in_unit({1, with_plain_powers(si_unit)}, with_plain_powers(unit));
  return factor ? ShownUnit{unit, *factor} : ShownUnit{si_unit, 1};
}

ShownUnit shown_frequency(const DisplayUnits& units) {
  if (units.frequency.empty()) return {"rad/s", 1};
  return {units.frequency, in_unit({1, "rad/s"}, units.frequency).value_or(1)};
}

Level shown_level(const DisplayUnits& units, const std::string& si_unit) {
  const bool is_velocity = si_unit == "m/s" || si_unit == "rad/s";
  return units.level.value_or(is_velocity ? Level::rms : Level::amplitude);
}

foundation::Problems set_shown_unit(DisplayUnits& units, const std::string& key, const std::string& value) {
  foundation::Problems problems;
  if (key == "level") {
    for (const Level level : levels)
      if (value == level_name(level)) {
        units.level = level;
        return problems;
      }
    const std::string guess = foundation::nearest_name(value, {"amplitude", "peak_to_peak", "rms"});
    problems.error("display.level", "\"" + value + "\"", "a level is \"amplitude\", \"peak_to_peak\" or \"rms\"",
                   guess.empty() ? "write one of them" : "did you mean \"" + guess + "\"?");
    return problems;
  }
  for (const Kind& kind : kinds) {
    if (key != kind.key) continue;
    const bool composed = key != "frequency" && value.find_first_of(" /*^.()0123456789") != std::string::npos;
    if (value.empty() || composed || !in_unit({1, kind.si}, value)) {
      problems.error("display." + key, "\"" + value + "\"", "it must be a unit of " + key,
                     std::string("write for instance ") + kind.examples);
      return problems;
    }
    if (key == "frequency") units.frequency = value;
    for (const auto& [si, member] : base_units)
      if (std::string(si) == kind.si) units.*member = value;
    return problems;
  }
  std::vector<std::string> known = {"level"};
  for (const Kind& kind : kinds) known.emplace_back(kind.key);
  const std::string guess = foundation::nearest_name(key, known);
  problems.error("display." + key, "unknown key", "known are length, force, angle, mass, frequency and level",
                 guess.empty() ? "remove it" : "did you mean \"" + guess + "\"?");
  return problems;
}

}  // namespace trivet::project
