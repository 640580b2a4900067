// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/elements/elastic_force.h"
#include "trivet/project/text/table_reader.h"

/// Laws over the deflection; stops may dissipate as they close (docs/nonlinear.md). All add their problems and return
/// what could be read.
namespace trivet::project {

/// `quadratic`, `cubic` and `polynomial` of a table: coefficients of δ, δ², …
[[nodiscard]] std::optional<elements::PolynomialForce> read_polynomial(TableReader& reader, bool is_rotation);
/// `gap` or `gaps`, `stiffness`, `power`, `dissipation`, `gap_at`.
/// @param ring  instead of the keys gap and gaps: the play within a ring [m]
[[nodiscard]] std::optional<elements::GapStop> read_gap_stop(TableReader& reader, bool is_rotation,
                                                             std::optional<double> ring = std::nullopt);
/// `pressure`, `volume`, `area`, `exponent`, `atmosphere`.
[[nodiscard]] std::optional<elements::GasForce> read_gas_force(TableReader& reader);
/// `rows` or `file`, `interpolation`, `beyond`: force over deflection.
[[nodiscard]] std::optional<elements::ForceCurve> read_force_curve(TableReader& reader, bool is_rotation);

}  // namespace trivet::project
