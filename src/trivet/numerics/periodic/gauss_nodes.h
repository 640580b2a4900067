// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace trivet::numerics {

/// Gauss's rule of 8 nodes on pieces of at most `longest`: visit(place, weight) for each node. Over one wave of the
/// highest harmonic of an integrand the error is below 1e-9.
template <typename Visit>
void each_gauss_node(double from, double to, double longest, const Visit& visit) {
  constexpr std::array<double, 4> places = {0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                                            0.96028985649753623168};
  constexpr std::array<double, 4> weights = {0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                                             0.10122853629037625915};
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
  const double half = (to - from) / (2 * pieces);
  for (int p = 0; p < pieces; ++p)
    for (std::size_t g = 0; g < places.size(); ++g)
      for (const double side : {-1.0, 1.0}) visit(from + half * (2 * p + 1 + side * places[g]), weights[g] * half);
}

}  // namespace trivet::numerics
