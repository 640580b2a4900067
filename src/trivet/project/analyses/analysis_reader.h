// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/analyses/analysis_table.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/project/analyses/selection_reader.h"

namespace trivet::project {

/// How one analysis is read. Each is defined in NAME_analysis.cpp.
struct AnalysisReader {
  const char* name = nullptr;                            ///< of its table; set by analysis_readers()
  bool at_top = false;                                   ///< its table is one of the file, not of [analyses]
  Drive drive = Drive::none;                             ///< the model must have an excitation of this kind
  bool searches_peaks = false;                           ///< its cost is that of a search for peaks
  bool of_large_systems = false;                         ///< measured up to `most_coordinates`
  double (*curves)(const Analyses& request) = nullptr;   ///< number of curves, if not that of `selection.of`
  bool (*moves_by_itself)(const Node& table) = nullptr;  ///< true if it needs no excitation
  void (*check)(const Analyses& request, const model::System& system,
                foundation::Problems& problems) = nullptr;  ///< checks the analysis against a valid model
  const char* keys = nullptr;                               ///< JSON Schema of its keys: `properties`, `required` …
  // Set by read_into:
  void (*read)(TableReader& reader, const ResultNames& names, const SymbolTable& symbols, Analyses& into) = nullptr;
  void (*remove)(Analyses& from) = nullptr;
  const Analysis* (*of)(const Analyses& request) = nullptr;  ///< nullptr: it is not requested
  std::optional<assembly::Band> (*band)(const Analyses& request) = nullptr;
};

/// The row of an analysis that is a field of `Analyses`, and that a function reads from its table.
template <auto field, auto read_table>
[[nodiscard]] constexpr AnalysisReader read_into(AnalysisReader row) {
  row.read = [](TableReader& reader, const ResultNames& names, const SymbolTable& symbols, Analyses& into) {
    into.*field = read_table(reader, names, symbols);
  };
  row.remove = [](Analyses& from) { (from.*field).reset(); };
  row.of = [](const Analyses& request) -> const Analysis* { return request.*field ? &*(request.*field) : nullptr; };
  row.band = [](const Analyses& request) -> std::optional<assembly::Band> {
    using Request = std::decay_t<decltype(*(request.*field))>;
    if constexpr (std::derived_from<Request, BandAnalysis>)
      if (request.*field) return (request.*field)->band;
    return std::nullopt;
  };
  return row;
}

#define TRIVET_READER(name) extern const AnalysisReader name##_analysis;
TRIVET_ANALYSES(TRIVET_READER)
#undef TRIVET_READER

/// All of them by their names, in the order of the table.
[[nodiscard]] const std::vector<AnalysisReader>& analysis_readers();

/// Reads the analyses whose tables are in [analyses], or at the top of the file, into `result`, and reports missing
/// excitations.
void read_independent_analyses(TableReader& owner, bool at_top, const ResultNames& names, const SymbolTable& symbols,
                               Analyses& result);

/// Reports analyses that do not suit the model.
/// @param computed  false for an analysis of which requirements only take the settings: one that has no result is then
///                  not judged, with the reason, beside all others
void check_analyses(const model::System& system, const Analyses& request,
                    const std::function<bool(const std::string&)>& computed, foundation::Problems& problems);

}  // namespace trivet::project
