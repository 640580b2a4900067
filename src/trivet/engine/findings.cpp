// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/findings.h"

#include <fmt/format.h>

namespace trivet::engine {
namespace {

std::string count_words(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

}  // namespace

void Findings::add(const foundation::Problems& warnings) {
  for (const foundation::Problem& problem : warnings.list()) warnings_.insert(foundation::message(problem));
}

void Findings::add(const study::DesignMap& map) {
  if (map.feasible_designs == 0) ++infeasible_;
  for (const study::MapMark& mark : map.marks)
    if (!mark.judged) ++not_judged_;
    else if (mark.decides && !mark.judged->governing.feasible()) ++infeasible_;
}

void Findings::add(const study::CaseVerdict& judged) {
  for (const study::RequirementResult& result : judged.results)
    (result.value ? violated_ : unknown_) += judged.decides && !result.met();
}

void Findings::add(const study::CaseResults& results) {
  add(results.warnings);
  for (const study::LimitResult* limit : limits_alone(results)) exceeded_ += !limit->met;
  for (const study::LimitLineResult* line : limit_lines_alone(results)) exceeded_ += !line->comparison.met();
  for (const study::OperatingLine* line : operating_lines_alone(results)) exceeded_ += !line->met();
  if (results.operation && !results.verdict)  // a verdict judges these limits too
    for (const study::OperatingSpeed& at : results.operation->speeds)
      for (const study::OperatingLimit& limit : at.limits) exceeded_ += !limit.met();
  if (results.verdict) add(*results.verdict);
  if (results.sample) add(*results.sample);
  if (results.map) add(*results.map);
  for (const study::DesignMap& map : results.map_pairs) add(map);
}

Outcome Findings::outcome() const {
  if (not_judged_ + unknown_ + undecided_yields_ > 0) return Outcome::not_computed;
  if (exceeded_ + violated_ + infeasible_ + infeasible_designs_ + missed_yields_ + violating_designs_ > 0)
    return Outcome::over_a_limit;
  return warnings_.empty() ? Outcome::done : Outcome::with_warnings;
}

std::string Findings::words() const {
  if (not_judged_ > 0) return count_words(not_judged_, "case", "cases") + " of a map could not be computed";
  if (unknown_ > 0) return count_words(unknown_, "requirement", "requirements") + " could not be judged";
  if (undecided_yields_ > 0) return "the designs do not decide on the wanted yield";
  std::string found;
  const auto list = [&](std::size_t count, const char* one, const char* several) {
    if (count > 0) found += (found.empty() ? "" : ", ") + count_words(count, one, several);
  };
  list(exceeded_, "limit violated", "limits violated");
  list(violated_, "requirement violated", "requirements violated");
  list(infeasible_, "verdict of a map is \"infeasible\"", "verdicts of a map are \"infeasible\"");
  list(infeasible_designs_, "best design violates a requirement", "best designs violate a requirement");
  list(violating_designs_, "sample with designs that violate a requirement",
       "samples with designs that violate a requirement");
  list(missed_yields_, "yield below the wanted one", "yields below the wanted ones");
  list(warnings_.size(), "warning", "warnings");
  return found;
}

}  // namespace trivet::engine
