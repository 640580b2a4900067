// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/sample/sample.h"

namespace trivet::results {

/// The drawn numbers of a requirement with shares, those with the largest total shares first.
[[nodiscard]] std::vector<std::size_t> by_total_share(const study::RequirementShares& shares);

/// The shares of the variance of each value, if there are any: a row for each requirement and drawn number, the largest
/// total share of a requirement first; requirements without shares, with the reason.
void add_shares(const study::Sample& sample, Document& document);

}  // namespace trivet::results
