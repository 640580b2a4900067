// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/axis_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "trivet/project/text/model_path.h"

namespace trivet::results {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 11> units = {{{"proportional", "s"},
                                                                        {"coefficient", "N s/m"},
                                                                        {"mass", "kg"},
                                                                        {"angle", "rad"},
                                                                        {"phase", "rad"},
                                                                        {"xx", "kg m²"},
                                                                        {"yy", "kg m²"},
                                                                        {"zz", "kg m²"},
                                                                        {"xy", "kg m²"},
                                                                        {"xz", "kg m²"},
                                                                        {"yz", "kg m²"}}};

/// Keys in the field's words.
constexpr std::array<std::pair<const char*, const char*>, 12> known_keys = {{{"scale", "stiffness scale"},
                                                                             {"stiffening", "dynamic stiffening"},
                                                                             {"proportional", "proportional damping δ"},
                                                                             {"coefficient", "damping coefficient"},
                                                                             {"loss_factor", "loss factor"},
                                                                             {"mass", "mass"},
                                                                             {"xx", "moment of inertia xx"},
                                                                             {"yy", "moment of inertia yy"},
                                                                             {"zz", "moment of inertia zz"},
                                                                             {"xy", "product of inertia xy"},
                                                                             {"xz", "product of inertia xz"},
                                                                             {"yz", "product of inertia yz"}}};

/// A component of an array or of an adjustment: the name of the whole, and the unit of its numbers without a unit.
struct ComponentOf {
  const char *table, *words, *unit;
};
constexpr std::array<ComponentOf, 12> component_tables = {{{"at", "place", "m"},
                                                           {"from_at", "place of the foot", "m"},
                                                           {"position", "position", "m"},
                                                           {"center_of_mass", "centre of mass", "m"},
                                                           {"moved", "shift", "m"},
                                                           {"center_moved", "shift of the centre of mass", "m"},
                                                           {"translation", "stiffness", "N/m"},
                                                           {"rotation", "rotational stiffness", "N m/rad"},
                                                           {"force", "force", "N"},
                                                           {"moment", "moment", "N m"},
                                                           {"stiffness_factor", "stiffness factor", ""},
                                                           {"inertia_about_center", "inertia factor", ""}}};

const ComponentOf* component_table(const std::vector<std::string>& keys) {
  if (keys.size() < 4) return nullptr;
  const bool damps = keys[keys.size() - 3] == "damping";  // translation and rotation of a damping have other units
  const auto found = std::find_if(component_tables.begin(), component_tables.end(),
                                  [&](const ComponentOf& one) { return keys[keys.size() - 2] == one.table; });
  return damps || found == component_tables.end() ? nullptr : found;
}

int digits_on(const project::DesignAxis& axis) {
  constexpr int usual = 5, most = 17;
  const double steps = axis.points - 1;
  const double step = axis.logarithmic
      ? std::expm1(std::log(axis.to / axis.from) / steps)
      : (axis.to - axis.from) / steps / std::max(std::abs(axis.from), std::abs(axis.to));
  return std::clamp(1 + static_cast<int>(std::ceil(-std::log10(step))), usual, most);
}

}  // namespace

std::string axis_name(const project::DesignAxis& axis) {
  const std::vector<std::string> keys = project::path_keys(axis.parameter);
  if (axis.name != axis.parameter || keys.size() < 2) return axis.name;
  if (const ComponentOf* part = component_table(keys))
    return fmt::format("{} {} of {}", part->words, keys.back(), keys[1]);
  std::string words = keys.back();
  std::replace(words.begin(), words.end(), '_', ' ');
  for (const auto& [key, meaning] : known_keys)
    if (keys.back() == key) words = meaning;
  return keys.size() > 2 ? words + " of " + keys[1] : words;
}

std::string axis_unit(const project::DesignAxis& axis) {
  if (!axis.unit.empty()) return axis.unit;
  const std::vector<std::string> keys = project::path_keys(axis.parameter);
  if (const ComponentOf* part = component_table(keys)) return part->unit;
  const auto found = std::find_if(units.begin(), units.end(),
                                  [&](const auto& known) { return !keys.empty() && keys.back() == known.first; });
  return found == units.end() ? "" : found->second;
}

bool is_pure_number(const project::DesignAxis& axis) {
  const std::vector<std::string> keys = project::path_keys(axis.parameter);
  if (keys.empty() || !axis_unit(axis).empty()) return false;
  static constexpr std::array<const char*, 7> pure = {
      "scale", "stiffening", "creep", "loss_factor", "damping_factor", "mass_about_center", "modal_factor"};
  return component_table(keys) || std::find(pure.begin(), pure.end(), keys.back()) != pure.end();
}

std::string axis_value(double value, const project::DesignAxis& axis) {
  const std::string unit = axis_unit(axis);
  return fmt::format("{:.{}g}{}", value, digits_on(axis), unit.empty() ? "" : " " + unit);
}

}  // namespace trivet::results
