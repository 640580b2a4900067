// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace trivet::numerics {

/// An Eigen index ≥ 0 as an index of the standard library.
[[nodiscard]] constexpr std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

}  // namespace trivet::numerics
