// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/engine/session.h"

/// Names in a project, for completion in a shell.
namespace trivet::engine {

/// What `of` may name in the base model: "machine", "machine.z", "mount.force.z", "ground".
[[nodiscard]] std::vector<std::string> result_names(const Session& session);

/// Paths of the numbers of the file, as settings name them: "elements.front.at.z". Arrays of three have components,
/// other arrays are one number.
[[nodiscard]] std::vector<std::string> number_paths(const Session& session);

}  // namespace trivet::engine
