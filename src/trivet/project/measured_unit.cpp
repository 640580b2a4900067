// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured_unit.h"

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

std::optional<double> load_factor(const std::string& text) {
  for (const Quantity quantity : {Quantity::force, Quantity::moment})
    if (const auto value = to_si("1 " + without_parentheses(text), quantity)) return *value;
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

}  // namespace

std::optional<MeasuredUnit> measured_unit(const std::string& text) {
  if (auto plain = unit_without_load(text)) return plain;
  const std::size_t slash = text.rfind('/');
  if (slash == std::string::npos) return std::nullopt;
  auto unit = unit_without_load(text.substr(0, slash));
  const auto load = load_factor(text.substr(slash + 1));
  if (!unit || !load) return std::nullopt;
  unit->factor /= *load;
  unit->per_load = true;
  unit->text = text;
  unit->load = *load;
  return unit;
}

std::optional<MeasuredUnit> read_measured_unit(TableReader& reader) {
  const auto text = reader.text("unit");
  if (!text) return std::nullopt;
  auto unit = measured_unit(*text);
  if (!unit)
    reader.error("unit", foundation::quoted(*text), "it is a unit of a motion or a force, perhaps per force",
                 "for instance unit = \"m/s2\" or unit = \"(mm/s)/N\"");
  return unit;
}

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
