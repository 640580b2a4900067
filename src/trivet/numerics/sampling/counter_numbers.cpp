// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/counter_numbers.h"

#include <Random123/philox.h>

namespace trivet::numerics {
namespace {

constexpr int word_bits = 32;

}  // namespace

std::array<std::uint32_t, 4> random_words(std::uint64_t seed, RandomPurpose purpose, std::uint64_t index,
                                          std::uint32_t dimension) {
  const auto low = [](std::uint64_t number) { return static_cast<std::uint32_t>(number); };
  const auto high = [](std::uint64_t number) { return static_cast<std::uint32_t>(number >> word_bits); };
  const r123::Philox4x32::ctr_type counter = {
      {low(index), high(index), dimension, static_cast<std::uint32_t>(purpose)}};
  const r123::Philox4x32::key_type key = {{low(seed), high(seed)}};
  const r123::Philox4x32::ctr_type words = r123::Philox4x32()(counter, key);
  return {words[0], words[1], words[2], words[3]};
}

double random_number(std::uint64_t seed, std::uint64_t index, std::uint32_t dimension) {
  const auto words = random_words(seed, RandomPurpose::designs, index, dimension);
  constexpr int unused = 12;  // 52 bits and a half: neither 0 nor 1
  const std::uint64_t bits = ((std::uint64_t{words[0]} << word_bits) | words[1]) >> unused;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

}  // namespace trivet::numerics
