// SPDX-License-Identifier: BSD-3-Clause
#include "support/random_designs.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <random>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::test {

numerics::Designs random_designs(int count, int n, double least, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  const auto random = [&](int rows, int columns) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
  };
  const auto ratio = [&] { return least * std::pow(0.5 / least, uniform(generator)); };
  const int entries = n * (n + 1) / 2;
  numerics::Designs designs{Eigen::ArrayXXd(count, entries), Eigen::ArrayXXd(count, entries),
                            Eigen::ArrayXXd(count, entries), Eigen::ArrayXXd(count, n)};
  for (int d = 0; d < count; ++d) {
    const auto kind = static_cast<DampingKind>(d % damping_kinds);
    const Eigen::MatrixXd factor = random(n, n);
    const Eigen::MatrixXd A = factor * factor.transpose() + 0.3 * n * Eigen::MatrixXd::Identity(n, n);
    const Eigen::MatrixXd turned = Eigen::HouseholderQR<Eigen::MatrixXd>(random(n, n)).householderQ();
    const Eigen::MatrixXd to_modes =
        turned.transpose() * Eigen::LLT<Eigen::MatrixXd>(A).matrixU().toDenseMatrix();  // Φ⁻¹
    Eigen::VectorXd omega(n), zeta(n);
    for (int i = 0; i < n; ++i) {
      omega(i) = 2 * std::exp(4 * uniform(generator));
      zeta(i) = kind == DampingKind::overdamped ? 0.01 * std::pow(500, uniform(generator)) : ratio();
    }
    if (kind == DampingKind::near_coincident)
      for (int i = 1; i < n; i += 2) omega(i) = omega(i - 1) * (1 + std::pow(10, -5 * uniform(generator)));
    Eigen::MatrixXd modal = (2 * zeta.cwiseProduct(omega)).asDiagonal();
    if (kind == DampingKind::coupled || kind == DampingKind::near_coincident || kind == DampingKind::overdamped) {
      const double share = 0.3 * uniform(generator) / std::sqrt(n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j)
          modal(i, j) = modal(j, i) = share * normal(generator) * std::sqrt(modal(i, i) * modal(j, j));
    }
    if (kind == DampingKind::few_dampers) {
      const Eigen::MatrixXd dampers = random(n, 3);
      const double strength = ratio();
      modal = 10 * strength * dampers * dampers.transpose() + Eigen::MatrixXd(0.01 * strength * omega.asDiagonal());
    }
    const Eigen::MatrixXd K = to_modes.transpose() * omega.cwiseAbs2().asDiagonal() * to_modes;
    const Eigen::MatrixXd B = kind == DampingKind::of_stiffness
        ? Eigen::MatrixXd(ratio() / 20 * K)
        : Eigen::MatrixXd(to_modes.transpose() * modal * to_modes);
    numerics::pack(A, designs.A, d);
    numerics::pack(B, designs.B, d);
    numerics::pack(K, designs.K, d);
    designs.load.row(d) = random(1, n).array();
  }
  return designs;
}

}  // namespace trivet::test
