// SPDX-License-Identifier: BSD-3-Clause
// Models along one parameter in quadruple precision. Five assembled models over the whole range of a parameter give
// every number that is a polynomial of at most the fourth degree in it, such as factors, masses and places, exactly
// between them; what follows from these numbers is solved in 113 bits.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>
#include <functional>
#include <vector>

#include "trivet/foundation/index.h"

namespace trivet::test {

using Quad = boost::multiprecision::cpp_bin_float_quad;

}  // namespace trivet::test

template <>
struct Eigen::NumTraits<trivet::test::Quad> : Eigen::GenericNumTraits<trivet::test::Quad> {
  enum { RequireInitialization = 1, ReadCost = 10, AddCost = 40, MulCost = 60 };
  static trivet::test::Quad dummy_precision() { return 1e-28; }
};

namespace trivet::test {

using QuadComplex = std::complex<Quad>;
using QuadMatrix = Eigen::Matrix<Quad, Eigen::Dynamic, Eigen::Dynamic>;
using QuadVector = Eigen::Matrix<Quad, Eigen::Dynamic, 1>;

/// Complex numbers as pairs of real ones: Eigen's solvers then work in quadruple precision.
struct QuadPair {
  QuadMatrix re, im;

  QuadPair operator+(const QuadPair& o) const { return {re + o.re, im + o.im}; }
  QuadPair operator-(const QuadPair& o) const { return {re - o.re, im - o.im}; }
  QuadPair operator*(const QuadPair& o) const { return {re * o.re - im * o.im, re * o.im + im * o.re}; }
  QuadPair operator*(const QuadComplex& f) const {
    return {re * f.real() - im * f.imag(), re * f.imag() + im * f.real()};
  }
  [[nodiscard]] QuadPair transposed() const { return {re.transpose(), im.transpose()}; }
  [[nodiscard]] QuadComplex value() const { return {re(0, 0), im(0, 0)}; }
};

/// Z⁻¹ b by the real system of twice the size.
class QuadFactors {
 public:
  explicit QuadFactors(const QuadPair& z) : n_(z.re.rows()) {
    QuadMatrix both(2 * n_, 2 * n_);
    both << z.re, -z.im, z.im, z.re;
    lu_.compute(both);
  }
  [[nodiscard]] QuadPair solve(const QuadPair& b) const {
    QuadMatrix both(2 * n_, b.re.cols());
    both << b.re, b.im;
    const QuadMatrix x = lu_.solve(both);
    return {x.topRows(n_), x.bottomRows(n_)};
  }

 private:
  Eigen::Index n_;
  Eigen::PartialPivLU<QuadMatrix> lu_;
};

/// K φ = λ A φ with φᵀAφ = 1, λ ascending.
struct QuadModes {
  QuadVector lambda;
  QuadMatrix shapes;
};
inline QuadModes quad_modes(const QuadMatrix& K, const QuadMatrix& A) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<QuadMatrix> found(K, A);
  return {found.eigenvalues(), found.eigenvectors()};
}

/// Numbers of models along one parameter, read from assembled models.
class QuadFamily {
 public:
  using Numbers = std::vector<Eigen::MatrixXd>;
  /// @param at  five values of the parameter, apart
  QuadFamily(const std::array<double, 5>& at, const std::function<Numbers(double)>& numbers) : at_(at) {
    for (const double value : at) numbers_.push_back(numbers(value));
  }
  [[nodiscard]] std::vector<QuadMatrix> operator()(const Quad& x) const {
    std::vector<QuadMatrix> sum;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      Quad weight = 1;
      for (std::size_t k = 0; k < at_.size(); ++k)
        if (k != i) weight *= (x - Quad(at_[k])) / (Quad(at_[i]) - Quad(at_[k]));
      for (std::size_t m = 0; m < numbers_[i].size(); ++m) {
        const QuadMatrix part = weight * numbers_[i][m].cast<Quad>();
        if (i == 0) sum.push_back(part);
        else sum[m] += part;
      }
    }
    return sum;
  }

 private:
  std::array<double, 5> at_;
  std::vector<Numbers> numbers_;
};

}  // namespace trivet::test
