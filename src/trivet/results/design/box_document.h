// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/documents/document.h"
#include "trivet/foundation/problems.h"
#include "trivet/study/box/solution_box.h"

namespace trivet::results {

/// Ranges of all numbers, what stops them, and the designs that were judged (docs/box.md).
/// @param box  outlives the document
[[nodiscard]] documents::Document box_document(const study::SolutionBox& box, const foundation::Problems& warnings);

/// A number of the model in the unit that the file has for it: "162.4 kN/m"; without a unit there in SI.
[[nodiscard]] std::string box_number_words(const study::BoxNumber& number, double value);

/// An end as a share of the number in the file, "−12.3 %" or "×1.35", or as its distance in the unit of the number.
[[nodiscard]] std::string box_end_words(const study::BoxRange& range, const study::BoxEnd& end);

/// What stops an end: the requirement with its case, no model, or nothing.
[[nodiscard]] std::string box_stop_words(const study::SolutionBox& box, const study::BoxEnd& end);

}  // namespace trivet::results
