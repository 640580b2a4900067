// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/text/symbol_table.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// `analyses`, `limits` and `limit_lines` of the file.
[[nodiscard]] Analyses read_analyses(TableReader& root, const SymbolTable& symbols);

/// Reads [requirements], if the file has them. Call it after [analyses], [limits] and [limit_lines].
void read_requirements(TableReader& root, const ResultNames& names, const SymbolTable& symbols, Analyses& result);

/// Reports requirements that a valid model cannot be judged by.
void check_requirements(const model::System& system, const Analyses& request, foundation::Problems& problems);

/// Reads `optimize` of the analyses, if there is one. Call it after the parameters and the response.
void read_optimize(TableReader& root, TableReader& analyses, const ResultNames& names, const SymbolTable& symbols,
                   Analyses& result);

/// Reads [tolerances.NAME].
[[nodiscard]] std::vector<Tolerance> read_tolerances(TableReader& root);

/// Reads [analyses.sample]; none if it is not requested. Call it after the response.
[[nodiscard]] std::optional<SampleRequest> read_sample(TableReader& root, TableReader& analyses,
                                                       const ResultNames& names,
                                                       const std::optional<ResponseRequest>& response);

/// Reads [analyses.box]; none if it is not requested.
[[nodiscard]] std::optional<BoxRequest> read_box(TableReader& root, TableReader& analyses);

/// A whole number from `least` to `most`, or an error with this remedy.
[[nodiscard]] std::optional<double> read_whole(TableReader& reader, const std::string& key, double least, double most,
                                               const std::string& remedy);
inline constexpr double most_seed = 9007199254740991;

/// Reports requested results that do not exist because no element holds that direction of a node.
void refuse_left_out_results(const model::System& system, const Analyses& request, foundation::Problems& problems);

/// `at`: single frequencies or speeds [rad/s], > 0, that an analysis over a range tells besides; none without the key.
[[nodiscard]] std::vector<double> read_single_frequencies(TableReader& reader);

// What the analyses of periodic motions of nonlinear machines share.

/// `harmonics` or `tolerance`; 0 harmonics: as many as the tolerance needs.
void read_harmonics(TableReader& reader, int& harmonics, double& tolerance);

/// An error if the machine is linear. @param analysis  "analyses.steady"
void require_nonlinear(const char* analysis, const char* remedy, const model::System& system,
                       foundation::Problems& problems);

}  // namespace trivet::project
