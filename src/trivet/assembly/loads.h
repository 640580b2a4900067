// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"

namespace trivet::assembly {

/// Complex amplitudes of the generalized forces of all harmonic forces together, or of those named.
/// @throws foundation::InvalidInput for a name that is none
[[nodiscard]] Eigen::VectorXcd harmonic_load(const model::System& system, const Layout& layout, const std::vector<std::string>& selected = {});

/// Gravity on every body and on the mass of the elements, the preloads that already carry it, and the constant forces.
[[nodiscard]] Eigen::VectorXd static_load(const model::System& system, const Assembled& assembled);

}  // namespace trivet::assembly
