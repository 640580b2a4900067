// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/selection_reader.h"

namespace trivet::project {

// What maps and requirements have in common.

/// The table `key`: an amplitude, or several of different quantities, for each named result. The unit of a text tells
/// displacement, velocity and acceleration apart; a bare number is of the `usual` quantity.
/// @param scoped  the names for `excitations`, if a limit may be a table {limit, band, excitations}
[[nodiscard]] std::vector<AmplitudeLimit> read_amplitude_limits(TableReader& owner, const std::string& key,
                                                                const ResultNames& names,
                                                                assembly::MotionQuantity usual,
                                                                const SymbolTable* scoped = nullptr);

/// `no_peak`: results that must have no resonance peak.
[[nodiscard]] std::vector<std::string> read_no_peak(TableReader& owner, const ResultNames& names,
                                                    assembly::MotionQuantity quantity);

/// `quantity`: "displacement", "velocity" or "acceleration", if it is there.
[[nodiscard]] std::optional<assembly::MotionQuantity> read_quantity(TableReader& reader);

}  // namespace trivet::project
