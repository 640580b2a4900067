// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "fmu/matrix.h"

namespace trivet::fmu {

/// x' = A x + B u, y = C x + D u, in SI units, as the exporter wrote it.
struct LinearModel {
  std::string token;  ///< as in the description of the model: proof that both files belong together
  Matrix a, b, c, d;
  std::vector<double> initial;   ///< states at the start
  std::vector<double> nominals;  ///< typical sizes of the states, > 0

  [[nodiscard]] std::size_t states() const { return a.rows; }
  [[nodiscard]] std::size_t inputs() const { return b.columns; }
  [[nodiscard]] std::size_t outputs() const { return c.rows; }
};

/// The model in a text of words and numbers between white space:
///     trivet-linear-system 1
///     token {…}
///     states 2 inputs 1 outputs 1
///     A … B … C … D … initial … nominals … end
/// Matrices are written by rows.
/// @throws std::runtime_error that names the part if a word is missing, or a count or a number is wrong
[[nodiscard]] LinearModel linear_model(std::string_view text);

}  // namespace trivet::fmu
