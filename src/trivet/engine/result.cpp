// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/result.h"

#include <algorithm>

#include "trivet/foundation/message_list.h"
#include "trivet/results/model/project_json.h"

namespace trivet::engine {

void Result::add_not_written(const std::string& reason) {
  not_written += (not_written.empty() ? "" : "; ") + reason;
  complete = false;
}

std::string whole(const Writer& writer) {
  std::string text;
  writer([&text](std::string_view piece) { text += piece; });
  return text;
}

foundation::Problems shown_warnings(const Result& result) {
  foundation::Problems warnings;
  for (const foundation::Problem& warning : result.warnings.list())
    if (std::ranges::find(result.failures, warning.subject) == result.failures.end()) warnings.add(warning);
  return warnings;
}

std::string remarks_before(const Result& result) {
  std::string text;
  for (const std::string& failure : result.failures) text += "NOT COMPUTED: " + failure + "\n";
  for (const std::string& note : result.notes) text += "note: " + note + "\n";
  return text.empty() ? text : text + "\n";
}

std::string preface(const Result& result) {
  const std::string warnings = foundation::message_list(shown_warnings(result)), remarks = remarks_before(result);
  return warnings + (remarks.empty() && !warnings.empty() ? "\n" : remarks);
}

std::string errors_json(const foundation::Problems& errors) { return results::problems_json(errors, {}); }

Outcome outcome(const Result& result, bool strict) {
  if (result.errors.has_errors()) return Outcome::wrong_input;
  if (!result.failure.empty() || !result.complete) return Outcome::not_computed;
  return strict ? result.findings.outcome() : Outcome::done;
}

}  // namespace trivet::engine
