// SPDX-License-Identifier: BSD-3-Clause
// How long does one frequency of a chain of bodies take, each coupled to the next and damped? Compared with LAPACK's
// dense and banded solvers and Eigen's sparse one with its pattern reused.
#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <string>

#include "chain.h"
#include "measure.h"
#include "quad.h"
#include "rivals/lapack.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/block_sweep.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;
using numerics::Complex;
using numerics::DynamicMatrices;

void dense(const DynamicMatrices& m, const Eigen::VectorXd& load, double omega, Complex* q) {
  Eigen::MatrixXcd z = m.at(omega);
  const auto n = static_cast<lapack_int>(load.size()), one = lapack_int{1};
  std::vector<lapack_int> pivots(to_size(n));
  lapack_int info = 0;
  for (Eigen::Index i = 0; i < n; ++i) q[i] = load[i];
  LAPACK_zgesv(&n, &one, z.data(), &n, pivots.data(), q, &n, &info);
}

/// A body is coupled to the next: 11 diagonals on either side.
void banded(const DynamicMatrices& m, const Eigen::VectorXd& load, double omega, Complex* q) {
  const lapack_int n = static_cast<lapack_int>(load.size()), one = 1, side = 11, height = 3 * side + 1;
  std::vector<Complex> z(to_size(n * height));
  std::vector<lapack_int> pivots(to_size(n));
  for (lapack_int j = 0; j < n; ++j)
    for (lapack_int i = std::max(0, j - side); i < std::min(n, j + side + 1); ++i)
      z[j * height + 2 * side + i - j] = Complex(m.K(i, j) - omega * omega * m.A(i, j), omega * m.B(i, j));
  lapack_int info = 0;
  for (Eigen::Index i = 0; i < n; ++i) q[i] = load[i];
  LAPACK_zgbsv(&n, &side, &side, &one, z.data(), &height, pivots.data(), q, &n, &info);
}

class Sparse {
 public:
  explicit Sparse(const DynamicMatrices& m) : z_(Eigen::SparseMatrix<Complex>(m.at(1).sparseView())) {
    for (Eigen::Index j = 0; j < z_.outerSize(); ++j)
      for (Eigen::SparseMatrix<Complex>::InnerIterator entry(z_, j); entry; ++entry)
        entries_.push_back({m.A(entry.row(), j), m.B(entry.row(), j), m.K(entry.row(), j)});
    solver_.analyzePattern(z_);
  }
  void solve(const Eigen::VectorXd& load, double omega, Complex* q) {
    for (std::size_t k = 0; k < entries_.size(); ++k)
      z_.valuePtr()[k] = {entries_[k].K - omega * omega * entries_[k].A, omega * entries_[k].B};
    solver_.factorize(z_);
    Eigen::Map<Eigen::VectorXcd>(q, load.size()) = solver_.solve(load.cast<Complex>());
  }

 private:
  struct Entry {
    double A, B, K;
  };
  Eigen::SparseMatrix<Complex> z_;
  std::vector<Entry> entries_;
  Eigen::SparseLU<Eigen::SparseMatrix<Complex>, Eigen::COLAMDOrdering<int>> solver_;
};

void chain(int bodies, std::size_t few, std::size_t many, bool last) {
  const DynamicMatrices m = chain_of(bodies);
  const Eigen::Index n = m.size();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
  load.tail(6) << 80, 111.8034, 60, -33.541, 37.818, -66.657;
  const std::vector<double> omega = even_frequencies(many, 60);
  numerics::SweepOptions options, with_errors;
  options.threads = with_errors.threads = 1;
  options.every_backward_error = false;
  Eigen::MatrixXcd q(n, to_index(few));
  Sparse sparse(m);
  const std::size_t stride = many / few;
  const auto all = [&](const auto& solve) {
    return [&, solve] {
      for (std::size_t k = 0; k < few; ++k) solve(omega[k * stride], q.data() + to_index(k) * n);
    };
  };
  const auto by_dense = all([&](double w, Complex* x) { dense(m, load, w, x); });
  const auto by_band = all([&](double w, Complex* x) { banded(m, load, w, x); });
  const auto by_sparse = all([&](double w, Complex* x) { sparse.solve(load, w, x); });

  const Eigen::VectorXd scale = m.A.diagonal().cwiseSqrt();
  std::vector<std::vector<QuadComplex>> truth;
  const std::size_t checks = bodies > 10 ? 1 : std::min<std::size_t>(few, bodies > 2 ? 8 : 300);
  for (std::size_t k = 0; k < checks; ++k) truth.push_back(quad_solution(m.A, m.B, m.K, load, omega[k * stride]));
  const auto check = [&](const char* method, const Eigen::MatrixXcd& x) {
    double worst = 0;
    for (std::size_t k = 0; k < checks; ++k) {
      const double error = forward_error(x.data() + to_index(k) * n, truth[k], scale);
      worst = error <= worst ? worst : error;
    }
    std::printf("  error of %-40s %.1e at %zu frequencies\n", method, worst, checks);
    compared(method, worst, 1e-9);
    return worst;
  };
  const numerics::SweepResult found = numerics::sweep(m, load, omega, options);
  Eigen::MatrixXcd mine(n, to_index(few));
  for (std::size_t k = 0; k < few; ++k) mine.col(to_index(k)) = found.response.col(to_index(k * stride));
  std::printf("  recomputed with pivoting: %d\n", found.fallbacks);
  const double error = check("Trivet", mine);
  by_dense(), check("zgesv", q);
  by_band(), check("zgbsv", q);
  by_sparse(), check("SparseLU", q);
  if (bodies > 2) {  // quad at a few frequencies only; the rest against the banded solver, also pivoted
    by_band();
    double worst = 0;
    for (std::size_t k = 0; k < few; ++k) {
      const auto c = to_index(k);
      const double difference =
          (mine.col(c) - q.col(c)).cwiseProduct(scale).norm() / q.col(c).cwiseProduct(scale).norm();
      worst = difference <= worst ? worst : difference;
    }
    compared("Trivet against zgbsv", worst, 1e-9);
  }

  const double flops = 8 * numerics::BlockSweep(m, load).multiply_adds();
  measure({"chain of bodies", std::to_string(bodies) + " bodies, all coordinates", "frequency", error},
          {in_process(
               "Trivet, every solution checked", double(many), [&] { (void)numerics::sweep(m, load, omega, options); },
               flops),
           in_process(
               "Trivet, with every backward error reported", double(many),
               [&] { (void)numerics::sweep(m, load, omega, with_errors); }, flops),
           in_process("LAPACK zgesv", double(few), by_dense, 0, last ? 700 : 0),
           in_process("LAPACK zgbsv", double(few), by_band, 0, last ? 35 : 0),
           in_process("Eigen SparseLU, pattern reused", double(few), by_sparse)},
          9);
}

}  // namespace

int main() {
  const OneCore one_core;
  openblas_set_num_threads(1);
  chain(2, 500, 10000, false);
  chain(10, 100, 4000, false);
  chain(50, 8, 2000, true);
}
