// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace trivet::benchmarks {

struct Run {
  double wall = 0, cpu = 0;
  double memory = 0;  ///< [byte], largest resident
};

/// The run of median wall time of a program with its output discarded; only one run if it takes longer than ten
/// seconds.
/// @throws std::runtime_error if it does not end with 0
[[nodiscard]] Run median(const std::vector<std::string>& words, int runs);

}  // namespace trivet::benchmarks
