// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/sparse_system.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::numerics {
namespace {

using Sparse = Eigen::SparseMatrix<Complex>;
using SparseFactors = Eigen::SparseLU<Sparse, Eigen::NaturalOrdering<int>>;

/// Measured on chains of bodies: below this size, or with more entries, dense factors are faster.
constexpr Eigen::Index least_sparse = 30;
constexpr double most_filled = 0.3;

/// Place of each coordinate in an elimination order with little fill.
std::vector<Eigen::Index> elimination_order(Eigen::Index n, const std::vector<SparseSystem::Entry>& entries) {
  std::vector<Eigen::Triplet<double>> places;
  for (const SparseSystem::Entry& e : entries) {
    places.emplace_back(e.row, e.column, 1.0);
    places.emplace_back(e.column, e.row, 1.0);
  }
  Eigen::SparseMatrix<double> pattern(n, n);
  pattern.setFromTriplets(places.begin(), places.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  // The ordering returns the coordinate at each place.
  std::vector<Eigen::Index> place(to_size(n));
  for (Eigen::Index at = 0; at < n; ++at) place[order.indices()(at)] = at;
  return place;
}

template <typename Real>
std::complex<Real> coefficient(const SparseSystem::Entry& e, int derivative, Real omega) {
  using Scalar = std::complex<Real>;
  if (derivative == 2) return -2 * Real(e.a);
  if (derivative == 1) return Scalar(-2 * omega * Real(e.a), Real(e.b));
  return Scalar(Real(e.k.real()) - omega * omega * Real(e.a), Real(e.k.imag()) + omega * Real(e.b));
}

}  // namespace

struct SystemFactors::Data {
  std::optional<PivotedLu<Complex>> dense;
  std::optional<SparseFactors> sparse;
  std::vector<Eigen::Index> place;  // of the coordinates in the sparse factors
};

Eigen::VectorXcd SystemFactors::solve(const Eigen::VectorXcd& b) const {
  assert(data_ && "factors come from SparseSystem::factors");
  if (data_->dense) return data_->dense->solve(b);
  assert(b.size() == to_index(data_->place.size()) && "one place in the factors for each coordinate");
  Eigen::VectorXcd ordered(b.size()), x(b.size());
  for (Eigen::Index i = 0; i < b.size(); ++i) ordered(data_->place[i]) = b(i);
  const Eigen::VectorXcd solved = data_->sparse->solve(ordered);
  for (Eigen::Index i = 0; i < b.size(); ++i) x(i) = solved(data_->place[i]);
  return x;
}

bool SystemFactors::singular() const { return data_->dense && !(data_->dense->smallest_pivot() > 0); }

SparseSystem::SparseSystem(const DynamicMatrices& m) : size_(m.size()), symmetric_(m.symmetric) {
  assert(m.B.rows() == size_ && m.K.cols() == size_ && "A, B and K have one size");
  for (Eigen::Index j = 0; j < size_; ++j)
    for (Eigen::Index i = 0; i < size_; ++i) {
      const double loss = m.lossy() ? m.K_loss(i, j) : 0;
      if (m.A(i, j) != 0 || m.B(i, j) != 0 || m.K(i, j) != 0 || loss != 0)
        entries_.push_back({i, j, m.A(i, j), m.B(i, j), {m.K(i, j), loss}});
    }
  choose_factors();
}

SparseSystem::SparseSystem(Eigen::Index size, std::vector<Entry> entries)
    : size_(size), symmetric_(false), entries_(std::move(entries)) {
  assert(std::ranges::all_of(
      entries_, [&](const Entry& e) { return e.row >= 0 && e.row < size_ && e.column >= 0 && e.column < size_; }));
  choose_factors();
}

void SparseSystem::choose_factors() {
  sparse_ = size_ > least_sparse &&
      static_cast<double>(entries_.size()) < most_filled * static_cast<double>(size_) * static_cast<double>(size_);
  if (sparse_) order_ = elimination_order(size_, entries_);
}

template <typename Real>
SparseSystem::Vector<Real> SparseSystem::product(int derivative, Real omega, const Vector<Real>& x,
                                                 bool transposed) const {
  assert(x.size() == size_);
  Vector<Real> y = Vector<Real>::Zero(size_);
  for (const Entry& e : entries_) {
    const std::complex<Real> c = coefficient(e, derivative, omega), &entry = x(transposed ? e.row : e.column);
    std::complex<Real>& sum = y(transposed ? e.column : e.row);
    // Written out: the product of complex numbers in the standard library checks for NaN.
    sum = {sum.real() + (c.real() * entry.real() - c.imag() * entry.imag()),
           sum.imag() + (c.real() * entry.imag() + c.imag() * entry.real())};
  }
  return y;
}

template SparseSystem::Vector<double> SparseSystem::product(int, double, const Vector<double>&, bool) const;
template SparseSystem::Vector<long double> SparseSystem::product(int, long double, const Vector<long double>&,
                                                                 bool) const;

SparseSystem::Vector<long double> SparseSystem::polynomial(const std::complex<long double>& lambda,
                                                           const Vector<long double>& x) const {
  using Extended = long double;
  const std::complex<Extended> square = lambda * lambda;
  assert(x.size() == size_);
  Vector<Extended> y = Vector<Extended>::Zero(size_);
  for (const Entry& e : entries_) {
    const Extended re = Extended(e.k.real()) + lambda.real() * Extended(e.b) + square.real() * Extended(e.a),
                   im = Extended(e.k.imag()) + lambda.imag() * Extended(e.b) + square.imag() * Extended(e.a);
    const std::complex<Extended>& entry = x(e.column);
    std::complex<Extended>& sum = y(e.row);
    sum = {sum.real() + (re * entry.real() - im * entry.imag()), sum.imag() + (re * entry.imag() + im * entry.real())};
  }
  return y;
}

double SparseSystem::largest_entry(double omega) const {
  double largest = 0;
  for (const Entry& e : entries_) largest = std::max(largest, std::norm(coefficient(e, 0, omega)));
  return std::sqrt(largest);
}

Eigen::MatrixXcd SparseSystem::dense(double omega, bool transposed) const {
  Eigen::MatrixXcd z = Eigen::MatrixXcd::Zero(size_, size_);
  for (const Entry& e : entries_) (transposed ? z(e.column, e.row) : z(e.row, e.column)) = coefficient(e, 0, omega);
  return z;
}

SystemFactors SparseSystem::factors(double omega, bool transposed) const {
  auto data = std::make_shared<SystemFactors::Data>();
  if (sparse_) {
    std::vector<Eigen::Triplet<Complex>> values;
    values.reserve(entries_.size());
    for (const Entry& e : entries_) {
      const Eigen::Index row = order_[e.row], column = order_[e.column];
      values.emplace_back(transposed ? column : row, transposed ? row : column, coefficient(e, 0, omega));
    }
    Sparse z(size_, size_);
    z.setFromTriplets(values.begin(), values.end());
    data->sparse.emplace();
    data->sparse->isSymmetric(true);
    data->sparse->setPivotThreshold(0.1);  // prefers the diagonal, which keeps the order and its fill
    data->sparse->compute(z);
    data->place = order_;
    if (data->sparse->info() != Eigen::Success) data->sparse.reset();  // singular: dense factors show how
  }
  if (!data->sparse) data->dense.emplace(dense(omega, transposed));
  SystemFactors result;
  result.data_ = std::move(data);
  return result;
}

Eigen::Matrix<long double, Eigen::Dynamic, 1> SparseSystem::terms(long double omega, const Vector<long double>& x,
                                                                  bool transposed) const {
  Eigen::Matrix<long double, Eigen::Dynamic, 1> sums(size_);
  sums.setZero();
  for (const Entry& e : entries_) {
    const long double real = std::abs(static_cast<long double>(e.k.real())) + omega * omega * std::abs(e.a),
                      imaginary = std::abs(static_cast<long double>(e.k.imag())) + omega * std::abs(e.b);
    sums(transposed ? e.column : e.row) += (real + imaginary) * std::abs(x(transposed ? e.row : e.column));
  }
  return sums;
}

std::optional<ExtendedVector> refined_solution(const SystemFactors& factors, const ExtendedVector& b,
                                               const ExtendedProducts& products) {
  using Extended = long double;
  constexpr int most_steps = 12;
  constexpr Extended settled = 64 * std::numeric_limits<Extended>::epsilon();
  const auto step = [&](const ExtendedVector& r) -> ExtendedVector {
    return factors.solve(Eigen::VectorXcd(r.cast<Complex>())).cast<std::complex<Extended>>();
  };
  ExtendedVector x = step(b);
  Extended previous = std::numeric_limits<Extended>::infinity();
  for (int i = 0; i < most_steps; ++i) {
    const ExtendedVector residual = products.residual(x), correction = step(residual);
    const Extended size = correction.norm();
    if (size <= settled * x.norm()) return x + correction;
    if (!(size < 0.5L * previous)) {
      if ((residual.cwiseAbs().array() <= settled * products.terms(x).array()).all()) return x;
      break;
    }
    x += correction;
    previous = size;
  }
  return std::nullopt;
}

SparseSystem::Vector<long double> SparseSystem::solution(const SystemFactors& factors, long double omega,
                                                         const Vector<long double>& b, bool transposed) const {
  using Terms = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const ExtendedProducts products{
      [&](const ExtendedVector& x) -> ExtendedVector { return b - product<long double>(0, omega, x, transposed); },
      [&](const ExtendedVector& x) -> Terms { return terms(omega, x, transposed) + b.cwiseAbs(); }};
  if (const auto refined = refined_solution(factors, b, products)) return *refined;
  // Too ill-conditioned for factors in double: solve in extended precision.
  ExtendedMatrix z = ExtendedMatrix::Zero(size_, size_);
  for (const Entry& e : entries_) (transposed ? z(e.column, e.row) : z(e.row, e.column)) = coefficient(e, 0, omega);
  return lu_solution(z, b);
}

}  // namespace trivet::numerics
