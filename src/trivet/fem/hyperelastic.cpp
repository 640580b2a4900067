// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/hyperelastic.h"

#include <Eigen/Geometry>

#include <cmath>

namespace trivet::fem {
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
