// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/pressure_modulus.h"

#include <cmath>
#include <numbers>

namespace trivet::elements {
namespace {

using std::numbers::pi;

double modulus_in_series(double a, double b) { return 1 / (1 / a + 1 / b); }

/// I_{n+1}(x)/I_n(x) by its continued fraction, evaluated from a depth at which it has converged.
double bessel_ratio(int n, double x) {
  double ratio = 0;
  for (int k = n + 40 + static_cast<int>(x); k > n; --k) ratio = x / (2 * k + x * ratio);
  return ratio;
}

/// κ = √(12G/K)/h [1/m]: pressure decays over 1/κ from a free edge.
double decay(const Rubber& rubber, double thickness) {
  return std::sqrt(12 * rubber.shear_modulus / rubber.bulk_modulus) / thickness;
}

/// I_{n+2}(λ)/I_n(λ) over λ²; below λ = 1e-6 its value at λ = 0.
double scaled_bessel_product(int n, double lambda) {
  if (lambda < 1e-6) return 1.0 / (4 * (n + 1) * (n + 2));
  return bessel_ratio(n, lambda) * bessel_ratio(n + 1, lambda) / (lambda * lambda);
}

/// x coth x − 1 over x², ⅓ at 0.
double coth_share(double x) {
  return x < 0.1 ? 1.0 / 3 - x * x / 45 + 2 * std::pow(x, 4) / 945 : (x / std::tanh(x) - 1) / (x * x);
}

/// 1 − tanh(x)/x, and the same for a load that varies linearly: 1 − 3(x coth x − 1)/x².
double even_share(double x) { return x < 1e-3 ? x * x / 3 * (1 - 0.4 * x * x) : 1 - std::tanh(x) / x; }
double odd_share(double x) {
  return x < 0.1 ? x * x / 15 - 2 * std::pow(x, 4) / 315 + std::pow(x, 6) / 1575 : 1 - 3 * coth_share(x);
}

/// Σ over odd n of 8/(n²π²) · share(μ_n a/2)/μ_n², μ_n² = (nπ/b)² + κ².
template <typename Share>
double sine_series(double a, double b, double kappa, Share share) {
  double sum = 0;
  for (int n = 1; n < 20001; n += 2) {
    const double mu = std::hypot(n * pi / b, kappa);
    const double term = 8 / (n * n * pi * pi) * share(mu * a / 2) / (mu * mu);
    sum += term;
    if (term * n < 1e-13 * sum) break;
  }
  return sum;
}

/// Solves ∇²f − κ²f = −1 (n = 0) or −r (n = 1, times cos φ) on a ring by Bessel functions for κ > 0. Returns ∫ f rⁿ r
/// dr over ∫ r^{2n} r dr.
double ring_mean(int n, double outer, double inner, double kappa) {
  const auto i = [&](int order, double r) { return std::cyl_bessel_i(order, kappa * r); };
  const auto k = [&](int order, double r) { return std::cyl_bessel_k(order, kappa * r); };
  const double b1 = std::pow(outer, n), b2 = std::pow(inner, n),
               determinant = i(n, outer) * k(n, inner) - i(n, inner) * k(n, outer);
  const double c1 = (b1 * k(n, inner) - b2 * k(n, outer)) / determinant,
               c2 = (i(n, outer) * b2 - i(n, inner) * b1) / determinant;
  const auto integral = [&](double r) { return std::pow(r, n + 1) * (c1 * i(n + 1, r) - c2 * k(n + 1, r)) / kappa; };
  const double moment = (std::pow(outer, 2 * n + 2) - std::pow(inner, 2 * n + 2)) / (2 * n + 2);
  return (1 - (integral(outer) - integral(inner)) / moment) / (kappa * kappa);
}

/// The same for κ = 0, by powers and logarithms.
double incompressible_ring_mean(int n, double outer, double inner) {
  const double a2 = outer * outer, b2 = inner * inner;
  if (n == 0) return (a2 + b2 - (a2 - b2) / std::log(outer / inner)) / 8;
  return (a2 - b2) * (a2 - b2) / (24 * (a2 + b2));
}

double ring_film(int n, const Rubber& rubber, double outer, double inner, double thickness) {
  constexpr double stiff = 1e-3;  // below it Bessel functions lose digits, and compressibility is < 1e-6
  const double kappa = decay(rubber, thickness);
  const double mean =
      kappa * (outer - inner) < stiff ? incompressible_ring_mean(n, outer, inner) : ring_mean(n, outer, inner, kappa);
  return 12 * rubber.shear_modulus / (thickness * thickness) * mean;
}

}  // namespace

double disc_shape_factor(double radius, double hole_radius, double thickness) {
  return (radius - hole_radius) / (2 * thickness);
}

double block_shape_factor(double width_1, double width_2, double thickness) {
  return width_1 * width_2 / (2 * thickness * (width_1 + width_2));
}

double gent_lindley_modulus(const Rubber& rubber, double shape_factor) {
  return modulus_in_series(3 * rubber.shear_modulus * (1 + 2 * shape_factor * shape_factor), rubber.bulk_modulus);
}

double gent_meinecke_bending_modulus(const Rubber& rubber, double shape_factor) {
  return modulus_in_series(3 * rubber.shear_modulus * (1 + 2 * shape_factor * shape_factor / 3), rubber.bulk_modulus);
}

double disc_pressure_modulus(const Rubber& rubber, double radius, double thickness) {
  const double slenderness = radius / thickness;
  return 12 * rubber.shear_modulus * slenderness * slenderness *
      scaled_bessel_product(0, decay(rubber, thickness) * radius);
}

double disc_pressure_bending_modulus(const Rubber& rubber, double radius, double thickness) {
  const double slenderness = radius / thickness;
  return 12 * rubber.shear_modulus * slenderness * slenderness *
      scaled_bessel_product(1, decay(rubber, thickness) * radius);
}

double ring_pressure_modulus(const Rubber& rubber, double radius, double hole_radius, double thickness) {
  return ring_film(0, rubber, radius, hole_radius, thickness);
}

double ring_pressure_bending_modulus(const Rubber& rubber, double radius, double hole_radius, double thickness) {
  return ring_film(1, rubber, radius, hole_radius, thickness);
}

double block_pressure_modulus(const Rubber& rubber, double width_1, double width_2, double thickness) {
  return 12 * rubber.shear_modulus / (thickness * thickness) *
      sine_series(width_1, width_2, decay(rubber, thickness), even_share);
}

double block_pressure_bending_modulus(const Rubber& rubber, double width_1, double width_2, double thickness) {
  return 12 * rubber.shear_modulus / (thickness * thickness) *
      sine_series(width_1, width_2, decay(rubber, thickness), odd_share);
}

}  // namespace trivet::elements
