// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/elements/rubbing_friction.h"
#include "trivet/elements/scalar_law.h"
#include "trivet/project/text/table_reader.h"

/// Laws that dissipate energy (docs/nonlinear.md). All add their problems and return what could be read.
namespace trivet::project {

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
