// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/axis_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/project/text/model_path.h"
#include "trivet/results/format/in_documents.h"

namespace trivet::results {

namespace {

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

/// Arrays and adjustments of an element or body, whose components are numbers.
constexpr std::array<std::pair<const char*, const char*>, 12> known_tables = {
    {{"at", "place"},
     {"from_at", "place of the foot"},
     {"position", "position"},
     {"center_of_mass", "centre of mass"},
     {"moved", "shift"},
     {"center_moved", "shift of the centre of mass"},
     {"translation", "stiffness"},
     {"rotation", "rotational stiffness"},
     {"force", "force"},
     {"moment", "moment"},
     {"stiffness_factor", "stiffness factor"},
     {"inertia_about_center", "inertia factor"}}};

std::string with_blanks(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

template <std::size_t size>
std::string meaning(const std::array<std::pair<const char*, const char*>, size>& known, const std::string& key) {
  const auto found = std::ranges::find_if(known, [&](const auto& one) { return key == one.first; });
  return found == known.end() ? with_blanks(key) : found->second;
}

/// Words of the number within its part: "place y", "damping translation z", "seat z", "proportional damping δ".
std::string words_in_part(const std::vector<std::string>& keys) {
  const std::string& last = keys.back();
  const bool is_component = last.size() == 1 || keys[keys.size() - 2] == "inertia_about_center";
  if (keys.size() < 4 || !is_component) return meaning(known_keys, last);
  const std::string& table = keys[keys.size() - 2];
  const bool is_stiffness = keys.size() == 4 && keys.front().starts_with("element");
  const bool is_motion = table == "translation" || table == "rotation";
  const std::string whole = is_motion && !is_stiffness ? table : meaning(known_tables, table);
  return (keys.size() == 5 && keys[2] == "damping" ? "damping " : "") + whole + " " + last;
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
  return keys.size() > 2 ? words_in_part(keys) + " of " + keys[1] : with_blanks(keys[0]) + " " + with_blanks(keys[1]);
}

std::string axis_unit(const project::DesignAxis& axis) {
  if (!axis.unit.empty()) return axis.unit;
  return axis.quantity ? project::printed_si_unit(*axis.quantity) : "";
}

bool is_pure_number(const project::DesignAxis& axis) {
  return axis.unit.empty() && axis.quantity == project::Quantity::pure;
}

std::string axis_value(double value, const project::DesignAxis& axis) {
  const std::string unit = axis_unit(axis);
  return fmt::format("{:.{}g}{}", value, digits_on(axis), unit.empty() ? "" : " " + unit);
}

using nonlinear::Parameter;
using nonlinear::SteadyBranch;

const char* varied_word(const SteadyBranch& branch) {
  if (branch.over == Parameter::load_factor) return "load";
  return branch.of_shaft ? "speed" : "frequency";
}

std::string varied_unit(const SteadyBranch& branch, const project::DisplayUnits& display) {
  if (branch.over == Parameter::load_factor) return "times the load";
  return branch.of_shaft ? "rpm" : frequency_unit(display);
}

std::string varied_heading(const SteadyBranch& branch, const project::DisplayUnits& display) {
  if (branch.over == Parameter::load_factor) return "load factor";
  return branch.of_shaft ? "shaft speed [rpm]" : frequency_heading(display);
}

double shown_varied(const SteadyBranch& branch, double parameter, const project::DisplayUnits& display) {
  if (branch.over == Parameter::load_factor) return parameter;
  return branch.of_shaft ? parameter * foundation::rpm_per_rad_s : shown_frequency(display, parameter);
}

}  // namespace trivet::results
