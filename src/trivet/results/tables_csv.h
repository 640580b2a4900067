// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/answers.h"

/// Answers as CSV (RFC 4180, one header line, SI, shortest digits that read back the same).
namespace trivet::results {

[[nodiscard]] std::string modes_csv(const project::Case& variant, const study::Answers& answers);
[[nodiscard]] std::string roots_csv(const study::Answers& answers);
[[nodiscard]] std::string response_csv(const study::Answers& answers);
[[nodiscard]] std::string peaks_csv(const study::Answers& answers);
[[nodiscard]] std::string static_csv(const study::Answers& answers);

}  // namespace trivet::results
