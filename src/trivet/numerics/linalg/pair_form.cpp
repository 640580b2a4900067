// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/pair_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/up_to_twelve.h"

namespace trivet::numerics {
namespace {

using States = std::vector<Eigen::Index>;

/// Sums over pairs lose at most three digits.
constexpr double largest_projector = 1e3;
/// Couplings below this share of the largest rate on the diagonal are round-off of the transformation to modes.
constexpr double coupling_round_off = 16 * std::numeric_limits<double>::epsilon();
/// Residual of eigenvectors from which one improvement leads to round-off, and largest residual that is round-off.
constexpr double improvable = 1e-7, residual_round_off = 1e-13;

/// States that act on each other, directly or through others; each list ascends.
std::vector<States> coupled_states(const Eigen::MatrixXd& F) {
  const Eigen::Index n = F.rows();
  const double none = n > 0 ? coupling_round_off * F.diagonal().cwiseAbs().maxCoeff() : 0;
  std::vector<States> all;
  std::vector<bool> known(to_size(n), false);
  for (Eigen::Index first = 0; first < n; ++first) {
    if (known[first]) continue;
    known[first] = true;
    States states = {first};
    for (std::size_t next = 0; next < states.size(); ++next)
      for (Eigen::Index j = 0; j < n; ++j) {
        const Eigen::Index i = states[next];
        if (known[j] || (std::abs(F(i, j)) <= none && std::abs(F(j, i)) <= none)) continue;
        known[j] = true;
        states.push_back(j);
      }
    std::ranges::sort(states);
    all.push_back(std::move(states));
  }
  return all;
}

/// Basis of some coupled states: F X = X D, with pairs in adjacent columns and a single state last.
struct CoupledBasis {
  Eigen::MatrixXd X, Y, D;
};

/// First columns of the pairs; the last one may be a single state.
Eigen::Index width(Eigen::Index first, Eigen::Index n) { return std::min<Eigen::Index>(2, n - first); }

/// Real and imaginary parts of the vectors of conjugate pairs, then real vectors in the order of their poles; each two
/// are made orthonormal.
Eigen::MatrixXd paired_vectors(const GeneralEigen& eigen) {
  const Eigen::Index n = eigen.values.size();
  Eigen::MatrixXd X(n, n);
  Eigen::Index column = 0;
  States real;
  for (Eigen::Index k = 0; k < n; ++k) {
    if (eigen.values(k).imag() == 0) real.push_back(k);
    if (!(eigen.values(k).imag() > 0) || column + 2 > n) continue;
    X.col(column++) = eigen.vectors.col(k).real();
    X.col(column++) = eigen.vectors.col(k).imag();
  }
  std::ranges::sort(real,
                    [&](Eigen::Index a, Eigen::Index b) { return eigen.values(a).real() < eigen.values(b).real(); });
  if (column + to_index(real.size()) != n) return {};
  for (const Eigen::Index k : real) X.col(column++) = eigen.vectors.col(k).real();
  for (Eigen::Index first = 0; first < n; first += 2) {
    X.col(first).normalize();
    if (first + 1 == n) break;
    for (int twice = 0; twice < 2; ++twice) X.col(first + 1) -= X.col(first).dot(X.col(first + 1)) * X.col(first);
    X.col(first + 1).normalize();
  }
  return X;
}

Eigen::MatrixXd only_pairs(const Eigen::MatrixXd& D) {
  Eigen::MatrixXd pairs = Eigen::MatrixXd::Zero(D.rows(), D.cols());
  for (Eigen::Index i = 0; i < D.rows(); i += 2) {
    const Eigen::Index w = width(i, D.rows());
    pairs.block(i, i, w, w) = D.block(i, i, w, w);
  }
  return pairs;
}

/// S of D_i S − S D_j = −E, by the equations of its entries.
Eigen::MatrixXd sylvester(const Eigen::MatrixXd& Di, const Eigen::MatrixXd& Dj, const Eigen::MatrixXd& E) {
  const Eigen::Index rows = Di.rows(), columns = Dj.rows();
  assert(rows <= 2 && columns <= 2 && E.rows() == rows && E.cols() == columns && "blocks are pairs or single states");
  UpToTwelve<double> equations = UpToTwelve<double>::Zero(rows * columns, rows * columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    equations.block(c * rows, c * rows, rows, rows) += Di;
    for (Eigen::Index d = 0; d < columns; ++d)
      equations.block(c * rows, d * rows, rows, rows).diagonal().array() -= Dj(d, c);
  }
  const UpToTwelve<double> right = -E.reshaped();
  return lu_solution(equations, right).reshaped(rows, columns);
}

/// F X − X D in extended precision. Most entries of F are zero, so its products are added one by one.
Eigen::MatrixXd residual(const Eigen::MatrixXd& F, const CoupledBasis& basis) {
  using ExtendedRows = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Index n = F.rows();
  const ExtendedRows X = basis.X.cast<long double>();
  ExtendedRows missed = ExtendedRows::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k)
      if (F(i, k) != 0) missed.row(i) += static_cast<long double>(F(i, k)) * X.row(k);
  for (Eigen::Index j = 0; j < n; j += 2) {
    const Eigen::Index w = width(j, n);
    const ExtendedRows D = basis.D.block(j, j, w, w).cast<long double>();
    missed.middleCols(j, w) -= X.middleCols(j, w).lazyProduct(D);
  }
  return missed.cast<double>();
}

/// One step of Newton's method on F X = X D.
/// @return false if the pairs are not separated well enough
bool improve(const Eigen::MatrixXd& F, CoupledBasis& basis) {
  const Eigen::Index n = F.rows();
  const double scale = F.cwiseAbs().maxCoeff();
  const Eigen::MatrixXd E = basis.Y * residual(F, basis);
  if (!(E.cwiseAbs().maxCoeff() <= improvable * scale)) return false;
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; j += 2)
    for (Eigen::Index i = 0; i < n; i += 2) {
      if (i == j) continue;
      const Eigen::Index h = width(i, n), w = width(j, n);
      const Eigen::MatrixXd e = E.block(i, j, h, w);
      const Eigen::MatrixXd s = sylvester(basis.D.block(i, i, h, h), basis.D.block(j, j, w, w), e);
      // Poles that coincide to round-off: the vectors remain, with their residual.
      const bool separate = s.allFinite() && s.cwiseAbs().maxCoeff() <= std::sqrt(improvable);
      if (separate) S.block(i, j, h, w) = s;
      else if (e.cwiseAbs().maxCoeff() > residual_round_off * scale) return false;
    }
  basis.D += only_pairs(E);
  basis.X += (basis.X * S).eval();
  basis.Y -= (S * basis.Y).eval();
  return true;
}

/// True if the states take this basis of pairs.
bool separate(const Eigen::MatrixXd& F, CoupledBasis& basis) {
  const GeneralEigen eigen = general_eigen(F);
  if (!eigen.converged) return false;
  basis.X = paired_vectors(eigen);
  if (basis.X.size() == 0 || !basis.X.allFinite()) return false;
  const PivotedLu<double> lu(basis.X);
  basis.Y = lu.solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(F.rows(), F.cols())));
  if (!basis.Y.allFinite() || !(basis.Y.rowwise().norm().maxCoeff() <= largest_projector)) return false;
  basis.D = only_pairs(basis.Y * (F * basis.X));
  return improve(F, basis);
}

/// Where the states of each group are in the result.
class Places {
 public:
  Places(const Eigen::MatrixXd& F, const StateGroups& groups, PairForm& form) : F_(F), form_(form) {
    form.groups = groups;
    const Eigen::Index size =
        2 * groups.pairs + std::accumulate(groups.dense.begin(), groups.dense.end(), Eigen::Index{0});
    form.D = Eigen::MatrixXd::Zero(size, size);
    form.X = Eigen::MatrixXd::Zero(F.rows(), size);
    form.Y = Eigen::MatrixXd::Zero(size, F.rows());
    dense_ = 2 * groups.pairs;
  }
  /// Columns from `first` of a basis of these states.
  void add_pair(const States& states, const CoupledBasis& basis, Eigen::Index first) {
    const Eigen::Index columns = width(first, basis.X.cols());
    assert(basis.X.rows() == to_index(states.size()) && pair_ < form_.groups.pairs);
    const States at = columns == 2 ? States{pair_, form_.groups.pairs + pair_} : States{next_single()};
    if (columns == 2) ++pair_;
    form_.D(at, at) = basis.D.block(first, first, columns, columns);
    form_.X(states, at) = basis.X.middleCols(first, columns);
    form_.Y(at, states) = basis.Y.middleRows(first, columns);
  }
  void add_dense(const States& states) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Eigen::Index at = dense_ + to_index(i);
      form_.X(states[i], at) = form_.Y(at, states[i]) = 1;
    }
    const auto n = to_index(states.size());
    form_.D.block(dense_, dense_, n, n) = F_(states, states);
    dense_ += n;
  }

 private:
  /// Two single states share a pair, beginning with the last one.
  Eigen::Index next_single() {
    const Eigen::Index pair = form_.groups.pairs - 1 - single_ / 2;
    return single_++ % 2 == 0 ? pair : form_.groups.pairs + pair;
  }
  const Eigen::MatrixXd& F_;
  PairForm& form_;
  Eigen::Index pair_ = 0, single_ = 0, dense_ = 0;
};

}  // namespace

PairForm pair_form(const Eigen::MatrixXd& F, Eigen::Index multiple) {
  const std::vector<States> coupled = coupled_states(F);
  std::vector<CoupledBasis> bases(coupled.size());
  StateGroups groups;
  Eigen::Index singles = 0;
  for (std::size_t k = 0; k < coupled.size(); ++k) {
    const States& states = coupled[k];
    const auto n = to_index(states.size());
    CoupledBasis& basis = bases[k];
    const Eigen::MatrixXd own = F(states, states);
    if (n <= 2) {
      basis.X = basis.Y = Eigen::MatrixXd::Identity(n, n);
      basis.D = own;
    } else if (!separate(own, basis)) {
      basis.X.resize(0, 0);
      groups.dense.push_back(n);
      continue;
    }
    groups.pairs += n / 2;
    singles += n % 2;
  }
  groups.pairs += (singles + 1) / 2;
  groups.pairs = (groups.pairs + multiple - 1) / multiple * multiple;
  PairForm form;
  Places places(F, groups, form);
  for (std::size_t k = 0; k < coupled.size(); ++k) {
    if (bases[k].X.size() == 0) places.add_dense(coupled[k]);
    for (Eigen::Index first = 0; first < bases[k].X.cols(); first += 2) places.add_pair(coupled[k], bases[k], first);
  }
  assert(form.groups.pairs % multiple == 0 && "pairs fill whole packs");
  assert((form.X.cwiseAbs().rowwise().sum().array() > 0).all() && "every state of F is in one group");
  return form;
}

}  // namespace trivet::numerics
