// SPDX-License-Identifier: BSD-3-Clause
// The usual C++ ways to q = (K + iωB − ω²A)⁻¹h, one frequency after the other: Eigen's fixed-size pivoted LU, LAPACK's zgesv and zsysv.
#pragma once

#include <Eigen/LU>
#include <complex>

#include "paper_machine.h"
#include "rivals/lapack.h"

namespace trivet::benchmarks {

using Complex = std::complex<double>;
using Matrix6c = Eigen::Matrix<Complex, 6, 6>;

inline Matrix6c dynamic_stiffness(const PaperMachine& m, double omega) {
  Matrix6c z;
  z.real() = m.K - omega * omega * m.A;
  z.imag() = omega * m.B;
  return z;
}

inline void eigen_fixed_lu(const PaperMachine& m, const std::vector<double>& omega, Eigen::MatrixXcd& q) {
  const Eigen::Matrix<Complex, 6, 1> h = m.load.cast<Complex>();
  for (std::size_t i = 0; i < omega.size(); ++i) q.col(static_cast<Eigen::Index>(i)) = dynamic_stiffness(m, omega[i]).partialPivLu().solve(h);
}

inline void lapack_zgesv(const PaperMachine& m, const std::vector<double>& omega, Eigen::MatrixXcd& q) {
  const lapack_int n = 6, one = 1;
  lapack_int pivots[6], info = 0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    Matrix6c z = dynamic_stiffness(m, omega[i]);
    auto x = q.col(static_cast<Eigen::Index>(i));
    x = m.load.cast<Complex>();
    LAPACK_zgesv(&n, &one, z.data(), &n, pivots, x.data(), &n, &info);
  }
}

inline void lapack_zsysv(const PaperMachine& m, const std::vector<double>& omega, Eigen::MatrixXcd& q) {
  const lapack_int n = 6, one = 1, work_size = 64 * 6;
  lapack_int pivots[6], info = 0;
  Complex work[64 * 6];
  for (std::size_t i = 0; i < omega.size(); ++i) {
    Matrix6c z = dynamic_stiffness(m, omega[i]);
    auto x = q.col(static_cast<Eigen::Index>(i));
    x = m.load.cast<Complex>();
    LAPACK_zsysv("L", &n, &one, z.data(), &n, pivots, x.data(), &n, work, &work_size, &info);
  }
}

}  // namespace trivet::benchmarks
