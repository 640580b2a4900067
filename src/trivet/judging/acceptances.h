// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/plausibility/suspicion.h"
#include "trivet/project/text/document.h"

namespace trivet::judging {

/// `accept = {"mass" = "reason"}` of one table: a suspicion that its author has checked.
struct Acceptance {
  std::string table;  ///< "bodies.machine"; "" is the top of the file
  std::string kind;
  foundation::Origin origin;
};

/// All acceptances of the document; unknown kinds and empty reasons are problems.
[[nodiscard]] std::vector<Acceptance> read_acceptances(const project::Node& document, foundation::Problems& problems);

/// Acceptances of all cases of a project, and those of them that suppress a warning.
class AcceptanceBook {
 public:
  /// Warnings of the suspicions that are not accepted, with their places in the document. A number of the file has the
  /// same warning in all cases; if it belongs to a case, each case has its own, with the name of the case.
  [[nodiscard]] foundation::Problems warnings(const std::vector<plausibility::Suspicion>& suspicions,
                                              const std::vector<Acceptance>& acceptances, const project::Node& document,
                                              const std::string& case_name);
  /// An error for each acceptance that suppresses no warning in any case. @param changed  the command line changes
  /// numbers: only its own acceptances are checked
  [[nodiscard]] foundation::Problems unused_acceptances(bool changed) const;

 private:
  using Key = std::tuple<std::string, int, int, std::string, std::string>;  // source, line, column, table, kind
  static Key key(const Acceptance& a) { return {a.origin.source, a.origin.line, a.origin.column, a.table, a.kind}; }
  std::vector<Acceptance> all_;
  std::set<Key> known_, needed_;
  std::map<Key, foundation::Problem> reported_;
};

}  // namespace trivet::judging
