// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine/condensed_machine.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// One column per deflection of unit length, over the coordinates of unit mass and those of the ground; zero if it does
/// not move, but for round-off of the largest of its kind.
struct Directions {
  MatrixXd columns;
  VectorXd lengths;
};

Directions directions_of(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                         bool ground_moves) {
  constexpr double round_off = 1e-13;
  const Index ground = ground_moves && !deflections.empty() ? deflections.front().on_ground.size() : 0;
  // Without the inner coordinates that represent elements that depend on frequency.
  const VectorXd scale =
      numerics::unit_scale(assembled.frequency_dependent() ? assembled.constant : assembled.matrices);
  const Index coordinates = scale.size();
  Directions found{MatrixXd(coordinates + ground, to_index(deflections.size())),
                   VectorXd(to_index(deflections.size()))};
  std::array<double, 2> longest = {0, 0};  // translations, rotations
  for (Index j = 0; j < found.lengths.size(); ++j) {
    const Deflection& one = deflections[j];
    found.columns.col(j) << scale.cwiseProduct(one.on_coordinates.head(coordinates)), one.on_ground.head(ground);
    found.lengths(j) = found.columns.col(j).norm();
    longest[one.is_rotation] = std::max(longest[one.is_rotation], found.lengths(j));
  }
  for (Index j = 0; j < found.lengths.size(); ++j) {
    if (!(found.lengths(j) > round_off * longest[deflections[j].is_rotation])) found.lengths(j) = 0;
    if (found.lengths(j) > 0) found.columns.col(j) /= found.lengths(j);
    else found.columns.col(j).setZero();
  }
  return found;
}

}  // namespace

Index DeflectionBasis::place(Index deflection) const {
  const auto found = std::ranges::lower_bound(independent, deflection);
  assert(found != independent.end() && *found == deflection);
  return found - independent.begin();
}

/// Gram–Schmidt with the longest rest as the next pivot; the first of those that are almost as long.
DeflectionBasis deflection_basis(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                                 bool ground_moves) {
  constexpr double dependent = 1e-10, as_long = 0.9, round_off = 1e-13;
  const auto [columns, lengths] = directions_of(assembled, deflections, ground_moves);
  MatrixXd rest = columns, orthonormal(columns.rows(), 0);
  std::vector<Index> pivots;
  for (;;) {
    const VectorXd left = rest.colwise().norm();
    const double longest = left.size() > 0 ? left.maxCoeff() : 0;
    if (!(longest > dependent)) break;
    Index next = 0;
    while (left(next) < as_long * longest) ++next;
    for (Index j = 0; pivots.empty() && j < left.size(); ++j)
      if (deflections[j].is_followed && left(j) > 0) next = j;
    VectorXd direction = rest.col(next);
    direction -= orthonormal * (orthonormal.transpose() * direction);  // once more, against round-off
    direction.normalize();
    pivots.push_back(next);
    orthonormal.conservativeResize(Eigen::NoChange, orthonormal.cols() + 1);
    orthonormal.rightCols<1>() = direction;
    rest -= direction * (direction.transpose() * rest);
    rest.col(next).setZero();
  }
  [[maybe_unused]] constexpr double of_second_projection = 1e-9;
  assert((orthonormal.transpose() * orthonormal).isIdentity(of_second_projection));
  std::ranges::sort(pivots);
  DeflectionBasis found{pivots, MatrixXd::Zero(to_index(pivots.size()), columns.cols())};
  assert(std::ranges::adjacent_find(pivots) == pivots.end() && "a deflection is a pivot once");
  if (pivots.empty()) return found;
  const MatrixXd along = orthonormal.transpose() * columns,
                 shares = numerics::PivotedLu<double>(MatrixXd(along(Eigen::all, pivots))).solve(along);
  for (Index j = 0; j < columns.cols(); ++j)
    for (Index b = 0; b < found.size(); ++b)
      if (lengths(j) > 0 && std::abs(shares(b, j)) > round_off)
        found.spread(b, j) = shares(b, j) * lengths(j) / lengths(pivots[b]);
  for (Index b = 0; b < found.size(); ++b) found.spread.col(pivots[b]) = VectorXd::Unit(found.size(), b);
  return found;
}

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

namespace {

/// The deflections, over the motion of the ground by each term of the loadings instead of that of its coordinates: feet
/// on one base move as the base does, whatever the number of ground coordinates.
std::vector<Deflection> over_ground_terms(std::vector<Deflection> deflections, const PeriodicExcitation& excitation) {
  const std::vector<Deflection> given = deflections;
  for (Deflection& one : deflections) one.on_ground.resize(0);
  for (const assembly::Loading& loading : excitation.loadings)
    for (const numerics::LoadTerm& term : loading.motion.terms()) {
      VectorXcd moved(to_index(given.size()));
      for (Index j = 0; j < moved.size(); ++j)
        moved(j) = (given[j].on_ground.transpose().cast<std::complex<double>>() * term.value)(0);
      const double largest = moved.size() > 0 ? moved.cwiseAbs().maxCoeff() : 0;
      if (!(largest > 0)) continue;
      for (Index j = 0; j < moved.size(); ++j) {
        Eigen::VectorXd& parts = deflections[j].on_ground;
        parts.conservativeResize(parts.size() + 2);
        parts.tail<2>() << moved(j).real() / largest, moved(j).imag() / largest;
      }
    }
  return deflections;
}

}  // namespace

CondensedMachine::CondensedMachine(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                                   const PeriodicExcitation& excitation)
    : basis_(deflection_basis(assembled, over_ground_terms(deflections, excitation), true)),
      excited_(excitation.harmonics) {
  for (const assembly::ElementMap& map : assembled.elements)
    if (map.defined_from > 0)
      throw foundation::NotComputable(
          "the mean of nonlinear motions needs static stiffnesses, and the table of an element starts above 0 Hz; add "
          "a "
          "row at 0 Hz");
  std::vector<Deflection> independent;
  MatrixXd rows(assembled.matrices.size(), basis_.size());
  for (const Index j : basis_.independent) {
    rows.col(to_index(independent.size())) = deflections[j].on_coordinates;
    independent.push_back(deflections[j]);
  }
  const numerics::PivotedLu<double> stiffness(assembled.matrices.K);
  machine_ = assembled.frequency_dependent() ? machine_over_frequency(assembled, independent, excitation.loadings)
                                             : machine_of_poles(assembled, independent, excitation.loadings);
  all_receptance_ = stiffness.solve(rows);
  static_receptance_ = rows.transpose() * all_receptance_;
}

MatrixXcd CondensedMachine::coordinates(const MatrixXd& of_all, double omega, double factor) const {
  const MatrixXd forces = of_all * basis_.spread.transpose();
  const Index harmonics = (forces.rows() - 1) / 2;
  MatrixXcd all(all_receptance_.rows(), harmonics + 1);
  all.col(0) = (-(all_receptance_ * forces.row(0).transpose())).cast<std::complex<double>>();
  std::size_t next = 0;
  for (Index k = 1; k <= harmonics; ++k) {
    VectorXcd force(forces.cols());
    for (Index j = 0; j < forces.cols(); ++j) force(j) = {forces(2 * k - 1, j), -forces(2 * k, j)};
    const bool is_excited = next < excited_.size() && excited_[next] == k;
    all.col(k) = machine_->coordinates(static_cast<double>(k) * omega, force, is_excited ? &next : nullptr, factor);
    if (is_excited) ++next;
  }
  return all;
}

}  // namespace trivet::nonlinear
