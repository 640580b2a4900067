// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "trivet/project/text/column_units.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {

// One function per part of an excitation's table.

/// Meaning of the six numbers of an action: amplitudes with units and levels, constant values with units, or factors on
/// a course with units.
enum class ActionNumbers { amplitudes, constants, factors };

/// `on`, `at`, `force`, `moment` and `phase` of a force on a body.
[[nodiscard]] std::optional<model::Action> read_force(TableReader& reader, const model::Description& description,
                                                      const SymbolTable& symbols, ActionNumbers numbers);

/// Only `on` and `at`, of excitations with their own directions.
[[nodiscard]] std::optional<model::Action> read_place(TableReader& reader, const model::Description& description,
                                                      const SymbolTable& symbols);

/// `at`, `translation`, `rotation`, `phase`, `delay`, `elements`, `wave` and `quantity` of a moving ground.
[[nodiscard]] std::optional<model::Action> read_ground_motion(TableReader& reader,
                                                              const model::Description& description,
                                                              const SymbolTable& symbols, ActionNumbers numbers);

/// `rows`, or `file` with columns `time` and `value` or a time response of a universal file: times [s] and values in
/// the unit of the bare numbers of `value`, n × 2.
[[nodiscard]] std::optional<Eigen::MatrixXd> read_rows_over_time(TableReader& history, const ColumnQuantity& value);

/// Quantity of the course of an action with factors: a force, a moment, or a motion.
[[nodiscard]] Quantity course_quantity(const model::Action& action);

/// `psd`: rows over frequency, a file, a measured history, levels of bands, a road class, or one level over a band.
[[nodiscard]] std::optional<excitation::Spectrum> read_spectrum(TableReader& reader, const std::string& key,
                                                                const model::Action& action);

/// `history`: a file, rows over time, or a pulse with its name.
[[nodiscard]] std::optional<excitation::Signal> read_history(TableReader& reader, const std::string& key,
                                                             const model::Action& action);

/// `table` or `engine` of an excitation by orders, in the axes of the body.
[[nodiscard]] std::optional<model::Orders> read_orders(TableReader& reader);

/// The unbalance of a rotor: mass_eccentricity, or grade with rotor_mass and service_speed; axis, direction, phase.
/// @returns the service speed [rad/s]; 0: not given
double read_unbalance(TableReader& reader, model::Action& action);

/// Reads the table `excitations` into the description and reports its problems.
void read_excitations(TableReader& root, model::Description& description, SymbolTable& symbols);

}  // namespace trivet::project
