// SPDX-License-Identifier: BSD-3-Clause
// Matrices on which solvers fail: defective and coincident roots, vanishing pivots, near-singular mass, light damping.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::test {

using numerics::DynamicMatrices;

struct HardCase {
  const char* name;
  DynamicMatrices m;
};

std::vector<HardCase> hard_cases();

/// A load on six coordinates, with real and complex amplitudes.
Eigen::VectorXcd load();

/// Frequencies at resonances, close to them and far from them.
std::vector<double> awkward_frequencies(const DynamicMatrices& m);

}  // namespace trivet::test
