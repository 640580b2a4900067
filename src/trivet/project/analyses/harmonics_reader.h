// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

/// What the questions about periodic motions of nonlinear machines share.
namespace trivet::project {

/// `harmonics` or `tolerance`; 0 harmonics: as many as the tolerance needs.
void read_harmonics(TableReader& reader, int& harmonics, double& tolerance);

/// An error if the machine is linear. @param question  "analyses.steady"
void require_nonlinear(const char* question, const char* remedy, const model::System& system,
                       foundation::Problems& problems);

}  // namespace trivet::project
