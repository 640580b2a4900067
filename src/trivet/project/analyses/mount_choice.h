// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Which mounts may be used at some places, the same at all of them: [parameters.NAME] with `choices` or `catalogue`.
struct MountChoice {
  std::string name;
  std::vector<std::string> paths;     ///< elements.NAME.type or element_types.NAME.type
  std::vector<std::string> elements;  ///< names of the elements there
  std::vector<std::string> mounts;    ///< names in the catalogue
  std::optional<Node> catalogue;      ///< file of these, as written; none: that of the places, or the generic one
};

/// True if a table of [parameters] is a choice of mounts, not a range of numbers.
[[nodiscard]] inline bool is_mount_choice(const Node& parameter) {
  return parameter.find("choices") || parameter.find("catalogue");
}

/// The change that puts one of the mounts at all places.
[[nodiscard]] Node change_of(const MountChoice& choice, std::size_t mount);

}  // namespace trivet::project
