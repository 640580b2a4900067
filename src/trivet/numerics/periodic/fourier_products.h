// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>

namespace trivet::numerics {

/// The matrix that multiplies a periodic function of some harmonics by another one, both as coefficients
/// (fourier_basis.h): products of two harmonics k and l are those of k + l and k − l.
/// @param spectrum  coefficients of the factor to twice the harmonics, the first one doubled
[[nodiscard]] Eigen::MatrixXd product_matrix(const Eigen::VectorXd& spectrum, Eigen::Index harmonics);

/// Coefficients of the product of two periodic functions.
/// @param spectrum  of a factor to `harmonics` and those of the motion, the first one doubled
/// @param motion    of the other one
/// @param harmonics of the product; its first coefficient is doubled
[[nodiscard]] Eigen::VectorXd product(const Eigen::VectorXd& spectrum, const Eigen::VectorXd& motion,
                                      Eigen::Index harmonics);

/// Adds the coefficients of a function that is a constant from one phase to another and else 0; the first one doubled.
void add_stretch(double from, double to, double constant, Eigen::VectorXd& spectrum);

/// Of a matrix that acts on the coefficients of dx/dφ: the one that acts on those of x.
[[nodiscard]] Eigen::MatrixXd on_motion(const Eigen::MatrixXd& on_rate);

/// The coefficient of e^{inφ}, of real coefficients of which the first one is doubled.
[[nodiscard]] std::complex<double> exponential_coefficient(const Eigen::VectorXd& of, Eigen::Index n);

/// Receptances g_r + i g_i of a linear system under unit forces at the harmonics of a motion, for its coefficients
/// (fourier_basis.h). Coefficients a, b of a harmonic are the amplitude a − i b, which the receptance turns into g_r a
/// + g_i b and g_r b − g_i a: each coefficient times `on_own`, and the other one of its harmonic times `on_other`.
struct HarmonicReceptance {
  Eigen::MatrixXd on_own, on_other;  ///< coefficients × receptances; none of the mean to another coefficient
};

/// Adds the responses to courses, one per column: rows of all coefficients of one receptance after another, as many as
/// receptances.
/// @param first, count  columns of `receptances`
/// @param courses       coefficients × courses
/// @param sums          count times coefficients × courses
void add_responses(const HarmonicReceptance& receptances, Eigen::Index first, Eigen::Index count,
                   const Eigen::Ref<const Eigen::MatrixXd>& courses, Eigen::Ref<Eigen::MatrixXd> sums);

}  // namespace trivet::numerics
