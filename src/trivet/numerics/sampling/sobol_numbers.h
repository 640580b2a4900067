// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trivet::numerics {

/// Sobol's sequence by index, with direction numbers of Joe and Kuo (Boost.Random), each dimension scrambled by a
/// random permutation of its nested intervals (Owen). Any 2^m consecutive points from a multiple of 2^m on have one
/// point in each of 2^m equal intervals of every dimension, and in each of 2^m equal cells of the first two.
///
/// The permutation is a hash of the reversed bits (Laine and Karras). Its first constants [Burley2020] leave the lower
/// bits poorly mixed; these are Vegdahl's, found by a search for the least bias.
class SobolNumbers {
 public:
  static constexpr std::size_t most_dimensions = 3667;
  static constexpr std::uint64_t most_points = std::uint64_t{1} << 32;

  /// @param scramble  which random scrambling; numbers of two are independent
  /// @throws foundation::InvalidInput for no or too many dimensions
  SobolNumbers(std::size_t dimensions, std::uint64_t seed, std::uint64_t scramble);

  /// The coordinates of a point in the open unit cube, odd multiples of 2⁻³³. @param point  one per dimension
  /// @throws foundation::InvalidInput from `most_points` on
  void set_point(std::uint64_t index, std::span<double> point) const;

  [[nodiscard]] std::size_t dimensions() const { return seeds_.size(); }

  /// The nested permutation alone, of numbers with 32 binary digits behind the point.
  [[nodiscard]] static std::uint32_t scrambled(std::uint32_t digits, std::uint32_t seed);

 private:
  std::vector<std::uint32_t> seeds_;       ///< of each dimension
  std::vector<std::uint32_t> directions_;  ///< dimension after dimension, 32 each
};

}  // namespace trivet::numerics
