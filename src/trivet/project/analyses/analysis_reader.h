// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "trivet/project/analyses/analysis.h"
#include "trivet/project/analyses/analysis_table.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/project/analyses/selection_reader.h"

namespace trivet::project {

/// How one analysis is read. Each is defined in NAME_analysis.cpp.
struct AnalysisReader {
  const char* name = nullptr;  ///< of its table in [analyses]; set by analysis_readers()
  Drive drive = Drive::none;   ///< the model must have an excitation of this kind
  std::unique_ptr<Analysis> (*read)(TableReader& reader, const ResultNames& names,
                                    const SymbolTable& symbols) = nullptr;
  bool searches_peaks = false;                           ///< its cost is that of a search for peaks
  bool of_large_systems = false;                         ///< measured up to `most_coordinates`
  double (*curves)(const Analysis& request) = nullptr;   ///< number of curves, if not that of `selection.of`
  bool (*moves_by_itself)(const Node& table) = nullptr;  ///< true if it needs no excitation
  void (*check)(const Analysis& request, const model::System& system,
                foundation::Problems& problems) = nullptr;  ///< checks the analysis against a valid model
  const char* keys = nullptr;                               ///< JSON Schema of its keys: `properties`, `required` …
};

#define TRIVET_READER(name) extern const AnalysisReader name##_analysis;
TRIVET_ANALYSES(TRIVET_READER)
#undef TRIVET_READER

/// All of them by their names, in the order of the table.
[[nodiscard]] const std::vector<AnalysisReader>& analysis_readers();

/// Reads the analyses of the file into `result`, and reports missing excitations.
void read_independent_analyses(TableReader& analyses, const ResultNames& names, const SymbolTable& symbols,
                               Analyses& result);

/// Reports analyses that do not suit the model.
/// @param computed  false for an analysis of which requirements only take the settings: one that has no result is then
///                  not judged, with the reason, beside all others
void check_analyses(const model::System& system, const Analyses& request,
                    const std::function<bool(const std::string&)>& computed, foundation::Problems& problems);

}  // namespace trivet::project
