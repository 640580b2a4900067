// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::test {

using Edges = std::vector<std::pair<Eigen::Index, Eigen::Index>>;  ///< pairs of coupled bodies
using Sizes = std::vector<Eigen::Index>;                           ///< coordinates of each body

/// Draws systems of bodies in a graph, and loads on them.
class CoupledBodies {
 public:
  explicit CoupledBodies(unsigned seed) : generator_(seed) {}

  /// Bodies with `sizes` coordinates, elements of damping ratio near `damping` between them, the first on the ground.
  numerics::DynamicMatrices bodies(const Sizes& sizes, const Edges& edges, double damping) {
    std::vector<Eigen::Index> first = {0};
    for (const Eigen::Index s : sizes) first.push_back(first.back() + s);
    const Eigen::Index n = first.back();
    numerics::DynamicMatrices m{
        Eigen::MatrixXd::Zero(n, n),     Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), {}, true,
        {first.begin(), first.end() - 1}};
    for (std::size_t b = 0; b < sizes.size(); ++b)
      m.A.block(first[b], first[b], sizes[b], sizes[b]) = positive(sizes[b], 1);
    m.K.topLeftCorner(sizes[0], sizes[0]) = positive(sizes[0], 1000);
    for (const auto& [i, j] : edges) {
      const auto a = to_size(i), b = to_size(j);
      const Eigen::Index together = sizes[a] + sizes[b];
      std::vector<Eigen::Index> rows;
      for (Eigen::Index k = 0; k < sizes[a]; ++k) rows.push_back(first[a] + k);
      for (Eigen::Index k = 0; k < sizes[b]; ++k) rows.push_back(first[b] + k);
      m.K(rows, rows) += positive(together, 1000);
      m.B(rows, rows) += positive(together, 60 * damping);
    }
    return m;
  }

  /// A load on `loaded` of n coordinates.
  Eigen::VectorXcd load(Eigen::Index n, Eigen::Index loaded) {
    Eigen::VectorXcd h = Eigen::VectorXcd::Zero(n);
    for (Eigen::Index i = 0; i < loaded; ++i) h((i * 7) % n) = {normal_(generator_), normal_(generator_)};
    return h;
  }

  /// Complex numbers near 1 in size.
  Eigen::ArrayXXcd numbers(Eigen::Index rows, Eigen::Index columns) {
    Eigen::ArrayXXcd x(rows, columns);
    for (std::complex<double>& entry : x.reshaped()) {
      entry.real(normal_(generator_));
      entry.imag(normal_(generator_));
    }
    return x;
  }

  /// A positive definite matrix with entries near `size`.
  Eigen::MatrixXd positive(Eigen::Index n, double size) {
    Eigen::MatrixXd x(n, n);
    for (double& entry : x.reshaped()) entry = normal_(generator_);
    return size * (x * x.transpose() / static_cast<double>(n) + 0.3 * Eigen::MatrixXd::Identity(n, n));
  }

 private:
  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
};

/// Bodies one after the other.
inline Edges chain_edges(Eigen::Index bodies) {
  Edges edges;
  for (Eigen::Index i = 0; i + 1 < bodies; ++i) edges.emplace_back(i, i + 1);
  return edges;
}

/// The same, closed.
inline Edges ring_edges(Eigen::Index bodies) {
  Edges edges = chain_edges(bodies);
  edges.emplace_back(0, bodies - 1);
  return edges;
}

/// Three branches at every body.
inline Edges tree_edges(Eigen::Index bodies) {
  Edges edges;
  for (Eigen::Index i = 1; i < bodies; ++i) edges.emplace_back((i - 1) / 3, i);
  return edges;
}

/// Every body with every other.
inline Edges full_edges(Eigen::Index bodies) {
  Edges edges;
  for (Eigen::Index i = 0; i < bodies; ++i)
    for (Eigen::Index j = 0; j < i; ++j) edges.emplace_back(j, i);
  return edges;
}

}  // namespace trivet::test
