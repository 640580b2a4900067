// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/message_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/plain_text.h"

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

std::vector<std::string> grouped(const std::vector<std::string>& notes) {
  struct Group {
    std::vector<std::string> names;
    std::string words;
  };
  std::vector<Group> groups;
  for (const std::string& note : notes) {
    const std::size_t colon = std::min(note.find(": "), note.size());
    const std::string name = note.substr(0, colon), words = note.substr(colon);
    const auto same =
        std::ranges::find_if(groups, [&](const Group& group) { return !words.empty() && group.words == words; });
    if (same == groups.end()) groups.push_back({{name}, words});
    else if (std::ranges::find(same->names, name) == same->names.end()) same->names.push_back(name);
  }
  std::vector<std::string> found;
  for (const Group& group : groups)
    found.push_back((group.names.size() == 1 ? group.names.front() : comma_separated(group.names)) + group.words);
  return found;
}

}  // namespace trivet::foundation
