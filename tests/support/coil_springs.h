// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "trivet/elements/coil_spring.h"

namespace trivet::test {

/// The helical spring of Wittrick 1966, Mottershead 1980, Pearson 1982: wire 1 mm, mean radius 5 mm, 7.6 turns
/// at 8.5744°.
inline elements::CoilSpring literature_spring() {
  elements::CoilSpring spring;
  spring.wire = elements::RoundWire{1e-3};
  spring.mean_diameter = 10e-3;
  spring.active_coils = 7.6;
  spring.active_length = 2 * std::numbers::pi * 7.6 * 5e-3 * std::tan(8.5744 * std::numbers::pi / 180);
  spring.youngs_modulus = 2.06e11;
  spring.shear_modulus = 2.06e11 / 2.6;
  spring.density = 7900;
  return spring;
}

/// The worked example of EN 13906-1: outer diameter 39.6 mm, wire 5 mm, 9.5 active of 11.5 turns, free length 105.8 mm.
inline elements::CoilSpring standards_spring() {
  elements::CoilSpring spring = literature_spring();
  spring.wire = elements::RoundWire{5e-3};
  spring.mean_diameter = 34.6e-3;
  spring.active_coils = 9.5;
  spring.dead_coils_n = spring.dead_coils_k = 1;
  spring.active_length = 105.8e-3 - 2 * 5e-3;
  spring.youngs_modulus = 2.06e11;
  spring.shear_modulus = 8.15e10;
  return spring;
}

/// Steel springs of wire 0.5 … 20 mm, either wire and hand, index 3.5 … 15, 1.2 … 20 turns, coils open by 5 … 250 %.
inline elements::CoilSpring random_spring(std::mt19937& random) {
  const auto from = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  elements::CoilSpring spring;
  const double d = std::exp(from(std::log(5e-4), std::log(2e-2))), h = from(0, 1) < 0.5 ? d : d * from(0.4, 2.5);
  if (h == d) spring.wire = elements::RoundWire{d};
  else spring.wire = elements::RectangularWire{d, h};
  spring.mean_diameter = d * from(3.5, 15);
  spring.active_coils = from(1.2, 20);
  spring.active_length = spring.active_coils * h * from(1.05, 3.5);
  spring.hand = from(0, 1) < 0.5 ? elements::Hand::right : elements::Hand::left;
  spring.start_angle = from(-4, 4);
  spring.youngs_modulus = from(1e11, 2.1e11);
  spring.shear_modulus = spring.youngs_modulus / from(2.4, 2.8);
  spring.density = 7850;
  spring.dead_coils_n = from(0, 1.5);
  spring.dead_coils_k = from(0, 1.5);
  return spring;
}

/// Largest deviation over √(K_ii K_jj) of the second.
template <typename Left, typename Right>
double scaled_difference(const Left& a, const Right& b) {
  double worst = 0;
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      worst = std::max(worst, std::abs(a(i, j) - b(i, j)) / std::sqrt(std::abs(b(i, i)) * std::abs(b(j, j))));
  return worst;
}

}  // namespace trivet::test
