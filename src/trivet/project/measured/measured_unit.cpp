// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/measured_unit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {
namespace {

std::string without_parentheses(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  text.erase(0, text.find_first_not_of(' '));
  if (text.size() > 2 && text.front() == '(' && text.find(')') == text.size() - 1)
    return text.substr(1, text.size() - 2);
  return text;
}

/// A force or a moment.
struct Load {
  double factor = 1;  ///< to SI
  bool turns = false;
};

std::optional<Load> load_of(const std::string& text) {
  for (const Quantity quantity : {Quantity::force, Quantity::moment})
    if (const auto value = to_si("1 " + without_parentheses(text), quantity))
      return Load{*value, quantity == Quantity::moment};
  return std::nullopt;
}

std::optional<MeasuredUnit> unit_without_load(const std::string& text) {
  for (const Quantity quantity :
       {Quantity::length, Quantity::velocity, Quantity::acceleration, Quantity::angle, Quantity::angular_velocity,
        Quantity::angular_acceleration, Quantity::force, Quantity::moment})
    if (const auto value = to_si("1 " + without_parentheses(text), quantity))
      return MeasuredUnit{quantity, *value, false, text};
  return std::nullopt;
}

/// Two units that are for the same functions.
bool overlap(const MeasuredUnit& a, const MeasuredUnit& b) {
  return a.quantity == b.quantity && (!a.per_load || !b.per_load || a.load_turns == b.load_turns);
}

}  // namespace

std::optional<MeasuredUnit> measured_unit(const std::string& text) {
  if (auto plain = unit_without_load(text)) return plain;
  const std::size_t slash = text.rfind('/');
  if (slash == std::string::npos) return std::nullopt;
  auto unit = unit_without_load(text.substr(0, slash));
  const auto load = load_of(text.substr(slash + 1));
  if (!unit || !load) return std::nullopt;
  unit->factor /= load->factor;
  unit->per_load = true;
  unit->text = text;
  unit->load = load->factor;
  unit->load_turns = load->turns;
  return unit;
}

std::optional<GivenUnits> read_given_units(TableReader& reader) {
  if (!reader.has("unit")) return GivenUnits{};
  const auto texts = reader.texts("unit", "\"g/N\"");
  if (!texts) return std::nullopt;
  GivenUnits units;
  if (texts->empty()) return reader.error("unit", "[]", "one unit or several", "remove the key"), std::nullopt;
  for (const std::string& text : *texts) {
    const auto unit = measured_unit(text);
    if (!unit) {
      reader.error("unit", foundation::quoted(text), "it is a unit of a motion or a force, perhaps per force",
                   "for instance unit = \"m/s2\" or unit = \"(mm/s)/N\"");
      return std::nullopt;
    }
    for (const MeasuredUnit& other : units)
      if (overlap(other, *unit)) {
        reader.error("unit", fmt::format("{} and {}", foundation::quoted(other.text), foundation::quoted(text)),
                     "several units are of different quantities, or per force and per moment",
                     "for instance unit = [\"g/N\", \"(rad/s2)/N\"]");
        return std::nullopt;
      }
    units.push_back(*unit);
  }
  return units;
}

std::string unit_words(const GivenUnits& units) {
  std::vector<std::string> quoted;
  for (const MeasuredUnit& unit : units) quoted.push_back(foundation::quoted(unit.text));
  return units.size() == 1 ? "unit = " + quoted.front() + " of the project"
                           : fmt::format("unit = [{}] of the project", fmt::join(quoted, ", "));
}

bool is_motion(Quantity quantity) { return quantity != Quantity::force && quantity != Quantity::moment; }

bool is_rotation(Quantity quantity) { return underived(quantity) == Quantity::angle || quantity == Quantity::moment; }

int derivatives_of(Quantity quantity) {
  if (quantity == Quantity::velocity || quantity == Quantity::angular_velocity) return 1;
  return quantity == Quantity::acceleration || quantity == Quantity::angular_acceleration ? 2 : 0;
}

Quantity underived(Quantity quantity) {
  if (quantity == Quantity::velocity || quantity == Quantity::acceleration) return Quantity::length;
  if (quantity == Quantity::angular_velocity || quantity == Quantity::angular_acceleration) return Quantity::angle;
  return quantity;
}

}  // namespace trivet::project
