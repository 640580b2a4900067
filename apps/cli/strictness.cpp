// SPDX-License-Identifier: BSD-3-Clause
#include "cli/strictness.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "trivet/design/design_rules.h"

namespace trivet::cli {
namespace {

std::string count_text(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

}  // namespace

void Strictness::add(const foundation::Problems& warnings) {
  for (const foundation::Problem& problem : warnings.list()) warnings_.insert(foundation::message(problem));
}

void Strictness::add(const study::DesignMap& map) {
  if (map.feasible_designs == 0) ++infeasible_;
  for (const study::MapMark& mark : map.marks)
    if (!mark.judged) ++not_judged_;
    else if (!mark.judged->governing.feasible()) ++infeasible_;
}

void Strictness::add(const study::CaseVerdict& judged) {
  for (const study::RequirementResult& result : judged.results)
    (result.value ? violated_ : unknown_) += judged.decides && !result.met();
}

void Strictness::add(const study::Answers& answers) {
  add(answers.warnings);
  for (const study::LimitAnswer& limit : answers.limits) exceeded_ += !limit.met;
  for (const study::LimitLineResult& line : answers.limit_lines) exceeded_ += !line.comparison.met();
  if (answers.verdict) add(*answers.verdict);
  if (answers.map) add(*answers.map);
  for (const study::DesignMap& map : answers.map_pairs) add(map);
}

int Strictness::exit_code(bool strict, int otherwise) const {
  if (strict && otherwise == done && not_judged_ > 0) {
    write_error(fmt::format("--strict: {} of a map could not be computed; exit code {}\n",
                            count_text(not_judged_, "case", "cases"), static_cast<int>(not_computed)));
    return not_computed;
  }
  if (strict && otherwise == done && unknown_ > 0) {
    write_error(fmt::format("--strict: {} could not be judged; exit code {}\n",
                            count_text(unknown_, "requirement", "requirements"), static_cast<int>(not_computed)));
    return not_computed;
  }
  if (!strict || otherwise != done || exceeded_ + violated_ + infeasible_ + warnings_.size() == 0) return otherwise;
  std::string found;
  const auto list = [&](std::size_t count, const std::string& words) {
    found += count == 0 ? "" : (found.empty() ? "" : ", ") + words;
  };
  list(exceeded_, count_text(exceeded_, "limit exceeded", "limits exceeded"));
  list(violated_, count_text(violated_, "requirement violated", "requirements violated"));
  list(infeasible_,
       count_text(infeasible_, "verdict of a map is \"infeasible\"", "verdicts of a map are \"infeasible\""));
  list(warnings_.size(), count_text(warnings_.size(), "warning", "warnings"));
  const int code = exceeded_ + violated_ + infeasible_ > 0 ? over_a_limit : with_warnings;
  write_error(fmt::format("--strict: {}; exit code {}\n", found, code));
  return code;
}

}  // namespace trivet::cli
