// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/message_list.h"

#include <fmt/format.h>

namespace trivet::foundation {

Problems listed(const Problems& problems) {
  if (problems.list().size() <= most_messages) return problems;
  Problems result;
  for (const Severity severity : {Severity::error, Severity::warning})
    for (const Problem& problem : problems.list())
      if (problem.severity == severity && result.list().size() < most_messages) result.add(problem);
  return result;
}

std::string rest_of_list(const Problems& problems) {
  if (problems.list().size() <= most_messages) return "";
  const Problems first = listed(problems);
  const std::size_t errors = problems.errors() - first.errors(), all = problems.list().size() - first.list().size();
  return fmt::format("… and {} more ({} errors, {} warnings); correct what is listed and check again", all, errors,
                     all - errors);
}

std::string message_list(const Problems& problems) {
  std::string text;
  const Problems first = listed(problems);
  for (const Problem& problem : first.list()) text += message(problem) + "\n";
  const std::string rest = rest_of_list(problems);
  return rest.empty() ? text : text + rest + "\n";
}

}  // namespace trivet::foundation
