// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>

#include "trivet/study/explain/linear_system.h"

namespace trivet::exports {

using study::LinearSystem;
using study::Signal;

/// Initial states, zero if the system names none.
[[nodiscard]] Eigen::VectorXd initial_states(const LinearSystem& system);

/// @throws foundation::InvalidInput if a matrix has another size or an entry that is not finite, a name is empty, not
/// printable or used twice, a nominal is not above 0, or a text is not printable
void check(const LinearSystem& system);

/// The numbers of a system as the shared library of a mock-up unit reads them (apps/fmu/linear_model.h): the shortest
/// digits that read back as the same number, matrices by rows.
[[nodiscard]] std::string system_text(const LinearSystem& system, const std::string& token);

}  // namespace trivet::exports
