// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/sample/sample.h"

namespace trivet::results {

/// The bands of all cases: all numbers in JSON and in "bands.csv", one row per case, result and frequency; for people
/// each at the frequency where the amplitude that 95 % of the designs have at most is largest.
void add_bands(const study::Sample& sample, Document& document);

/// Does any case have bands?
[[nodiscard]] bool has_bands(const study::Sample& sample);

}  // namespace trivet::results
