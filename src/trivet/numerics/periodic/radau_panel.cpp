// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/radau_panel.h"

#include <array>
#include <cmath>

#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::numerics {
namespace {

using LegendreValues = std::array<double, RadauPanel::nodes + 2>;

/// Legendre polynomials P_0, P_1, … at x.
LegendreValues legendre_values(double x) {
  LegendreValues P{1, x};
  for (std::size_t k = 1; k + 1 < P.size(); ++k) {
    const auto n = static_cast<double>(k);
    P[k + 1] = ((2 * n + 1) * x * P[k] - n * P[k - 1]) / (n + 1);
  }
  return P;
}

/// Zeros of P_n − P_{n−1} for n nodes, of which 1 is the largest: by bisection between places closer than they are.
RadauPanel::Vector radau_zeros() {
  const auto at = [](double x) {
    const auto P = legendre_values(x);
    return P[RadauPanel::nodes] - P[RadauPanel::nodes - 1];
  };
  RadauPanel::Vector found;
  found(RadauPanel::nodes - 1) = 1;
  int next = 0;
  constexpr int pieces = 400, halvings = 60;
  for (int i = 0; i < pieces && next < RadauPanel::nodes - 1; ++i) {
    double low = -1 + 2.0 * i / pieces, high = -1 + 2.0 * (i + 1) / pieces;
    if (at(low) * at(high) > 0) continue;
    for (int b = 0; b < halvings; ++b) {
      const double middle = (low + high) / 2;
      (at(low) * at(middle) > 0 ? low : high) = middle;
    }
    found(next++) = (low + high) / 2;
  }
  return found;
}

/// In Legendre polynomials, whose integrals from −1 to x are (P_{k+1} − P_{k−1})/(2k + 1).
RadauPanel collocation() {
  const RadauPanel::Vector zeros = radau_zeros();
  RadauPanel::Matrix values, integrals;
  for (int i = 0; i < RadauPanel::nodes; ++i) {
    const auto P = legendre_values(zeros(i));
    for (int k = 0; k < RadauPanel::nodes; ++k) {
      const auto at = static_cast<std::size_t>(k);
      values(i, k) = P[at];
      integrals(i, k) = k == 0 ? zeros(i) + 1 : (P[at + 1] - P[at - 1]) / (2 * k + 1);
    }
  }
  RadauPanel panel;
  panel.places = (zeros.array() + 1) / 2;
  // In values at the nodes: times the inverse of those of the polynomials.
  panel.integrals = PivotedLu<double>(values.transpose()).solve(Eigen::MatrixXd(integrals.transpose() / 2)).transpose();
  panel.weights = panel.integrals.row(RadauPanel::nodes - 1).transpose();
  return panel;
}

}  // namespace

const RadauPanel& radau_panel() {
  static const RadauPanel panel = collocation();
  return panel;
}

Eigen::Matrix<double, 1, RadauPanel::nodes + 1> RadauPanel::interpolation(double place) const {
  Eigen::Matrix<double, 1, nodes + 1> at, row;
  at << 0, places.transpose();
  for (int i = 0; i <= nodes; ++i) {
    row(i) = 1;
    for (int k = 0; k <= nodes; ++k)
      if (k != i) row(i) *= (place - at(k)) / (at(i) - at(k));
  }
  return row;
}

DecayingPanel::DecayingPanel(double length, const RadauPanel::Vector& decay) {
  const RadauPanel& panel = radau_panel();
  const RadauPanel::Matrix integrals = length * panel.integrals;
  const PivotedLu<double> factors(RadauPanel::Matrix::Identity() + integrals * decay.asDiagonal());
  of_start = factors.solve(Eigen::VectorXd(RadauPanel::Vector::Ones()));
  of_source = factors.solve(Eigen::MatrixXd(integrals));
}

}  // namespace trivet::numerics
