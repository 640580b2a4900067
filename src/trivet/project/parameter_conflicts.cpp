// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/parameter_conflicts.h"

#include <algorithm>
#include <optional>
#include <string>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

/// The number of the type from which a number of an element is derived: elements.E.scale → element_types.T.scale.
std::optional<std::vector<std::string>> number_of_type(const Node& document, std::vector<std::string> keys) {
  if (keys.size() < 3 || keys.front() != "elements") return std::nullopt;
  const Node* type = node_at(document, {keys[0], keys[1], "type"});
  if (!type || type->kind != Node::Kind::text) return std::nullopt;
  keys[0] = "element_types";
  keys[1] = type->text;
  return keys;
}

}  // namespace

void refuse_derived_numbers(const Node& document, const std::vector<DesignAxis>& parameters,
                            foundation::Problems& problems) {
  for (const DesignAxis& parameter : parameters)
    for (const ParameterPlace& place : parameter.places) {
      const auto source = number_of_type(document, path_keys(place.path));
      if (!source) continue;
      for (const DesignAxis& other : parameters) {
        const auto same = std::find_if(other.places.begin(), other.places.end(),
                                       [&](const ParameterPlace& one) { return path_keys(one.path) == *source; });
        if (same == other.places.end()) continue;
        const std::string subject = "parameters." + parameter.name + ".path";
        problems
            .error(subject, foundation::quoted(place.path),
                   "this number is derived from " + foundation::quoted(same->path) + ", which the parameter " +
                       foundation::quoted(other.name) + " moves",
                   "move the number of the type, or those of its elements")
            .origin = deepest(document, subject).origin;
      }
    }
}

}  // namespace trivet::project
