// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/answers.h"

/// Answers beyond one harmonic load as text for reading.
namespace trivet::cli {

[[nodiscard]] std::string random_text(const study::Answers& answers);
[[nodiscard]] std::string transient_text(const study::Answers& answers);
[[nodiscard]] std::string orders_text(const study::Answers& answers);
[[nodiscard]] std::string transmissibility_text(const study::Answers& answers);
[[nodiscard]] std::string power_text(const study::Answers& answers);
[[nodiscard]] std::string shapes_text(const study::Answers& answers);
[[nodiscard]] std::string shock_spectrum_text(const study::Answers& answers);
[[nodiscard]] std::string earthquake_text(const study::Answers& answers);
[[nodiscard]] std::string limit_lines_text(const study::Answers& answers);
[[nodiscard]] std::string load_sharing_text(const study::Answers& answers);

/// All of them that there are.
[[nodiscard]] std::string further_text(const study::Answers& answers);

}  // namespace trivet::cli
