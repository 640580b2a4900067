// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "trivet/project/project.h"

namespace trivet::engine {

/// A project of one case alone, as `--case` asks a command for that is otherwise about all cases. The design has to
/// hold in it, whatever `hold_in` says, and a search for the best design of all cases is left out.
[[nodiscard]] std::shared_ptr<const project::Project> case_alone(const project::Project& project,
                                                                 const project::Case& variant);

}  // namespace trivet::engine
