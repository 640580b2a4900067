// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <utility>

/// Sizes of the standard library are unsigned, those of Eigen signed. These convert an index that is not negative.
namespace trivet {

template <std::integral Index>
[[nodiscard]] constexpr std::size_t to_size(Index i) {
  assert(std::cmp_greater_equal(i, 0));
  return static_cast<std::size_t>(i);
}

/// As an Eigen::Index.
template <std::integral Index>
[[nodiscard]] constexpr std::ptrdiff_t to_index(Index i) {
  assert(std::in_range<std::ptrdiff_t>(i));
  return static_cast<std::ptrdiff_t>(i);
}

}  // namespace trivet
