// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>

/// Sizes of the standard library are unsigned, those of Eigen signed. These functions convert between them.
namespace trivet {

/// An integer, or an object that stands for one, such as a size known to the compiler.
template <typename Index>
concept IndexLike = std::convertible_to<Index, std::ptrdiff_t> && !std::floating_point<Index>;

/// As an Eigen::Index, which may be negative.
template <IndexLike Index>
[[nodiscard]] constexpr std::ptrdiff_t to_index(const Index& i) {
  return static_cast<std::ptrdiff_t>(i);
}

/// As an index of the standard library.
template <IndexLike Index>
[[nodiscard]] constexpr std::size_t to_size(const Index& i) {
  assert(to_index(i) >= 0);
  return static_cast<std::size_t>(to_index(i));
}

}  // namespace trivet
