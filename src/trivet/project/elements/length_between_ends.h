// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/model/system.h"
#include "trivet/project/text/document.h"

namespace trivet::project {

/// The table of a beam, link or stay that states no `length`, completed by the distance between its ends. Empty if it
/// states a length, or if its ends are not both stated: end N is then placed by the length.
/// @param description  the bodies and nodes
[[nodiscard]] std::optional<Node> with_length_between_ends(const Node& element, const std::string& name,
                                                           const model::Description& description);

}  // namespace trivet::project
