// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {

// What maps and requirements have in common.

/// The table `key`: an amplitude, or several of different quantities, for each named result. The unit of a text tells
/// displacement, velocity and acceleration apart; a bare number is of the `usual` quantity.
/// @param levels  which may follow the unit
/// @param scoped  the names for `excitations`, if a limit may be a table {limit, band, excitations}
[[nodiscard]] std::vector<AmplitudeLimit> read_amplitude_limits(TableReader& owner, const std::string& key,
                                                                const ResultNames& names,
                                                                assembly::MotionQuantity usual, Levels levels,
                                                                const SymbolTable* scoped = nullptr);

/// `quantity`: "displacement", "velocity" or "acceleration", if it is there.
[[nodiscard]] std::optional<assembly::MotionQuantity> read_quantity(TableReader& reader);

/// Band, excitations and quantity of what is judged: those of its table, else those of response; how far peaks stand
/// out is that of peaks.
template <typename Judged>
void read_scope(TableReader& reader, const SymbolTable& symbols, const Analyses& analyses, Judged& judged) {
  if (analyses.response) {
    judged.band = analyses.response->band;
    judged.quantity = analyses.response->selection.quantity;
    judged.excitations = analyses.response->selection.excitations;
  }
  if (analyses.peaks) {
    judged.min_prominence = analyses.peaks->min_prominence;
    judged.peak_tolerance = analyses.peaks->peak_tolerance;
  }
  if (reader.node("band")) judged.band = read_band(reader, "band");
  if (reader.node("excitations")) judged.excitations = read_selected_harmonic(reader, symbols);
  if (const auto quantity = read_quantity(reader)) judged.quantity = *quantity;
}

/// `no_peak`: results that must have no resonance peak.
[[nodiscard]] std::vector<std::string> read_no_peak(TableReader& owner, const ResultNames& names,
                                                    assembly::MotionQuantity quantity);

}  // namespace trivet::project
