// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/material.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <cmath>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::fem {

namespace {

Material checked(const Material& material) {
  foundation::refuse_errors(check(material));
  return material;
}

}  // namespace

Material linear_elastic(double young_modulus, double poisson_ratio) {
  if (!(young_modulus > 0) || !std::isfinite(young_modulus))
    throw foundation::InvalidInput(fmt::format("young_modulus = {} Pa; it must be > 0", young_modulus));
  if (!(poisson_ratio > -1 && poisson_ratio < 0.5))
    throw foundation::InvalidInput(
        fmt::format("poisson_ratio = {}; it must be in (-1, 0.5); for rubber, give the bulk modulus, or 0.4995 (bulk "
                    "modulus about 1000 times the shear modulus)",
                    poisson_ratio));
  return neo_hookean(young_modulus / (2 * (1 + poisson_ratio)), young_modulus / (3 * (1 - 2 * poisson_ratio)));
}

Material neo_hookean(double shear_modulus, double bulk_modulus) {
  return checked({.c10 = shear_modulus / 2, .bulk_modulus = bulk_modulus});
}

Material mooney_rivlin(double c10, double c01, double bulk_modulus) {
  return checked({.c10 = c10, .c01 = c01, .bulk_modulus = bulk_modulus});
}

Material yeoh(double c10, double c20, double c30, double bulk_modulus) {
  return checked({.c10 = c10, .c20 = c20, .c30 = c30, .bulk_modulus = bulk_modulus});
}

double poisson_ratio(const Material& material) {
  const double k = material.bulk_modulus, g = shear_modulus(material);
  return (3 * k - 2 * g) / (6 * k + 2 * g);
}

foundation::Problems check(const Material& material) {
  constexpr double most_stiff_in_volume = 1e8;
  foundation::Problems problems;
  const double g = shear_modulus(material), k = material.bulk_modulus;
  if (!std::isfinite(g + k + material.c20 + material.c30)) {
    problems.error("material", "a constant is not a finite number", "all material constants must be finite",
                   "give numbers in Pa");
    return problems;
  }
  if (!(g > 0))
    problems.error("shear_modulus", fmt::format("{} Pa", g), "the shear modulus 2 (C10 + C01) must be > 0",
                   "check signs and units of the constants");
  if (!(k > 0))
    problems.error("bulk_modulus", fmt::format("{} Pa", k), "the bulk modulus must be > 0", "rubber has about 2 GPa");
  if (g > 0 && k > most_stiff_in_volume * g)
    problems.error("bulk_modulus",
                   fmt::format("{} Pa, {:.1e} times the shear modulus (Poisson's ratio {:.9f})", k, k / g,
                               poisson_ratio(material)),
                   "it must be at most 1e8 times the shear modulus, otherwise double precision is lost",
                   "rubber has about 2 GPa");
  return problems;
}

namespace {

using Vector9 = Eigen::Matrix<double, 9, 1>;

Vector9 as_vector(const Eigen::Matrix3d& m) { return Eigen::Map<const Vector9>(m.data()); }

/// m_iJ m_jI at (iI, jJ).
Matrix9 crossed(const Eigen::Matrix3d& m) {
  Matrix9 c;
  for (int I = 0; I < 3; ++I)
    for (int J = 0; J < 3; ++J)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c(i + 3 * I, j + 3 * J) = m(i, J) * m(j, I);
  return c;
}

/// An isochoric invariant and its derivatives by F.
struct Invariant {
  double value;
  Vector9 first;
  Matrix9 second;
};

/// J^power times an invariant; `inverse` is F^-T.
Invariant scaled(const Invariant& plain, double power, double j, const Vector9& inverse,
                 const Matrix9& inverse_crossed) {
  const double s = std::pow(j, power);
  const Matrix9 mixed = plain.first * inverse.transpose();
  return {s * plain.value, s * (plain.first + power * plain.value * inverse),
          s *
              (plain.second + power * (mixed + mixed.transpose()) +
               power * plain.value * (power * inverse * inverse.transpose() - inverse_crossed))};
}

Invariant first_invariant(const Eigen::Matrix3d& f) {
  return {f.squaredNorm(), 2 * as_vector(f), 2 * Matrix9::Identity()};
}

Invariant second_invariant(const Eigen::Matrix3d& f) {
  const Eigen::Matrix3d c = f.transpose() * f, b = f * f.transpose(), fc = f * c;
  const double i1 = c.trace();
  const Vector9 v = as_vector(f);
  Invariant result{0.5 * (i1 * i1 - c.squaredNorm()), 2 * (i1 * v - as_vector(fc)),
                   4 * v * v.transpose() - 2 * crossed(f)};
  for (int I = 0; I < 3; ++I)
    for (int J = 0; J < 3; ++J)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result.second(i + 3 * I, j + 3 * J) +=
              2 * ((i == j && I == J ? i1 : 0) - (i == j ? c(I, J) : 0) - (I == J ? b(i, j) : 0));
  return result;
}

}  // namespace

Eigen::Matrix3d cofactor(const Eigen::Matrix3d& f) {
  Eigen::Matrix3d c;
  c << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
  return c;
}

StressAndTangent stress_and_tangent(const Material& material, const Eigen::Matrix3d& f, double pressure) {
  const Eigen::Matrix3d cof = cofactor(f);
  const double j = cof.col(0).dot(f.col(0));
  const Eigen::Matrix3d inverse_transposed = cof / j;
  const Vector9 inverse = as_vector(inverse_transposed);
  const Matrix9 inverse_crossed = crossed(inverse_transposed);

  const Invariant i1 = scaled(first_invariant(f), -2.0 / 3, j, inverse, inverse_crossed);
  const double e = i1.value - 3;
  const double slope = material.c10 + 2 * material.c20 * e + 3 * material.c30 * e * e,
               curvature = 2 * material.c20 + 6 * material.c30 * e;
  Vector9 stress = slope * i1.first;
  Matrix9 tangent = slope * i1.second + curvature * i1.first * i1.first.transpose();
  if (material.c01 != 0) {
    const Invariant i2 = scaled(second_invariant(f), -4.0 / 3, j, inverse, inverse_crossed);
    stress += material.c01 * i2.first;
    tangent += material.c01 * i2.second;
  }
  stress += pressure * as_vector(cof);
  tangent += pressure * j * (inverse * inverse.transpose() - inverse_crossed);
  return {Eigen::Map<const Eigen::Matrix3d>(stress.data()), tangent};
}

}  // namespace trivet::fem
