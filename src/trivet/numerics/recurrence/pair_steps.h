// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace trivet::numerics {

/// Pairs of states come in groups of this many, and rows of results too: the numbers of one group fill the widest pack.
inline constexpr std::ptrdiff_t lane_group = 8;

/// An input of steps: its coefficients γ, those of the first states of all pairs and then those of the second ones, and
/// the row of its numbers w.
struct StepInput {
  const double* gamma = nullptr;
  std::ptrdiff_t row = 0;
};

/// Coefficients of steps of independent pairs of states (x, y): x⁺ = a x + b y + Σ γ w, y⁺ = c x + d y + Σ γ w.
struct PairSteps {
  std::ptrdiff_t pairs = 0;        ///< a multiple of lane_group
  const double* matrix = nullptr;  ///< a, b, c, d of all pairs: 4 × pairs
  const StepInput *begin = nullptr, *end = nullptr;
};

/// Takes one step per column of w. Column 0 of the states holds the state before the first one, and each step writes
/// the next column: the first states of all pairs, then the second ones, from row 0 on.
void take_pair_steps(const PairSteps& steps, const Eigen::Ref<const Eigen::MatrixXd>& w,
                     Eigen::Ref<Eigen::MatrixXd> states);

}  // namespace trivet::numerics
