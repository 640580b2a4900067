// SPDX-License-Identifier: BSD-3-Clause
// The usual C++ ways to q = (K + iωB − ω²A)⁻¹h of six coordinates, one frequency after the other. Compiled for this
// very processor, as their users would; matrices by columns, so that nothing of Eigen is shared with the rest of the
// program.
#pragma once

#include <complex>
#include <cstddef>

namespace trivet::benchmarks {

struct SixCoordinates {
  const double *A, *B, *K, *load;
};

/// q: 6 × count
using SixCoordinateSolver = void (*)(const SixCoordinates& system, const double* omega, std::size_t count,
                                     std::complex<double>* q);

void eigen_fixed_lu(const SixCoordinates& system, const double* omega, std::size_t count, std::complex<double>* q);
void lapack_zgesv(const SixCoordinates& system, const double* omega, std::size_t count, std::complex<double>* q);
void lapack_zsysv(const SixCoordinates& system, const double* omega, std::size_t count, std::complex<double>* q);

/// λ ascending and φ with φᵀAφ = 1 of K φ = λ A φ, by columns.
using SixCoordinateModes = void (*)(const double* K, const double* A, double* lambda, double* shapes);

void eigen_fixed_modes(const double* K, const double* A, double* lambda, double* shapes);
void lapack_dsygv(const double* K, const double* A, double* lambda, double* shapes);

}  // namespace trivet::benchmarks
