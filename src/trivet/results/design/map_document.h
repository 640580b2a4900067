// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/design/map_colours.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/map/design_map.h"

namespace trivet::results {

/// Of the cases on a map: all findings, or a row for each with the rule that governs it.
enum class Findings { all, governing };

/// The feasible share of a map, the governing rules, the best design and the verdict on every case; in JSON all but the
/// grid, which map_json.h writes.
[[nodiscard]] Document map_document(const study::DesignMap& map, Findings findings = Findings::all);
/// @param colours  of all maps that are shown with this one
[[nodiscard]] Document map_document(const study::DesignMap& map, const MapColours& colours,
                                    Findings findings = Findings::all);

/// For people: maps of several pairs of parameters, side by side and one after another.
[[nodiscard]] Document map_pairs_document(const std::vector<study::DesignMap>& maps, Findings findings = Findings::all);

}  // namespace trivet::results
