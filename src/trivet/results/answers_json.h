// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/answers.h"

/// The JSON contract of single answers (docs/json.md): SI, complex numbers as [re, im], null where a number has no meaning,
/// "warnings" in every object.
namespace trivet::results {

[[nodiscard]] std::string modes_json(const project::Case& variant, const study::Answers& answers);
[[nodiscard]] std::string roots_json(const project::Case& variant, const study::Answers& answers);
[[nodiscard]] std::string response_json(const study::Answers& answers);
[[nodiscard]] std::string peaks_json(const study::Answers& answers);
[[nodiscard]] std::string static_json(const study::Answers& answers);

}  // namespace trivet::results
