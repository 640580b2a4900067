// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/law_numbers.h"

#include <fmt/format.h>

namespace trivet::project {

double read_positive(TableReader& reader, const char* key, Quantity quantity) {
  const std::size_t before = reader.errors();
  const double value = reader.required_number(key, quantity);
  if (reader.errors() == before && !(value > 0))
    reader.error(key,
                 fmt::format("{:.6g}{}{}", value, quantity == Quantity::pure ? "" : " ", printed_si_unit(quantity)),
                 "it is > 0", "correct it");
  return value;
}

Quantity force_quantity(bool is_rotation) { return is_rotation ? Quantity::moment : Quantity::force; }
Quantity travel_quantity(bool is_rotation) { return is_rotation ? Quantity::angle : Quantity::length; }
Quantity velocity_quantity(bool is_rotation) { return is_rotation ? Quantity::angular_velocity : Quantity::velocity; }
Quantity stiffness_quantity(bool is_rotation) {
  return is_rotation ? Quantity::moment_per_angle : Quantity::force_per_length;
}

}  // namespace trivet::project
