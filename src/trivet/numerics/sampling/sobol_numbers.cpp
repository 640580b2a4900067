// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/sobol_numbers.h"

#include <bit>
#include <boost/random/sobol.hpp>
#include <string>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/counter_numbers.h"

namespace trivet::numerics {
namespace {

constexpr unsigned digits_of_number = 32;

std::uint32_t reversed(std::uint32_t bits) {
  bits = ((bits >> 1) & 0x55555555U) | ((bits & 0x55555555U) << 1);
  bits = ((bits >> 2) & 0x33333333U) | ((bits & 0x33333333U) << 2);
  bits = ((bits >> 4) & 0x0f0f0f0fU) | ((bits & 0x0f0f0f0fU) << 4);
  bits = ((bits >> 8) & 0x00ff00ffU) | ((bits & 0x00ff00ffU) << 8);
  return (bits >> 16) | (bits << 16);
}

/// The points whose Gray code has one digit alone are the direction numbers: that of digit k is point 2^(k+1) − 1.
std::vector<std::uint32_t> direction_numbers(std::size_t dimensions) {
  boost::random::sobol_engine<std::uint32_t, digits_of_number> sequence(dimensions);
  std::vector<std::uint32_t> directions(dimensions * digits_of_number);
  for (unsigned k = 0; k < digits_of_number; ++k) {
    const std::uint32_t point = (std::uint32_t{2} << k) - 1;  // the last digit: all ones
    sequence.seed(point - 1);                                 // the engine leaves out the point at the origin
    for (std::size_t d = 0; d < dimensions; ++d) directions[d * digits_of_number + k] = sequence();
  }
  return directions;
}

}  // namespace

SobolNumbers::SobolNumbers(std::size_t dimensions, std::uint64_t seed, std::uint64_t scramble) {
  if (dimensions < 1 || dimensions > most_dimensions)
    throw foundation::InvalidInput("Sobol's numbers have 1 to " + std::to_string(most_dimensions) +
                                   " dimensions, not " + std::to_string(dimensions));
  directions_ = direction_numbers(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d)
    seeds_.push_back(random_words(seed, RandomPurpose::scrambling, scramble, static_cast<std::uint32_t>(d))[0]);
}

std::uint32_t SobolNumbers::scrambled(std::uint32_t digits, std::uint32_t seed) {
  // A digit depends on those before it: in reversed order on lower ones, as carries and products of even numbers do.
  std::uint32_t x = reversed(digits);
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return reversed(x);
}

void SobolNumbers::set_point(std::uint64_t index, std::span<double> point) const {
  if (index >= most_points)
    throw foundation::InvalidInput("point " + std::to_string(index) + ": Sobol's numbers have 2^32 points");
  for (std::size_t d = 0; d < seeds_.size(); ++d) {
    std::uint32_t digits = 0;
    for (std::uint64_t left = index; left != 0; left &= left - 1)
      digits ^= directions_[d * digits_of_number + static_cast<unsigned>(std::countr_zero(left))];
    point[d] = (static_cast<double>(scrambled(digits, seeds_[d])) + 0.5) * 0x1p-32;
  }
}

}  // namespace trivet::numerics
