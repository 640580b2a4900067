// SPDX-License-Identifier: BSD-3-Clause
// Coordinates without mass of which a skew damper acts on one combination only.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "trivet/numerics/linalg/massless.h"
#include "trivet/numerics/linalg/pole_residue.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/peaks/response_series.h"

namespace parted_system_test {

using namespace trivet::numerics;

constexpr double round_off = 1e-11;  // of three coordinates

/// One mass on two massless coordinates; the damper is at 30° to them.
DynamicMatrices skew_damper(double loss) {
  DynamicMatrices m;
  m.A = m.B = m.K = Eigen::Matrix3d::Zero();
  m.A(0, 0) = 2;
  const Eigen::Vector2d along(std::cos(0.5236), std::sin(0.5236));
  m.B.bottomRightCorner<2, 2>() = 7 * along * along.transpose();
  m.K << 50, -20, -30, -20, 45, 5, -30, 5, 60;
  if (loss > 0) m.K_loss = loss * m.K;
  return m;
}

TEST(PartedSystem, LeavesTheDamperOnOneCoordinate) {
  const DynamicMatrices m = skew_damper(0);
  const PartedSystem parted = parted_system(m);
  ASSERT_TRUE(parted.any);
  int damped = 0;
  for (int i = 1; i < 3; ++i) damped += !parted.matrices.B.row(i).isZero(0);
  EXPECT_EQ(damped, 1);
  const Eigen::MatrixXd back = parted.basis.transpose().inverse() * parted.matrices.B * parted.basis.inverse();
  EXPECT_LT((back - m.B).cwiseAbs().maxCoeff(), round_off * m.B.cwiseAbs().maxCoeff());
  EXPECT_FALSE(parted_system(parted.matrices).any);
}

TEST(PartedSystem, RootsMakeTheDynamicStiffnessSingular) {
  const DynamicMatrices m = skew_damper(0);
  const SystemRoots found = system_roots(m);
  ASSERT_EQ(found.roots.lambda.size(), 3);  // two of the mass, one relaxation
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Complex l = found.roots.lambda(i);
    const Eigen::MatrixXcd z = m.K.cast<Complex>() + l * m.B.cast<Complex>() + l * l * m.A.cast<Complex>();
    EXPECT_LT((z * found.roots.vectors.col(i)).norm(), round_off * z.norm() * found.roots.vectors.col(i).norm()) << l;
  }
}

TEST(PartedSystem, PolesAndResiduesAndTheSeriesAtInfinityAreTheResponse) {
  for (const double loss : {0.0, 0.1}) {
    const DynamicMatrices m = skew_damper(loss);
    const Eigen::Vector3cd h(1, Complex(0.3, 1), -2);
    const PoleResidueForm form = pole_residue_form(m, h);
    const auto exact = [&](double omega) -> Eigen::VectorXcd { return m.at(omega).fullPivLu().solve(h); };
    for (const double omega : {0.5, 4.0, 30.0}) {
      Eigen::VectorXcd sum = form.static_part;
      for (Eigen::Index k = 0; k < form.poles.size(); ++k)
        sum += form.shapes.col(k) * form.participation(k, 0) / (Complex(0, omega) - form.poles(k));
      EXPECT_LT((sum - exact(omega)).norm(), round_off * exact(omega).norm()) << omega << " " << loss;
    }
    constexpr double far = 400;
    const SeriesAtInfinity series = ResponseSeries(m, Load(h)).at_infinity(1 / far, 60);
    const double s = 0.25 / far;  // a quarter of the radius
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(3);
    for (Eigen::Index j = 0; j < series.coefficients.cols(); ++j) sum += series.coefficients.col(j) * std::pow(0.25, j);
    EXPECT_LT((sum * std::pow(s, series.power) - exact(1 / s)).norm(), round_off * exact(1 / s).norm()) << loss;
  }
}

}  // namespace parted_system_test
