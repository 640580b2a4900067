// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/project.h"

namespace trivet::report {

/// Cylinders, crank drive, masses and gas torque of the engine that drives an excitation, as the file has them; empty:
/// no engine does.
[[nodiscard]] std::vector<model::Fact> engine_facts(const project::Case& variant, const std::string& excitation);

}  // namespace trivet::report
