// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/whole_study.h"

namespace trivet::results {

/// A verdict on the design: of a requirement, a clearance, a limit, a limit line, the rules of a map, or the best
/// design; or an analysis that was not computed, or not to its end.
struct Judgement {
  enum class Outcome {
    met,
    violated,
    not_judged,        ///< it could not be computed
    violated_no_need,  ///< violated in a case in which the requirements are not binding
  };
  Outcome outcome = Outcome::met;
  const char* kind = "requirement";  ///< of which there are several
  std::string words;                 ///< what is judged: "machine.z ≤ 0.5 mm"
  std::string finding;               ///< by how much and where, or why it is not judged
  double margin = 0;                 ///< 1 on the limit; of judged ones
  std::size_t shown_case = 0;        ///< index of its case
  bool decides = true;               ///< the design has to hold in this case
  /// The parts of `words` and `finding` for tables and sentences: what is judged, "≤ 0.5 mm" if it has a bound, the
  /// value, and the frequency, time or part of the machine where it occurs.
  std::string subject = words, bound = {}, value = {}, place = {};
  bool is_at = false;         ///< the place is a frequency or a time
  bool is_of_search = false;  ///< of a best design or of many, not of the machine; `words` are a whole sentence then
};

/// All verdicts on the cases of a study. A limit that is also a requirement of its case is listed once.
[[nodiscard]] std::vector<Judgement> judgements(const std::vector<const study::CaseResults*>& cases);

[[nodiscard]] std::size_t number_with(const std::vector<Judgement>& list, Judgement::Outcome outcome);

/// "2 of 9 requirements, 1 of 1 limit": of those that decide, and of what is not judged elsewhere.
[[nodiscard]] std::string shares_words(const std::vector<Judgement>& list, Judgement::Outcome outcome);

/// "; violated in 2 cases in which they are not binding"; empty if there is none.
[[nodiscard]] std::string elsewhere_words(const std::vector<Judgement>& list);

/// The verdict in a sentence: "Case cold", "violates", "machine.z", ": 0.6 mm at 20 Hz, allowed ≤ 0.5 mm". The subject
/// of a search is a sentence of its own, `who` and `verb` are empty then.
struct JudgementSentence {
  std::string who, verb, subject, rest;
};
/// @param case_name  "" of the base model  @param several  does the study have several cases?
[[nodiscard]] JudgementSentence judgement_sentence(const Judgement& one, const std::string& case_name, bool several);

/// Everything that is judged in one table, each with the case that is worst for it; violated ones first.
/// @param case_names  by `Judgement::shown_case`
[[nodiscard]] documents::Document judgements_document(const std::vector<Judgement>& list,
                                                      const std::vector<std::string>& case_names);

/// The judged one with the least margin; nullptr if nothing limits the design.
[[nodiscard]] const Judgement* least_of(const std::vector<Judgement>& list);

/// The checks of the data and of the response that failed, one sentence each.
[[nodiscard]] std::vector<std::string> failed_checks(const std::vector<study::CheckLine>& checks,
                                                     const study::CaseResults& results);

/// Said of a study that has nothing to judge by.
inline constexpr const char* nothing_judged = "Not judged: the file has no requirements, limits, clearances or map.";

/// "1 warning", "2 warnings"
[[nodiscard]] std::string count_words(std::size_t count, const std::string& one);

}  // namespace trivet::results
