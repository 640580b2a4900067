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

namespace trivet::project {

/// `accept = {"mass" = "reason"}` of one table: a suspicion that its author has looked at.
struct Acceptance {
  std::string table;  ///< "bodies.machine"; "" is the top of the file
  std::string kind;
  foundation::Origin origin;
};

/// Has a table of this path a key `accept`? The top of the file has one too.
[[nodiscard]] bool may_accept(const std::string& path);

/// All of them; kinds that do not exist and reasons that say nothing are problems.
[[nodiscard]] std::vector<Acceptance> read_acceptances(const Node& document, foundation::Problems& problems);

/// Which acceptances exist, in any case of a project, and which of them silence something.
class AcceptanceBook {
 public:
  /// Warnings of the suspicions that are not accepted, with their places in the document. One typed number has one
  /// text in all cases.
  [[nodiscard]] foundation::Problems warnings(const std::vector<plausibility::Suspicion>& suspicions,
                                              const std::vector<Acceptance>& acceptances, const Node& document);
  /// An error for each acceptance that silences nothing in any case. @param changed  numbers come from the command
  /// line: only acceptances from there are judged
  [[nodiscard]] foundation::Problems unneeded(bool changed) const;

 private:
  using Key = std::tuple<std::string, int, int, std::string, std::string>;  // source, line, column, table, kind
  static Key key(const Acceptance& a) { return {a.origin.source, a.origin.line, a.origin.column, a.table, a.kind}; }
  std::vector<Acceptance> all_;
  std::set<Key> known_, needed_;
  std::map<Key, foundation::Problem> reported_;
};

}  // namespace trivet::project
