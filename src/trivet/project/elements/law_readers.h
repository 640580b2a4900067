// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/elements/elastic_force.h"
#include "trivet/elements/friction.h"
#include "trivet/elements/scalar_law.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

// Laws over the deflection; stops may dissipate as they close (docs/nonlinear.md). All add their problems and return
// what could be read.

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

// Laws that dissipate energy (docs/nonlinear.md). All add their problems and return what could be read.

/// `quadratic` or `quadratics`, or `rows` or `file`: force over the rate of the deflection.
[[nodiscard]] std::optional<elements::DampingForce> read_damping_curve(TableReader& reader, bool is_rotation);
/// `slip`, `breakaway` and `stiffness`, `sliders`, `berg` or `lugre`.
[[nodiscard]] elements::ScalarLaws read_friction(TableReader& reader, bool is_rotation);
/// `coefficient` and `stiffness`: across a contact.
[[nodiscard]] std::optional<elements::RubbingFriction> read_rubbing_friction(TableReader& reader);
/// `stiffness`, `loss`, `amplitude`, `exponent`.
[[nodiscard]] std::optional<elements::PayneForce> read_payne(TableReader& reader, bool is_rotation);
/// `stiffness`, `slip`, `breakaway`, `stribeck_velocity`, `damping`, `viscous`, `allow_active`.
[[nodiscard]] std::optional<elements::LuGreFriction> read_lugre(TableReader& reader, bool is_rotation);
/// `stiffness`, `force`, `exponent`, `beta`, `gamma`, `asymmetry`, `allow_active`.
[[nodiscard]] std::optional<elements::BoucWen> read_bouc_wen(TableReader& reader, bool is_rotation);

}  // namespace trivet::project
