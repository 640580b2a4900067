// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/sample/sample.h"

namespace trivet::results {

/// The shares of the variance of each value, if there are any: a row for each requirement and drawn number, the largest
/// total share of a requirement first; requirements without shares, with the reason.
void add_shares(const study::Sample& sample, Document& document);

}  // namespace trivet::results
