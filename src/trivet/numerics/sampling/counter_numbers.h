// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace trivet::numerics {

/// What random numbers are for: numbers of different purposes are independent.
enum class RandomPurpose : std::uint32_t { designs, scrambling };

/// Four random words of 32 bits that depend on nothing but the arguments: Philox-4x32 with ten rounds (Random123
/// [Salmon2011]). So numbers are drawn in any order, on any machine.
[[nodiscard]] std::array<std::uint32_t, 4> random_words(std::uint64_t seed, RandomPurpose purpose, std::uint64_t index,
                                                        std::uint32_t dimension);

/// A random number in the open interval (0, 1), a multiple of 2⁻⁵³.
[[nodiscard]] double random_number(std::uint64_t seed, std::uint64_t index, std::uint32_t dimension);

}  // namespace trivet::numerics
