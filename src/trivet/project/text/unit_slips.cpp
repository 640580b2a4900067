// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/unit_slips.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/foundation/problems.h"

namespace trivet::project {
namespace {

/// "980" and "rmp" of "980 rmp"; two empty ones of another text.
std::pair<std::string, std::string> number_and_unit(std::string_view text) {
  const std::size_t digit = text.find_last_of("0123456789", text.find_first_not_of("+-.0123456789eE"));
  const std::size_t unit = digit == std::string_view::npos ? digit : text.find_first_not_of(" \t", digit + 1);
  if (unit == std::string_view::npos) return {};
  return {std::string(text.substr(0, digit + 1)), std::string(text.substr(unit))};
}

/// The unit of this quantity of which a word is probably a misspelling.
std::string meant_unit(const std::string& unit, Quantity quantity) {
  static constexpr std::array usual = {"mm",    "cm",   "kg",    "rpm",    "Hz",    "rad/s",   "min",  "ms",
                                       "deg",   "rad",  "kN",    "N m",    "mm/s",  "m/s",     "km/h", "m/s2",
                                       "N/mm",  "N/m",  "kN/mm", "N s/mm", "N s/m", "N m/rad", "Pa",   "MPa",
                                       "kg m2", "degC", "mm2",   "kg/m3",  "1/min", "kN s/m",  "bar",  "µm/s"};
  if (unit.size() < 2) return "";
  std::vector<std::string> candidates;
  for (const char* one : usual)
    if (to_si(std::string("1 ") + one, quantity)) candidates.emplace_back(one);
  return foundation::nearest_name(unit, candidates);
}

constexpr std::array<std::array<Quantity, 3>, 2> motions_in_si = {
    {{Quantity::length, Quantity::velocity, Quantity::acceleration},
     {Quantity::angle, Quantity::angular_velocity, Quantity::angular_acceleration}}};
constexpr std::array plurals = {"displacements", "velocities", "accelerations"};

}  // namespace

std::string other_motion_advice(std::string_view text, Quantity quantity, std::string_view where, bool density) {
  if (!where.starts_with("excitations.") && !where.starts_with("limit_lines.")) return "";
  for (const auto& kinds : motions_in_si) {
    if (std::ranges::find(kinds, quantity) == kinds.end()) continue;
    for (std::size_t k = 0; k < kinds.size(); ++k)
      if (kinds[k] != quantity && (density ? to_density(text, kinds[k]) : to_si(text, kinds[k])))
        return fmt::format("add quantity = \"{}\" if {} are meant, or ",
                           assembly::motion_name(assembly::motion_quantities[k]), plurals[k]);
  }
  return "";
}

std::string number_remedy(Quantity quantity) {
  if (quantity == Quantity::pure) return "give a plain number";
  if (quantity == Quantity::angular_frequency)
    return "give a text with a unit: \"5 Hz\", \"300 rpm\" or \"31.4 rad/s\"";
  return fmt::format("give a number in {0}, or a text with a unit that converts to {0}", si_unit(quantity));
}

std::string unit_remedy(std::string_view text, Quantity quantity, std::string_view where) {
  if (quantity == Quantity::pure) return "give a plain number";
  const auto [number, unit] = number_and_unit(text);
  if (const std::string meant = meant_unit(unit, quantity); !meant.empty() && !unit_ratio(unit, unit))
    return "did you mean \"" + number + " " + meant + "\"?";
  return other_motion_advice(text, quantity, where) + number_remedy(quantity);
}

}  // namespace trivet::project
