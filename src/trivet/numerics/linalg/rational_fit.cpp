// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/rational_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::numerics {
namespace {

using Complex = std::complex<double>;

/// Combinations × functions: ±1 at random, the same in every run; empty, which means the identity, for few functions.
/// Sums of squares over the functions are nearly those over two dozen combinations with high probability.
Eigen::MatrixXd combinations_of(Eigen::Index functions) {
  constexpr Eigen::Index combinations = 24;
  if (functions < many_functions) return {};
  std::minstd_rand random(1);
  return Eigen::MatrixXd::NullaryExpr(combinations, functions, [&] { return random() % 2 == 0 ? 1.0 : -1.0; });
}

/// Loewner matrix of the samples and the nodes so far, with columns of unit length, and its Gram matrix.
class Loewner {
 public:
  Loewner(const Eigen::VectorXd& x, const Eigen::MatrixXcd& values, const Eigen::MatrixXd& scales)
      : x_(x),
        values_(values),
        scales_(scales),
        combinations_(combinations_of(values.rows())),
        functions_(combinations_.size() > 0 ? combinations_.rows() : values.rows()),
        rows_(functions_ * values.cols(), 0),
        gram_(0, 0) {}

  void add_node(Eigen::Index node) {
    assert(std::ranges::find(nodes_, node) == nodes_.end() && "a sample becomes a node once");
    const Eigen::Index old = to_index(nodes_.size());
    if (old > 0) {
      auto rows_of_node = rows_.middleRows(node * functions_, functions_);
      gram_ -= rows_of_node.adjoint() * rows_of_node;
      rows_of_node.setZero();
    }
    nodes_.push_back(node);
    Eigen::VectorXcd column = Eigen::VectorXcd::Zero(rows_.rows());
    for (Eigen::Index k = 0; k < x_.size(); ++k) {
      if (std::ranges::find(nodes_, k) != nodes_.end()) continue;
      const Eigen::VectorXcd slopes =
          ((values_.col(k) - values_.col(node)).array() / scales_.col(k).array() / (x_(k) - x_(node))).matrix();
      auto part = column.segment(k * functions_, functions_);
      if (combinations_.size() > 0)
        part.real() = combinations_ * slopes.real(), part.imag() = combinations_ * slopes.imag();
      else part = slopes;
    }
    const double length = column.norm();
    lengths_.push_back(length > 0 ? length : 1);
    column /= lengths_.back();
    const Eigen::VectorXcd products = rows_.adjoint() * column;
    rows_.conservativeResize(Eigen::NoChange, old + 1);
    rows_.col(old) = column;
    gram_.conservativeResize(old + 1, old + 1);
    gram_.col(old).head(old) = products;
    gram_.row(old).head(old) = products.adjoint();
    gram_(old, old) = column.squaredNorm();
  }

  [[nodiscard]] const std::vector<Eigen::Index>& nodes() const { return nodes_; }
  [[nodiscard]] bool combined() const { return combinations_.size() > 0; }
  /// No more weights than equations, of which each sample that is not a node has one per row.
  [[nodiscard]] Eigen::Index most_nodes() const {
    return std::min(x_.size() - 1, functions_ * x_.size() / (functions_ + 1));
  }

  /// The sample with the largest error of the combinations, without an evaluation: the rows times the weights are
  /// errors times the denominator. The error is the root of the sum of squares over the functions, or nearly.
  [[nodiscard]] std::pair<Eigen::Index, double> worst_combined(const Eigen::VectorXcd& weights) const {
    Eigen::VectorXcd scaled = weights;
    for (Eigen::Index j = 0; j < scaled.size(); ++j) scaled(j) *= lengths_[j];
    const Eigen::VectorXcd products = rows_ * scaled;
    std::pair<Eigen::Index, double> worst{x_.size() / 2, 0};
    for (Eigen::Index k = 0; k < x_.size(); ++k) {
      if (std::ranges::find(nodes_, k) != nodes_.end()) continue;
      Complex denominator = 0;
      for (std::size_t j = 0; j < nodes_.size(); ++j) denominator += weights(to_index(j)) / (x_(k) - x_(nodes_[j]));
      const double sum = products.segment(k * functions_, functions_).norm() / std::abs(denominator);
      const double error = sum / std::sqrt(static_cast<double>(functions_));
      // A pole on a sample gives NaN, which counts as an infinite error.
      const double counted = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
      if (counted > worst.second) worst = {k, counted};
    }
    return worst;
  }

  /// Weights by inverse iteration with the Gram matrix: good enough to choose the next node.
  [[nodiscard]] Eigen::VectorXcd quick_weights() const {
    const Eigen::Index n = gram_.rows();
    const double shift = 1e-15 * gram_.diagonal().real().sum() + std::numeric_limits<double>::min();
    const Eigen::LLT<Eigen::MatrixXcd> llt(Eigen::MatrixXcd(gram_ + shift * Eigen::MatrixXcd::Identity(n, n)));
    if (llt.info() != Eigen::Success) return exact_weights();
    return iterated([&](const Eigen::VectorXcd& v) { return Eigen::VectorXcd(llt.solve(v)); });
  }

  /// The same with the triangular factor of the matrix itself, which does not square the condition number.
  [[nodiscard]] Eigen::VectorXcd exact_weights() const {
    const Eigen::Index n = gram_.rows();
    const Eigen::HouseholderQR<Eigen::MatrixXcd> qr(rows_);
    Eigen::MatrixXcd r = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    const double least = std::numeric_limits<double>::epsilon() * r.diagonal().cwiseAbs().maxCoeff() +
        std::numeric_limits<double>::min();
    for (Eigen::Index j = 0; j < n; ++j)
      if (std::abs(r(j, j)) < least) r(j, j) = least;
    return iterated([&](const Eigen::VectorXcd& v) {
      const Eigen::VectorXcd y = r.adjoint().triangularView<Eigen::Lower>().solve(v);
      return Eigen::VectorXcd(r.triangularView<Eigen::Upper>().solve(y));
    });
  }

 private:
  template <typename Inverse>
  [[nodiscard]] Eigen::VectorXcd iterated(const Inverse& inverse) const {
    constexpr int steps = 4;
    const Eigen::Index n = gram_.rows();
    Eigen::VectorXcd v(n);
    for (Eigen::Index j = 0; j < n; ++j)
      v(j) = std::polar(1.0, 2.4 * static_cast<double>(j));  // no direction preferred
    for (int step = 0; step < steps; ++step) v = inverse(v.normalized());
    v.normalize();
    for (Eigen::Index j = 0; j < n; ++j) v(j) /= lengths_[j];
    return v / v.cwiseAbs().maxCoeff();
  }

  const Eigen::VectorXd& x_;
  const Eigen::MatrixXcd& values_;
  const Eigen::MatrixXd& scales_;
  Eigen::MatrixXd combinations_;
  Eigen::Index functions_;  ///< rows of one sample
  std::vector<Eigen::Index> nodes_;
  std::vector<double> lengths_;
  Eigen::MatrixXcd rows_;
  Eigen::MatrixXcd gram_;
};

RationalFit with_weights(const Eigen::VectorXd& x, const Eigen::MatrixXcd& values,
                         const std::vector<Eigen::Index>& nodes, Eigen::VectorXcd weights) {
  assert(weights.size() == to_index(nodes.size()));
  RationalFit fit{Eigen::VectorXd(to_index(nodes.size())), std::move(weights),
                  Eigen::MatrixXcd(values.rows(), to_index(nodes.size())), 0};
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    fit.nodes(to_index(j)) = x(nodes[j]);
    fit.values.col(to_index(j)) = values.col(nodes[j]);
  }
  return fit;
}

/// Index of the sample with the largest error; sets `fit.error`.
Eigen::Index worst_sample(const Eigen::VectorXd& x, const Eigen::MatrixXcd& values, const Eigen::MatrixXd& scales,
                          RationalFit& fit) {
  const Eigen::MatrixXcd found = fit.at(x);
  Eigen::Index worst = 0, function = 0;
  // A pole on a sample gives NaN, which counts as an infinite error.
  const Eigen::MatrixXd errors = ((found - values).cwiseAbs().array() / scales.array()).unaryExpr([](double e) {
    return std::isnan(e) ? std::numeric_limits<double>::infinity() : e;
  });
  fit.error = errors.maxCoeff(&function, &worst);
  return worst;
}

}  // namespace

Eigen::MatrixXcd RationalFit::at(const Eigen::VectorXd& x) const { return values * shares(x); }

Eigen::MatrixXcd RationalFit::shares(const Eigen::VectorXd& x) const {
  Eigen::MatrixXcd shares(nodes.size(), x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    Eigen::Index hit = -1;
    Complex sum = 0;
    for (Eigen::Index j = 0; j < nodes.size(); ++j) {
      const double distance = x(k) - nodes(j);
      if (distance == 0) hit = j;
      sum += shares(j, k) = weights(j) / distance;
    }
    if (hit >= 0) shares.col(k) = Eigen::VectorXcd::Unit(nodes.size(), hit);
    else shares.col(k) /= sum;
  }
  return shares;
}

Eigen::VectorXcd RationalFit::poles() const {
  // det(x − diag(x_j) + u 1ᵀ) with u_j = x_j w_j/Σw is x Σ_j w_j/(x − x_j) Π(x − x_j)/Σw.
  const Eigen::VectorXcd u = nodes.cast<Complex>().cwiseProduct(weights) / weights.sum();
  Eigen::MatrixXcd companion = -u * Eigen::RowVectorXcd::Ones(nodes.size());
  companion.diagonal() += nodes.cast<Complex>();
  return general_eigenvalues(companion).values;
}

RationalFit rational_fit(const Eigen::VectorXd& x, const Eigen::MatrixXcd& values, const Eigen::MatrixXd& scales,
                         double tolerance, const Eigen::VectorXd& first) {
  if (x.size() < 2 || values.cols() != x.size() || scales.cols() != x.size() || scales.rows() != values.rows() ||
      values.rows() < 1)
    throw foundation::InvalidInput("rational fit: the sizes of samples, values and scales do not match");
  if (!values.allFinite() || !(scales.minCoeff() > 0))
    throw foundation::InvalidInput("rational fit: values must be finite and scales > 0");
  Loewner loewner(x, values, scales);
  assert(std::ranges::is_sorted(x) && "samples ascend");
  const Eigen::Index most_nodes = loewner.most_nodes();
  RationalFit fit = with_weights(x, values, {x.size() / 2}, Eigen::VectorXcd::Ones(1));
  for (const double node : first) {
    const auto at = std::ranges::lower_bound(x, node) - x.begin();
    if (at < x.size() && x(at) == node && std::ssize(loewner.nodes()) < most_nodes) loewner.add_node(at);
  }
  if (!loewner.nodes().empty()) fit = with_weights(x, values, loewner.nodes(), loewner.quick_weights());
  constexpr double loose = 4;  // above this many tolerances the errors of the combinations decide
  for (bool added = true; added;) {
    const auto combined = loewner.combined() && !loewner.nodes().empty() ? loewner.worst_combined(fit.weights)
                                                                         : std::pair<Eigen::Index, double>(0, 0);
    Eigen::Index worst = combined.first;
    if (combined.second <= loose * tolerance) worst = worst_sample(x, values, scales, fit);
    else fit.error = combined.second;
    added = fit.error > tolerance && std::ssize(loewner.nodes()) < most_nodes;
    if (!added) break;
    loewner.add_node(worst);
    fit = with_weights(x, values, loewner.nodes(), loewner.quick_weights());
  }
  if (loewner.nodes().empty()) return fit;
  worst_sample(x, values, scales, fit);  // the error may be that of the combinations
  RationalFit exact = with_weights(x, values, loewner.nodes(), loewner.exact_weights());
  worst_sample(x, values, scales, exact);
  return exact.error <= fit.error ? exact : fit;
}

}  // namespace trivet::numerics
