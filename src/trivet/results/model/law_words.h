// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"

namespace trivet::results {

/// The nonlinear laws of an element with their numbers in SI, one per law: "law along z", "gap stop: …".
[[nodiscard]] std::vector<model::Fact> law_facts(const model::Element& element);

}  // namespace trivet::results
