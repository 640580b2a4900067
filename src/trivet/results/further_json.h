// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/answers.h"

/// JSON and CSV of the answers beyond one harmonic load; contract in docs/json.md.
namespace trivet::results {

[[nodiscard]] std::string random_json(const study::Answers& answers);
[[nodiscard]] std::string transient_json(const study::Answers& answers);
[[nodiscard]] std::string orders_json(const study::Answers& answers);
[[nodiscard]] std::string transmissibility_json(const study::Answers& answers);

[[nodiscard]] std::string random_csv(const study::Answers& answers);            ///< one row per answer
[[nodiscard]] std::string random_densities_csv(const study::Answers& answers);  ///< one row per frequency, densities per hertz
[[nodiscard]] std::string transient_csv(const study::Answers& answers);         ///< one row per time
[[nodiscard]] std::string orders_csv(const study::Answers& answers);            ///< one row per speed, a column per answer and order
[[nodiscard]] std::string critical_speeds_csv(const study::Answers& answers);
[[nodiscard]] std::string transmissibility_csv(const study::Answers& answers);  ///< one row per frequency
[[nodiscard]] std::string power_csv(const study::Answers& answers);
[[nodiscard]] std::string shapes_csv(const study::Answers& answers);
[[nodiscard]] std::string shock_spectrum_csv(const study::Answers& answers);

}  // namespace trivet::results
