// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/refusal.h"

#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {

void refuse_errors(const foundation::Problems& problems) {
  for (const foundation::Problem& problem : problems.list())
    if (problem.severity == foundation::Severity::error) throw foundation::InvalidInput(foundation::message(problem));
}

}  // namespace trivet::excitation
