// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "trivet/study/analyses/case_results.h"
#include "trivet/study/sample/sample.h"

namespace trivet::engine {

/// What the results of a command mean for the exit code of a program. The values 3 and 4 need a strict judgement: the
/// results exist, but a limit or requirement is violated (3), or there are warnings alone (4).
enum class Outcome { done = 0, not_computed = 1, wrong_input = 2, over_a_limit = 3, with_warnings = 4 };

/// Everything in results that requires action by the user: what --strict judges.
class Findings {
 public:
  void add(const foundation::Problems& warnings);
  /// Limits, limit lines, a map, a verdict and the warnings of one case.
  void add(const study::CaseResults& results);
  /// A case that violates a rule or could not be computed, or no feasible design at all.
  void add(const study::DesignMap& map);
  /// Requirements that are violated or could not be judged, if the design has to meet them in this case.
  void add(const study::CaseVerdict& judged);
  /// A wanted yield that is missed or not decided.
  void add(const study::Sample& sample) {
    missed_yields_ += sample.yield_verdict() == study::YieldVerdict::violated;
    undecided_yields_ += sample.yield_verdict() == study::YieldVerdict::undecided;
  }
  /// Designs within tolerances violate a requirement, and no yield is wanted.
  void add_violating_designs() { ++violating_designs_; }
  /// The best design violates a requirement.
  void add_infeasible_design() { ++infeasible_designs_; }

  /// The strict judgement of results that are complete.
  [[nodiscard]] Outcome outcome() const;
  /// What was found: "1 limit violated, 2 warnings"; empty if nothing was.
  [[nodiscard]] std::string words() const;

 private:
  std::size_t exceeded_ = 0, violated_ = 0, infeasible_ = 0, not_judged_ = 0, infeasible_designs_ = 0,
              missed_yields_ = 0, undecided_yields_ = 0, violating_designs_ = 0;
  std::size_t unknown_ = 0;         ///< requirements that could not be judged
  std::set<std::string> warnings_;  ///< the same warning of several cases counts once
};

}  // namespace trivet::engine
