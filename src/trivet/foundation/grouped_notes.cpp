// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/grouped_notes.h"

#include <algorithm>

#include "trivet/foundation/plain_text.h"

namespace trivet::foundation {

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
