// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/results/project_json.h"
#include "trivet/study/answers.h"

/// Answers as text for reading.
namespace trivet::cli {

[[nodiscard]] std::string warnings_text(const study::Answers& answers);
[[nodiscard]] std::string modes_text(const project::Case& variant, const study::Answers& answers);
[[nodiscard]] std::string roots_text(const study::Answers& answers);
[[nodiscard]] std::string response_text(const study::Answers& answers);
[[nodiscard]] std::string peaks_text(const study::Answers& answers);
[[nodiscard]] std::string static_text(const study::Answers& answers);
[[nodiscard]] std::string limits_text(const study::Answers& answers);
[[nodiscard]] std::string checks_text(const std::vector<results::CheckLine>& lines);

}  // namespace trivet::cli
