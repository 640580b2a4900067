// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/answers.h"

/// Answers as CSV (RFC 4180, one header line, SI, shortest digits that read back the same).
namespace trivet::study {

[[nodiscard]] std::string modes_csv(const Case& variant, const Answers& answers);
[[nodiscard]] std::string roots_csv(const Answers& answers);
[[nodiscard]] std::string response_csv(const Answers& answers);
[[nodiscard]] std::string peaks_csv(const Answers& answers);
[[nodiscard]] std::string static_csv(const Answers& answers);

}  // namespace trivet::study
