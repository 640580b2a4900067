// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/names_in_file.h"

#include <algorithm>

#include "trivet/foundation/plain_text.h"

namespace trivet::project {

std::optional<std::size_t> body_named(TableReader& reader, const std::string& key,
                                      const model::Description& description, const NamesInFile& in_file) {
  const auto name = reader.text(key);
  if (!name) return std::nullopt;
  for (std::size_t i = 0; i < description.bodies.size(); ++i)
    if (description.bodies[i].name == *name) return i;
  std::vector<std::string> known = in_file.bodies;
  known.insert(known.end(), in_file.nodes.begin(), in_file.nodes.end());
  if (in_file.bodies_unknown || std::ranges::find(known, *name) != known.end()) return std::nullopt;
  const std::string guess = foundation::nearest_name(*name, known);
  const bool nodes = !in_file.nodes.empty();
  reader.error(key, foundation::quoted(*name), nodes ? "no body or node has this name" : "no body has this name",
               guess.empty()
                   ? (nodes ? "the bodies and nodes are: " : "the bodies are: ") + foundation::comma_separated(known)
                   : "did you mean \"" + guess + "\"?");
  return std::nullopt;
}

}  // namespace trivet::project
