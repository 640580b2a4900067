// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "trivet/study/answers.h"
#include "trivet/study/verdict.h"

namespace trivet::cli {

/// The findings that --strict judges: everything that requires action by the user.
class Strictness {
 public:
  /// Limits, limit lines, a map, and warnings of one case.
  void add(const study::Answers& answers);
  /// A case that violates a rule or could not be computed, or no feasible design at all.
  void add(const study::DesignMap& map);
  /// Requirements that are violated or could not be judged, if the design has to hold in this case.
  void add(const study::CaseVerdict& judged);
  void add(const foundation::Problems& warnings);

  /// Exit code: `otherwise`, unless --strict was given and there are findings; these are then written to standard
  /// error.
  [[nodiscard]] int exit_code(bool strict, int otherwise) const;

 private:
  std::size_t exceeded_ = 0, violated_ = 0, infeasible_ = 0, not_judged_ = 0;
  std::size_t unknown_ = 0;         ///< requirements that could not be judged
  std::set<std::string> warnings_;  ///< the same warning of several cases counts once
};

}  // namespace trivet::cli
