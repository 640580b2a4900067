// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/sample/sample.h"

namespace trivet::results {

/// The yield of a sample with its interval, what breaks first, and the requirements of each case; "sample.csv" has one
/// row per case and requirement.
[[nodiscard]] Document sample_document(const study::Sample& sample);
/// The same with the warnings of the project.
[[nodiscard]] Document sample_document(const study::Sample& sample, const foundation::Problems& warnings);

/// What is read first: the yield, and what breaks first; if only the first designs are judged, this.
[[nodiscard]] std::vector<std::string> sample_sentences(const study::Sample& sample);

/// "97.3 % (95 % confidence: 97.1 % … 97.5 %)", "≥ 99.97 % with 95 % confidence" without violations.
[[nodiscard]] std::string yield_words(const study::Yield& yield);
/// "99 %"
[[nodiscard]] std::string wanted_words(double yield);
/// The same against a wanted one: "97.3 % (…), NOT the wanted 99 %".
[[nodiscard]] std::string yield_words(const study::Yield& yield, double wanted);
/// @param wanted  from which the shown numbers differ as the exact ones do
[[nodiscard]] Json yield_json(const study::Yield& yield, std::optional<double> wanted = {});

}  // namespace trivet::results
