// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/table.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/requirements/verdict.h"

/// A verdict in words, for the screen and the report.
namespace trivet::results {

/// Of the bound and the value of a requirement.
[[nodiscard]] documents::Kind kind_of_numbers(const study::RequirementResult& result);
/// How the bound and the value of a requirement are shown.
[[nodiscard]] DisplayUnit requirement_unit(const study::RequirementResult& result,
                                           const project::DisplayUnits& display);
/// "machine.z ≤ 0.5 mm" with the bound in the units of the display. Words without such a bound stay.
[[nodiscard]] std::string requirement_words(const study::RequirementResult& result,
                                            const project::DisplayUnits& display);

/// What is behind "machine.z": "≤ 0.5 mm in 5 … 12 Hz", with a bound of numbers in the units of the display.
[[nodiscard]] std::string bound_words(const study::RequirementResult& result, const project::DisplayUnits& display);

/// A value of what is judged, as those of other designs, in the units of the display.
[[nodiscard]] std::string value_words(const study::RequirementResult& result, double value,
                                      const project::DisplayUnits& display);
/// The value, empty if there is none, and where it occurs: "at" a frequency or a time, with details.
[[nodiscard]] std::string judged_value(const study::RequirementResult& result, const project::DisplayUnits& display);
[[nodiscard]] std::string judged_place(const study::RequirementResult& result, const project::DisplayUnits& display);

/// " in case cold"; nothing for the base model.
[[nodiscard]] inline std::string in_case_words(const std::string& case_name) {
  return case_name.empty() ? "" : " in case " + case_name;
}

/// "met", "VIOLATED" or "NOT JUDGED".
[[nodiscard]] const char* verdict_word(const study::RequirementResult& result);

/// Indices of the requirements: those that could not be judged first, then by ascending margin.
[[nodiscard]] std::vector<std::size_t> by_margin(const study::CaseVerdict& judged);

}  // namespace trivet::results
