// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/refined_solution.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::numerics {

PivotedSolution pivoted_solution(const Eigen::MatrixXcd& Z, const Eigen::VectorXcd& h, bool with_condition) {
  assert(Z.rows() == Z.cols() && h.size() == Z.rows());
  const PivotedLu<std::complex<double>> lu(Z);
  PivotedSolution result{lu.solve(h)};
  Eigen::VectorXcd& x = result.x;
  const Eigen::VectorXcd reached = Z * x;
  x += lu.solve(Eigen::VectorXcd(h - reached));
  const double norm = Z.cwiseAbs().rowwise().sum().maxCoeff();
  if (!x.allFinite() || lu.smallest_pivot() <= negligible_pivot(static_cast<int>(Z.rows())) * norm) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    x.setConstant({nan, nan});
    return {x, nan, std::numeric_limits<double>::infinity()};
  }
  const double possible = norm * x.cwiseAbs().maxCoeff() + h.cwiseAbs().maxCoeff();
  result.backward_error = possible > 0 ? (h - Z * x).cwiseAbs().maxCoeff() / possible : 0;
  if (with_condition) result.condition = 1 / lu.reciprocal_condition();
  return result;
}

namespace {

std::vector<ExtendedEntry> nonzero_entries(const ExtendedMatrix& z) {
  std::vector<ExtendedEntry> entries;
  for (Eigen::Index j = 0; j < z.cols(); ++j)
    for (Eigen::Index i = 0; i < z.rows(); ++i)
      if (z(i, j) != std::complex<long double>()) entries.push_back({i, j, z(i, j)});
  return entries;
}

/// Z itself as a system without mass and damping.
SparseSystem stiffness_alone(Eigen::Index size, const std::vector<ExtendedEntry>& entries) {
  std::vector<SparseSystem::Entry> stiffness;
  stiffness.reserve(entries.size());
  for (const ExtendedEntry& e : entries) stiffness.push_back({e.row, e.column, 0, 0, Complex(e.value)});
  return SparseSystem(size, std::move(stiffness));
}

}  // namespace

RefinedSolver::RefinedSolver(const ExtendedMatrix& Z) : RefinedSolver(Z.rows(), nonzero_entries(Z)) {}

RefinedSolver::RefinedSolver(Eigen::Index size, std::vector<ExtendedEntry> entries)
    : size_(size),
      entries_(std::move(entries)),
      system_(stiffness_alone(size_, entries_)),
      factors_(system_.factors(0)) {}

ExtendedVector RefinedSolver::solve(const ExtendedVector& b) const {
  using Terms = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const ExtendedProducts products{[&](const ExtendedVector& x) {
                                    ExtendedVector rest = b;
                                    for (const ExtendedEntry& e : entries_) rest(e.row) -= e.value * x(e.column);
                                    return rest;
                                  },
                                  [&](const ExtendedVector& x) {
                                    Terms sums = b.cwiseAbs();
                                    for (const ExtendedEntry& e : entries_)
                                      sums(e.row) += std::abs(e.value) * std::abs(x(e.column));
                                    return sums;
                                  }};
  if (const auto x = refined_solution(factors_, b, products)) return *x;
  // Too ill-conditioned for factors in double: solve in extended precision.
  ExtendedMatrix z = ExtendedMatrix::Zero(size_, size_);
  for (const ExtendedEntry& e : entries_) z(e.row, e.column) = e.value;
  return lu_solution(z, b);
}

double RefinedSolver::condition() const {
  // With a pivot of exactly 0 the estimate would describe only the other coordinates.
  if (factors_.singular()) return std::numeric_limits<double>::infinity();
  constexpr int most_steps = 5;
  const SystemFactors transposed = system_.factors(0, true);
  Eigen::VectorXcd x = Eigen::VectorXcd::Constant(size_, 1.0 / static_cast<double>(size_));
  double largest = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXcd y = factors_.solve(x);
    if (!y.allFinite()) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, y.lpNorm<1>());
    const Eigen::VectorXcd sign =
        y.unaryExpr([](const Complex& v) { return std::abs(v) > 0 ? v / std::abs(v) : Complex(1); });
    const Eigen::VectorXcd rise = transposed.solve(Eigen::VectorXcd(sign.conjugate())).conjugate();
    Eigen::Index steepest = 0;
    if (!(rise.cwiseAbs().maxCoeff(&steepest) > std::real(rise.dot(x)))) break;
    x = Eigen::VectorXcd::Unit(size_, steepest);
  }
  Eigen::Matrix<long double, Eigen::Dynamic, 1> columns(size_);
  columns.setZero();
  for (const ExtendedEntry& e : entries_) columns(e.column) += std::abs(e.value);
  return largest * static_cast<double>(columns.maxCoeff());
}

}  // namespace trivet::numerics
