// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace trivet::numerics {

/// An index of Eigen as one of the standard library, ≥ 0.
[[nodiscard]] constexpr std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

}  // namespace trivet::numerics
