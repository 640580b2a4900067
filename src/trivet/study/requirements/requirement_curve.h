// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/loads.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// What a requirement on a curve judges: a result over frequency, and what drives it.
struct RequirementCurve {
  assembly::Channel channel;
  assembly::Loading loading;
};

/// The result named by its subject under its excitations, or its transmissibility.
[[nodiscard]] RequirementCurve requirement_curve(const model::System& system, const assembly::Assembled& assembled,
                                                 const RequirementResult& result);

/// True if two requirements have the same loading and band, so that one search finds the peaks of both.
[[nodiscard]] bool have_same_drive(const RequirementResult& a, const RequirementResult& b);

}  // namespace trivet::study
