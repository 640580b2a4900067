// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "trivet/project/text/units.h"

/// Units that belong to no single quantity: those of spectral densities, and the ratio of two units (units.cpp).
namespace trivet::project {

/// SI unit of a spectral density of this quantity over hertz, "(m/s2)2/Hz", and the value in it of a text:
/// "0.04 g^2/Hz" → 3.8468 for an acceleration.
[[nodiscard]] std::string density_unit(Quantity quantity);
[[nodiscard]] tl::expected<double, std::string> to_density(std::string_view text, Quantity quantity);

/// How many `other` a `unit` has: 1000 for "kN/mm" and "N/mm"; none if they measure different quantities or one is not
/// a unit.
[[nodiscard]] std::optional<double> unit_ratio(const std::string& unit, const std::string& other);

}  // namespace trivet::project
