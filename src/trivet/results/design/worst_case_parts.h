// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/study/sample/sample.h"

/// The worst designs that a search found: parts of the document of a sample.
namespace trivet::results {

/// "a corner", "2 of 3 drawn numbers at an end of their range".
[[nodiscard]] std::string worst_place_words(const study::Sample& sample, const study::WorstDesign& worst);

/// Numbers of a design as settings of the command line: "--set PATH=VALUE …", quoted for a shell.
[[nodiscard]] std::string setting_words(const std::vector<study::NamedNumber>& numbers);

/// Values of a design by their paths.
[[nodiscard]] documents::Json numbers_json(const std::vector<study::NamedNumber>& numbers);

/// Columns of programs of the worst designs of requirements; none if they were not searched.
[[nodiscard]] std::vector<documents::Column> worst_columns(std::vector<const study::SampledRequirement*> list);

/// Adds them, if they were searched.
void add_worst_cases(const study::Sample& sample, documents::Document& document);

}  // namespace trivet::results
