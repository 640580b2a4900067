// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/analyses/requirements.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {

/// `isolation` of [requirements]: one table, or a list of them.
[[nodiscard]] std::vector<Isolation> read_isolation(TableReader& requirements, const SymbolTable& symbols);

/// Entries without a speed hold wherever the machine runs, if every harmonic force runs with it.
void judge_at_operating_speeds(const OperationAnalysis& operation, std::vector<Isolation>& isolation);

/// Forces of an entry: those named, or all harmonic ones on bodies. None of a motion of the ground.
[[nodiscard]] std::vector<std::string> isolated_forces(const Isolation& isolation, const model::System& system);

/// Frequencies of an entry for one force: those given or of [operation], or the service speed of this unbalance.
[[nodiscard]] std::vector<assembly::Band> isolated_at(const Isolation& isolation, const model::System& system,
                                                      const std::string& force);

/// Reports forces without a transmissibility and unbalances without a service speed.
void check_isolation(const std::vector<Isolation>& isolation, const model::System& system,
                     foundation::Problems& problems);

}  // namespace trivet::project
