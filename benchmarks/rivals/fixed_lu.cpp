// SPDX-License-Identifier: BSD-3-Clause
#include "rivals/fixed_lu.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "rivals/lapack.h"

namespace trivet::benchmarks {
namespace {

using Complex = std::complex<double>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6c = Eigen::Matrix<Complex, 6, 6>;

struct System {
  explicit System(const SixCoordinates& s)
      : A(Eigen::Map<const Matrix6>(s.A)),
        B(Eigen::Map<const Matrix6>(s.B)),
        K(Eigen::Map<const Matrix6>(s.K)),
        load(Eigen::Map<const Vector6>(s.load).cast<Complex>()) {}
  [[nodiscard]] Matrix6c at(double omega) const {
    Matrix6c z;
    z.real() = K - omega * omega * A;
    z.imag() = omega * B;
    return z;
  }
  Matrix6 A, B, K;
  Eigen::Matrix<Complex, 6, 1> load;
};

}  // namespace

void eigen_fixed_lu(const SixCoordinates& system, const double* omega, std::size_t count, Complex* q) {
  const System s(system);
  for (std::size_t i = 0; i < count; ++i)
    Eigen::Map<Eigen::Matrix<Complex, 6, 1>>(q + 6 * i) = s.at(omega[i]).partialPivLu().solve(s.load);
}

void lapack_zgesv(const SixCoordinates& system, const double* omega, std::size_t count, Complex* q) {
  const System s(system);
  const lapack_int n = 6, one = 1;
  lapack_int pivots[6], info = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Matrix6c z = s.at(omega[i]);
    std::copy_n(s.load.data(), 6, q + 6 * i);
    LAPACK_zgesv(&n, &one, z.data(), &n, pivots, q + 6 * i, &n, &info);
  }
}

void lapack_zsysv(const SixCoordinates& system, const double* omega, std::size_t count, Complex* q) {
  const System s(system);
  const lapack_int n = 6, one = 1, work_size = 64 * 6;
  lapack_int pivots[6], info = 0;
  Complex work[64 * 6];
  for (std::size_t i = 0; i < count; ++i) {
    Matrix6c z = s.at(omega[i]);
    std::copy_n(s.load.data(), 6, q + 6 * i);
    LAPACK_zsysv("L", &n, &one, z.data(), &n, pivots, q + 6 * i, &n, work, &work_size, &info);
  }
}

void eigen_fixed_modes(const double* K, const double* A, double* lambda, double* shapes) {
  const Matrix6 stiffness = Eigen::Map<const Matrix6>(K), mass = Eigen::Map<const Matrix6>(A);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6> solver(stiffness, mass);
  Eigen::Map<Vector6>(lambda, 6) = solver.eigenvalues();
  Eigen::Map<Matrix6>(shapes, 6, 6) = solver.eigenvectors();
}

void lapack_dsygv(const double* K, const double* A, double* lambda, double* shapes) {
  const lapack_int type = 1, n = 6, work_size = 64 * 6;
  lapack_int info = 0;
  double mass[36], work[64 * 6];
  std::copy_n(A, 36, mass);
  std::copy_n(K, 36, shapes);
  LAPACK_dsygv(&type, "V", "L", &n, shapes, &n, mass, &n, lambda, work, &work_size, &info);
}

}  // namespace trivet::benchmarks
