// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/frequency_sweep.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/numerics/block_sweep.h"

namespace trivet::numerics {
namespace {

constexpr int lanes = 8;
typedef double Pack __attribute__((vector_size(lanes * sizeof(double))));

/// Eight complex numbers.
struct ComplexPack {
  Pack re;
  Pack im;
};

inline void subtract_product(ComplexPack& target, const ComplexPack& a, const ComplexPack& b) {
  target.re -= a.re * b.re - a.im * b.im;
  target.im -= a.re * b.im + a.im * b.re;
}

inline void multiply(ComplexPack& target, const ComplexPack& by) {
  const Pack re = target.re * by.re - target.im * by.im;
  target.im = target.re * by.im + target.im * by.re;
  target.re = re;
}

inline void broadcast(Pack& pack, double value) {
  for (int lane = 0; lane < lanes; ++lane) pack[lane] = value;
}

/// |x| by clearing the sign bit: a comparison would be done lane by lane.
inline Pack magnitude(const Pack& x) {
  typedef long long Bits __attribute__((vector_size(sizeof(Pack))));
  return reinterpret_cast<Pack>(reinterpret_cast<Bits>(x) & 0x7fffffffffffffffLL);
}

/// |re| + |im|.
inline Pack one_norm(const ComplexPack& z) { return magnitude(z.re) + magnitude(z.im); }

/// The larger of two, to round-off; NaN if either is.
inline Pack larger(const Pack& a, const Pack& b) { return 0.5 * (a + b + magnitude(a - b)); }

/// Share of the norm below which a pivot is nothing but round-off.
double negligible_pivot(Eigen::Index n) { return 16 * static_cast<double>(n) * std::numeric_limits<double>::epsilon(); }

/// LDLᵀ of Z at eight frequencies; its memory is reused from call to call.
class PackSolver {
 public:
  explicit PackSolver(const DynamicMatrices& matrices)
      : m_(matrices), n_(matrices.size()), h_(static_cast<std::size_t>(n_)), l_(static_cast<std::size_t>(n_ * n_)), w_(static_cast<std::size_t>(n_)),
        d_(static_cast<std::size_t>(n_)), d_inverse_(static_cast<std::size_t>(n_)), q_(static_cast<std::size_t>(n_)) {}

  /// The same right side for all eight.
  void set_load(const Eigen::VectorXcd& h) {
    for (Eigen::Index i = 0; i < n_; ++i) {
      broadcast(h_[at(i)].re, h(i).real());
      broadcast(h_[at(i)].im, h(i).imag());
    }
  }

  void set_load(int lane, const Eigen::VectorXcd& h) {
    for (Eigen::Index i = 0; i < n_; ++i) {
      h_[at(i)].re[lane] = h(i).real();
      h_[at(i)].im[lane] = h(i).imag();
    }
  }

  const std::vector<ComplexPack>& solve(const Pack& omega) {
    omega_ = omega;
    square_ = omega * omega;
    factorise();
    for (Eigen::Index i = 0; i < n_; ++i) {
      ComplexPack& x = q_[at(i)];
      x = h_[at(i)];
      for (Eigen::Index j = 0; j < i; ++j) subtract_product(x, l_[at(i, j)], q_[at(j)]);
    }
    for (Eigen::Index i = 0; i < n_; ++i) multiply(q_[at(i)], d_inverse_[at(i)]);
    for (Eigen::Index i = n_ - 1; i >= 0; --i)
      for (Eigen::Index j = i + 1; j < n_; ++j) subtract_product(q_[at(i)], l_[at(j, i)], q_[at(j)]);
    return q_;
  }

  /// Backward error of the last solution, with |re| + |im| for the modulus (within √2, and safe: see the threshold).
  Pack backward_error() const {
    Pack residual{}, norm{}, size{}, load{};
    for (Eigen::Index i = 0; i < n_; ++i) {
      ComplexPack r = h_[at(i)], z;
      load = larger(load, one_norm(r));
      Pack row{};
      for (Eigen::Index j = 0; j < n_; ++j) {
        entry(i, j, z);
        row += one_norm(z);
        subtract_product(r, z, q_[at(j)]);
      }
      residual = larger(residual, one_norm(r));
      norm = larger(norm, row);
      size = larger(size, one_norm(q_[at(i)]));
    }
    // A pivot that is round-off leaves a small residual and a meaningless solution: such a lane goes to the pivoted solver.
    Pack smallest = norm;
    for (Eigen::Index j = 0; j < n_; ++j) smallest = -larger(-smallest, -one_norm(d_[at(j)]));
    Pack error = residual / (norm * size + load);
    for (int lane = 0; lane < lanes; ++lane)
      if (!(smallest[lane] > negligible_pivot(n_) * norm[lane])) error[lane] = std::numeric_limits<double>::infinity();
    return error;
  }

 private:
  std::size_t at(Eigen::Index i) const { return static_cast<std::size_t>(i); }
  std::size_t at(Eigen::Index i, Eigen::Index j) const { return static_cast<std::size_t>(i * n_ + j); }

  void entry(Eigen::Index i, Eigen::Index j, ComplexPack& z) const {
    z.re = m_.K(i, j) - square_ * m_.A(i, j);
    z.im = omega_ * m_.B(i, j);
    if (m_.lossy()) z.im += m_.K_loss(i, j);
  }

  void factorise() {
    for (Eigen::Index j = 0; j < n_; ++j) {
      ComplexPack pivot;
      entry(j, j, pivot);
      for (Eigen::Index k = 0; k < j; ++k) {
        w_[at(k)] = l_[at(j, k)];
        multiply(w_[at(k)], d_[at(k)]);
        subtract_product(pivot, l_[at(j, k)], w_[at(k)]);
      }
      d_[at(j)] = pivot;
      const Pack modulus = 1.0 / (pivot.re * pivot.re + pivot.im * pivot.im);
      d_inverse_[at(j)].re = pivot.re * modulus;
      d_inverse_[at(j)].im = -pivot.im * modulus;
      for (Eigen::Index i = j + 1; i < n_; ++i) {
        ComplexPack& x = l_[at(i, j)];
        entry(i, j, x);
        for (Eigen::Index k = 0; k < j; ++k) subtract_product(x, l_[at(i, k)], w_[at(k)]);
        multiply(x, d_inverse_[at(j)]);
      }
    }
  }

  const DynamicMatrices& m_;
  Eigen::Index n_;
  Pack omega_{}, square_{};
  std::vector<ComplexPack> h_, l_, w_, d_, d_inverse_, q_;
};

double norm_of_rows(const Eigen::MatrixXcd& z) { return z.cwiseAbs().rowwise().sum().maxCoeff(); }

/// One frequency with partial pivoting and one step of refinement. Returns the backward error; NaN response if singular.
double solve_pivoted(const DynamicMatrices& m, const Eigen::VectorXcd& h, double omega, Eigen::Ref<Eigen::VectorXcd> q) {
  const Eigen::MatrixXcd z = m.at(omega);
  const double norm = norm_of_rows(z);
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(z);
  q = lu.solve(h);
  q += lu.solve(h - z * q);
  const double smallest_pivot = lu.matrixLU().diagonal().cwiseAbs().minCoeff();
  if (!q.allFinite() || smallest_pivot <= negligible_pivot(m.size()) * norm) {
    q.setConstant(std::numeric_limits<double>::quiet_NaN());
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double denominator = norm * q.cwiseAbs().maxCoeff() + h.cwiseAbs().maxCoeff();
  return denominator > 0 ? (h - z * q).cwiseAbs().maxCoeff() / denominator : 0;
}

}  // namespace

SweepResult sweep(const DynamicMatrices& given, const Load& load, const std::vector<double>& omega) {
  const Eigen::VectorXd d = unit_scale(given);
  const DynamicMatrices m = scaled(given, d);
  const Load h = load.scaled(d);
  const bool varies = !h.is_constant();
  const auto n = m.size(), count = static_cast<Eigen::Index>(omega.size());
  SweepResult result;
  result.response.resize(n, count);
  result.backward_error.setZero(count);
  if (h.vanishes()) {
    result.response.setZero();
    return result;
  }
  const Eigen::VectorXcd constant = varies ? Eigen::VectorXcd() : h.at(0);
  const auto redo_where_refused = [&](Eigen::Index first, Eigen::Index end) {
    for (Eigen::Index i = first; i < end; ++i) {
      if (result.backward_error(i) <= accepted_backward_error) continue;
      if (m.symmetric) ++result.fallbacks;
      const double w = omega[static_cast<std::size_t>(i)];
      result.backward_error(i) = solve_pivoted(m, varies ? h.at(w) : constant, w, result.response.col(i));
      result.response.col(i).array() *= d.array().cast<Complex>();
      if (std::isnan(result.backward_error(i))) ++result.singular;
    }
  };
  if (m.symmetric && n >= smallest_for_blocks) {
    BlockSweep(given, load).solve(omega.data(), count, result.response, result.backward_error);
    redo_where_refused(0, count);
    return result;
  }
  PackSolver packs(m);
  if (!varies) packs.set_load(constant);
  for (Eigen::Index first = 0; first < count; first += lanes) {
    const auto filled = static_cast<int>(std::min<Eigen::Index>(lanes, count - first));
    Pack error;
    broadcast(error, std::numeric_limits<double>::infinity());
    if (m.symmetric) {
      Pack frequencies;
      for (int lane = 0; lane < lanes; ++lane) frequencies[lane] = omega[static_cast<std::size_t>(first + std::min(lane, filled - 1))];
      for (int lane = 0; lane < lanes && varies; ++lane) packs.set_load(lane, h.at(frequencies[lane]));
      const std::vector<ComplexPack>& q = packs.solve(frequencies);
      error = packs.backward_error();
      for (Eigen::Index i = 0; i < n; ++i)
        for (int lane = 0; lane < filled; ++lane)
          result.response(i, first + lane) = d(i) * Complex(q[static_cast<std::size_t>(i)].re[lane], q[static_cast<std::size_t>(i)].im[lane]);
    }
    for (int lane = 0; lane < filled; ++lane) result.backward_error(first + lane) = error[lane];
    redo_where_refused(first, first + filled);
  }
  return result;
}

}  // namespace trivet::numerics
