// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/answers.h"

/// The JSON contract of single answers (docs/json.md): SI, complex numbers as [re, im], null where a number has no meaning,
/// "warnings" in every object.
namespace trivet::study {

[[nodiscard]] std::string modes_json(const Case& variant, const Answers& answers);
[[nodiscard]] std::string roots_json(const Case& variant, const Answers& answers);
[[nodiscard]] std::string response_json(const Answers& answers);
[[nodiscard]] std::string peaks_json(const Answers& answers);
[[nodiscard]] std::string static_json(const Answers& answers);

}  // namespace trivet::study
