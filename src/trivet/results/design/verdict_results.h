// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/requirements/verdict.h"

namespace trivet::results {

/// For each case: how many requirements are met, which one governs and why, and a table by ascending margin.
[[nodiscard]] std::string verdict_text(const study::Verdict& verdict);
/// One line per case and requirement, SI.
[[nodiscard]] std::string verdict_csv(const study::Verdict& verdict);
[[nodiscard]] std::string verdict_json(const study::Verdict& verdict);

/// Least and largest static values over all cases; empty if they do not differ.
[[nodiscard]] std::string envelope_text(const study::Envelope& envelope);
/// One line per quantity, SI.
[[nodiscard]] std::string envelope_csv(const study::Envelope& envelope);

}  // namespace trivet::results
