// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// LU factors of Z(ω) at one ω, in double.
class SystemFactors {
 public:
  /// Meaningless if Z is singular.
  [[nodiscard]] Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const;
  /// True if a pivot is exactly 0.
  [[nodiscard]] bool singular() const;

 private:
  friend class SparseSystem;
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Z(ω) = K + iK_loss + iωB − ω²A of one system by its nonzero entries: in a chain of bodies these are few. Safe for
/// several threads at once.
class SparseSystem {
 public:
  template <typename Real>
  using Vector = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, 1>;
  struct Entry {
    Eigen::Index row, column;
    double a, b;
    Complex k;
  };

  explicit SparseSystem(const DynamicMatrices& matrices);
  /// @param entries  column by column, each place once; not taken as symmetric
  SparseSystem(Eigen::Index size, std::vector<Entry> entries);

  [[nodiscard]] Eigen::Index size() const { return size_; }
  [[nodiscard]] bool symmetric() const { return symmetric_; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// Whether most entries are zero and the system is large, so that factors are sparse.
  [[nodiscard]] bool has_sparse_factors() const { return sparse_; }

  /// The k-th derivative of Z with respect to ω, times x. Real: double or long double.
  template <typename Real>
  [[nodiscard]] Vector<Real> product(int derivative, Real omega, const Vector<Real>& x, bool transposed = false) const;

  /// (λ²A + λB + K + iK_loss) x in extended precision.
  [[nodiscard]] Vector<long double> polynomial(const std::complex<long double>& lambda,
                                               const Vector<long double>& x) const;
  /// Largest |Z_ij|.
  [[nodiscard]] double largest_entry(double omega) const;

  /// Factors of Z or Zᵀ: sparse, in an order with little fill, if most entries are zero; else dense.
  [[nodiscard]] SystemFactors factors(double omega, bool transposed = false) const;

  /// Solution of Z x = b (or Zᵀ x = b) in nearly extended precision: residuals in long double, refined until converged,
  /// with factors of a nearby ω; if that does not converge, LU in long double.
  [[nodiscard]] Vector<long double> solution(const SystemFactors& factors, long double omega,
                                             const Vector<long double>& b, bool transposed = false) const;

 private:
  void choose_factors();
  [[nodiscard]] Eigen::MatrixXcd dense(double omega, bool transposed) const;
  /// Σ_j |Z_ij| |x_j|.
  [[nodiscard]] Eigen::Matrix<long double, Eigen::Dynamic, 1> terms(long double omega, const Vector<long double>& x,
                                                                    bool transposed) const;

  Eigen::Index size_;
  bool symmetric_, sparse_ = false;
  std::vector<Entry> entries_;       ///< column by column
  std::vector<Eigen::Index> order_;  ///< of the coordinates for sparse factors: place of each one
};

/// A linear system Z x = b in extended precision, by its products.
struct ExtendedProducts {
  std::function<ExtendedVector(const ExtendedVector& x)> residual;  ///< b − Z x
  /// Σ|Z_ij||x_j| + |b_i| per row: the residual is exact to some units of round-off of it.
  std::function<Eigen::Matrix<long double, Eigen::Dynamic, 1>(const ExtendedVector& x)> terms;
};

/// Solution refined by factors of Z in double: converged, or with a residual of round-off, as no factors in extended
/// precision would give a smaller one. Empty if neither is reached.
[[nodiscard]] std::optional<ExtendedVector> refined_solution(const SystemFactors& factors, const ExtendedVector& b,
                                                             const ExtendedProducts& products);

}  // namespace trivet::numerics
