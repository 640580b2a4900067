// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/nonlinear/branch/steady_branch.h"

namespace trivet::results {

/// What the numbers of each result are compared with to be more than round-off: the largest of its kind on the
/// connected curve. Metres and radians are one kind, at a lever of 1 m, and so are forces and moments: a machine that
/// only translates has rotations of round-off.
[[nodiscard]] std::vector<double> largest_of_kinds(const nonlinear::SteadyBranch& branch);

/// "1 harmonic, which leaves out", "12 harmonics, which leave out".
[[nodiscard]] const char* harmonics_that_leave_out(Eigen::Index harmonics);

}  // namespace trivet::results
