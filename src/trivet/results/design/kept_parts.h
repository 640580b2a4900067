// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/sample/sample.h"

namespace trivet::results {

/// A requirement in a case of a sample, in the order of the margins of kept designs.
struct KeptRequirement {
  const study::SampledCaseResult* in;
  const study::SampledRequirement* of;
};
[[nodiscard]] std::vector<KeptRequirement> kept_requirements(const study::Sample& sample);

/// The kept designs with their numbers, verdicts and margins, in JSON and arrays; "designs.csv" has one row per design.
void add_kept_designs(const study::Sample& sample, Document& document);

}  // namespace trivet::results
