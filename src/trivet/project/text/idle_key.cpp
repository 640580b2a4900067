// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/idle_key.h"

#include <utility>

namespace trivet::project {

void warn_of_idle_key(TableReader& reader, const std::string& key, std::string finding, std::string rule,
                      std::string remedy) {
  const Node* node = reader.node(key);
  foundation::Problem& problem = reader.problems().warning(reader.path().empty() ? key : reader.path() + "." + key,
                                                           std::move(finding), std::move(rule), std::move(remedy));
  if (node) problem.origin = node->origin;
}

}  // namespace trivet::project
