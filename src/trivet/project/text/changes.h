// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// Lays `changes` over `base`, key by key. Single values and whole arrays replace what was there, a component (at.y)
/// one number of an array of three, and so do damping, inertia and orientation when written in braces. Things with
/// names (bodies, elements, excitations, …) must exist already: a new one is a problem. `path` is where in the project
/// the two stand.
void apply_changes(Node& base, const Node& changes, const std::string& path, foundation::Problems& problems);

/// "elements.front.scale=1.5" → a document of changes. A value that is not TOML is taken as text ("3 kg").
[[nodiscard]] foundation::Expected<Node> parse_setting(const std::string& setting);

}  // namespace trivet::project
