// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/requirements/verdict.h"

/// A verdict in words, for the screen and the report.
namespace trivet::results {

/// How many requirements are met, which one governs, and what causes it: one line or two.
[[nodiscard]] std::string verdict_summary(const study::CaseVerdict& judged);

/// How the bound and the value of a requirement are shown.
[[nodiscard]] DisplayUnit requirement_unit(const study::RequirementResult& result,
                                           const project::DisplayUnits& display);
/// "machine.z ≤ 0.5 mm" with the bound in the units of the display. Words without a bound at their end stay.
[[nodiscard]] std::string requirement_words(const study::RequirementResult& result,
                                            const project::DisplayUnits& display);

/// "met", "VIOLATED" or "NOT JUDGED".
[[nodiscard]] const char* verdict_word(const study::RequirementResult& result);

/// A requirement as a line of a table.
struct RequirementRow {
  std::string words, value, place, margin, verdict;
  bool met = false;
  const study::RequirementResult* result = nullptr;  ///< of `judged`
};
/// Those that could not be judged first, then by ascending margin.
[[nodiscard]] std::vector<RequirementRow> requirement_rows(const study::CaseVerdict& judged);

/// Why requirements could not be judged, each reason once.
[[nodiscard]] std::vector<std::string> reasons_words(const study::CaseVerdict& judged);

/// The largest numbers of an envelope, to tell its round-off.
[[nodiscard]] LargestOfKind largest_of(const study::Envelope& envelope);

/// A case of an envelope: its name, or "base model".
[[nodiscard]] std::string case_of_envelope(const std::string& name);

}  // namespace trivet::results
