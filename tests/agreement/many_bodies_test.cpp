// SPDX-License-Identifier: BSD-3-Clause
// Sparse factors, roots and exact peaks of many bodies in graphs of every shape, against dense extended
// solutions, traces of matrices, and scans around every pole.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/coupled_bodies.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/linalg/sparse_system.h"
#include "trivet/numerics/peaks/disc_search.h"
#include "trivet/numerics/peaks/peak_refinement.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace many_bodies_test {

using namespace trivet;
using numerics::DynamicMatrices, numerics::SparseSystem;
using test::CoupledBodies, test::Edges, test::Sizes;
using Extended = long double;

constexpr double extended_digits = 1e-16;  // residuals in extended precision leave the last digit of double
constexpr double sweep_round_off = 1e-10;  // lower maxima of a scan may be round-off
constexpr double nine_digits = 1e-9;       // promised for heights of peaks
constexpr double state_digits = 1e-12;     // backward error of an eigenproblem of some hundred states
constexpr double root_digits = 1e-12;      // sums over all roots, some far larger than the others

struct Graph {
  std::string name;
  Edges edges;
  Eigen::Index bodies;
};

std::vector<Graph> graphs(Eigen::Index bodies) {
  return {{"chain", test::chain_edges(bodies), bodies},
          {"ring", test::ring_edges(bodies), bodies},
          {"tree", test::tree_edges(bodies), bodies},
          {"full", test::full_edges(bodies), bodies}};
}

DynamicMatrices system_of(const Graph& graph, unsigned seed, double damping) {
  return CoupledBodies(seed).bodies(Sizes(to_size(graph.bodies), 6), graph.edges, damping);
}

numerics::ExtendedMatrix extended(const DynamicMatrices& m, double omega) {
  const std::complex<Extended> iw(0, omega);
  return m.complex_stiffness().cast<std::complex<Extended>>() + iw * m.B.cast<std::complex<Extended>>() +
      iw * iw * m.A.cast<std::complex<Extended>>();
}

TEST(SparseSystem, SolvesLikeExtendedPrecisionForEveryGraph) {
  for (const Eigen::Index bodies : {2, 7, 12})
    for (const Graph& graph : graphs(bodies)) {
      DynamicMatrices m = system_of(graph, 3, 0.02);
      for (const bool symmetric : {true, false}) {
        m.symmetric = symmetric;
        if (!symmetric) m.K(1, 4) += 0.3 * m.K(1, 1);
        const SparseSystem system(m);
        const double omega = 17.0;
        const Eigen::VectorXcd load = CoupledBodies(5).load(m.size(), m.size());
        const numerics::ExtendedVector h = load.cast<std::complex<Extended>>();
        for (const bool transposed : {false, true}) {
          numerics::ExtendedMatrix z = extended(m, omega);
          if (transposed) z = z.transpose().eval();
          const numerics::ExtendedVector truth = numerics::lu_solution(z, h);
          const auto found = system.solution(system.factors(omega, transposed), omega, h, transposed);
          EXPECT_LE(static_cast<double>((found - truth).norm() / truth.norm()), extended_digits)
              << graph.name << " of " << bodies << (transposed ? ", transposed" : "");
          const numerics::ExtendedVector product = system.product<Extended>(0, omega, truth, transposed);
          EXPECT_LE(static_cast<double>((product - h).norm() / h.norm()), extended_digits);
        }
      }
    }
}

/// Angles between rigid links, the first one clamped, for displacements of their ends: second differences.
Eigen::MatrixXd cantilever_differences(Eigen::Index n) {
  Eigen::MatrixXd bending = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    bending(i, i) = 1;
    if (i > 0) bending(i, i - 1) = -2;
    if (i > 1) bending(i, i - 2) = 1;
  }
  return bending;
}

/// A cantilever of such links with rotational springs between them: condition near 3 n⁴.
DynamicMatrices cantilever(Eigen::Index n) {
  const Eigen::MatrixXd bending = cantilever_differences(n);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  return {none, none, bending.transpose() * bending / 3.0, {}, true};
}

TEST(SparseSystem, SolvesIllConditionedChainsWithoutFactorsInExtendedPrecision) {
  const Eigen::Index n = 300;
  const DynamicMatrices m = cantilever(n);
  const SparseSystem system(m);
  const numerics::ExtendedMatrix z = m.K.cast<std::complex<Extended>>();
  const numerics::ExtendedVector b = CoupledBodies(6).load(n, n).cast<std::complex<Extended>>();
  using Terms = Eigen::Matrix<Extended, Eigen::Dynamic, 1>;
  const numerics::ExtendedProducts products{
      [&](const numerics::ExtendedVector& x) -> numerics::ExtendedVector { return b - z * x; },
      [&](const numerics::ExtendedVector& x) -> Terms { return z.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs(); }};
  const auto found = numerics::refined_solution(system.factors(0), b, products);
  ASSERT_TRUE(found);
  const numerics::ExtendedVector by_factors = numerics::lu_solution(z, b);
  const auto backward_error = [&](const numerics::ExtendedVector& x) {
    return static_cast<double>((products.residual(x).cwiseAbs().array() / products.terms(x).array()).maxCoeff());
  };
  EXPECT_LE(backward_error(*found), std::max(backward_error(by_factors), extended_digits));
  const double condition = 3.0 * std::pow(static_cast<double>(n), 4);
  EXPECT_LE(static_cast<double>((*found - by_factors).norm() / by_factors.norm()), extended_digits * condition);
  const numerics::ExtendedVector by_entries = system.solution(system.factors(0), 0, b);
  EXPECT_LE(static_cast<double>((*found - by_entries).norm() / by_entries.norm()), extended_digits * condition);
}

TEST(LowestModes, AgreeWithTheDenseEigensolverForEveryGraph) {
  constexpr double of_largest = 1e-12;  // of the dense eigenvalues, whose error is round-off of the largest
  constexpr double orthogonal = 1e-10;  // shapes settle to 1e-11
  for (const Eigen::Index bodies : {40, 60})
    for (const Graph& graph : graphs(bodies)) {
      const DynamicMatrices m = system_of(graph, 5, 0.02);
      const auto found = numerics::lowest_modes(m.K, m.A, 7);
      EXPECT_EQ(found.has_value(), graph.name != "full") << graph.name;
      if (!found) continue;
      const numerics::GeneralizedModes all = numerics::generalized_modes(m.K, m.A, true);
      const double largest = all.lambda(all.lambda.size() - 1);
      EXPECT_LE((found->lambda - all.lambda.head(7)).cwiseAbs().maxCoeff(), of_largest * largest) << graph.name;
      const Eigen::MatrixXd rest = m.K * found->shapes - m.A * found->shapes * found->lambda.asDiagonal();
      EXPECT_LE(rest.cwiseAbs().maxCoeff(), of_largest * largest) << graph.name;
      EXPECT_TRUE((found->shapes.transpose() * m.A * found->shapes).isIdentity(orthogonal)) << graph.name;
    }
}

TEST(LowestModes, TellRigidBodyModesFromSlowBending) {
  // A free beam of 200 links: two motions without stiffness, then bending with λ 1e-9 of the largest.
  constexpr double of_beam = 0.02;
  const Eigen::Index n = 200;
  const Eigen::MatrixXd bending = cantilever_differences(n).bottomRows(n - 2);
  const auto found = numerics::lowest_modes(bending.transpose() * bending, Eigen::MatrixXd::Identity(n, n), 4);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->lambda(0), 0);
  EXPECT_EQ(found->lambda(1), 0);
  const double roots[] = {4.730041, 7.853205};  // of cos β cosh β = 1
  for (Eigen::Index j = 0; j < 2; ++j)
    EXPECT_NEAR(found->lambda(j + 2) / std::pow(roots[j] / static_cast<double>(n), 4), 1, of_beam);
}

TEST(LowestModes, FindEveryOneOfEqualFrequencies) {
  // Three equal chains beside each other: every frequency three times.
  constexpr double of_closed_form = 1e-12;
  const Eigen::Index length = 100, n = 3 * length;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    stiffness(i, i) = 2;
    if (i % length > 0) stiffness(i, i - 1) = stiffness(i - 1, i) = -1;
  }
  const auto found = numerics::lowest_modes(stiffness, Eigen::MatrixXd::Identity(n, n), 10);
  ASSERT_TRUE(found);
  for (Eigen::Index j = 0; j < 10; ++j) {
    const double half =
        std::sin(std::numbers::pi * static_cast<double>(j / 3 + 1) / (2.0 * static_cast<double>(length + 1)));
    EXPECT_NEAR(found->lambda(j) / (4 * half * half), 1, of_closed_form) << j;
  }
}

TEST(LowestModes, AreLeftToTheDenseSolverIfTheMassIsIndefinite) {
  const Eigen::MatrixXd stiffness = cantilever(60).K;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(60, 60);
  mass(30, 30) = -1;
  EXPECT_FALSE(numerics::lowest_modes(stiffness, mass, 4));
  EXPECT_FALSE(numerics::lowest_modes(-stiffness, Eigen::MatrixXd::Identity(60, 60), 4));
}

TEST(SparseSystem, DerivativesAreDifferencesOfTheStiffness) {
  const DynamicMatrices m = system_of(graphs(6)[0], 1, 0.05);
  const SparseSystem system(m);
  const numerics::ExtendedVector x = CoupledBodies(2).load(m.size(), 9).cast<std::complex<Extended>>();
  constexpr Extended omega = 11, step = 1e-3L;
  const auto at = [&](Extended w) { return system.product<Extended>(0, w, x); };
  const numerics::ExtendedVector slope = (at(omega + step) - at(omega - step)) / (2 * step),
                                 curvature =
                                     (at(omega + step) - Extended(2) * at(omega) + at(omega - step)) / (step * step);
  constexpr double of_differences = 1e-9;  // Z is of second degree in ω: round-off over the squared step alone
  EXPECT_LE(static_cast<double>((system.product<Extended>(1, omega, x) - slope).norm() / slope.norm()), of_differences);
  EXPECT_LE(static_cast<double>((system.product<Extended>(2, omega, x) - curvature).norm() / curvature.norm()),
            of_differences);
}

/// Σ λ = −tr(A⁻¹B), and every root solves its equation.
TEST(RootsOfManyBodies, HaveTheSumOfTheTraceAndSmallResiduals) {
  for (const Eigen::Index bodies : {2, 6, 10, 14})
    for (const Graph& graph : graphs(bodies)) {
      const DynamicMatrices m = system_of(graph, 9, 0.05);
      const numerics::QuadraticRoots roots = numerics::system_roots(m).roots;
      ASSERT_EQ(roots.lambda.size(), 2 * m.size());
      const double trace = numerics::lu_solution(m.A, m.B).trace();
      EXPECT_NEAR(roots.lambda.sum().real(), -trace, root_digits * roots.lambda.cwiseAbs().sum()) << graph.name;
      EXPECT_NEAR(roots.lambda.sum().imag(), 0, root_digits * roots.lambda.cwiseAbs().sum()) << graph.name;
      for (Eigen::Index k = 0; k < roots.lambda.size(); ++k) {
        const numerics::Complex l = roots.lambda(k);
        const Eigen::VectorXcd v = roots.vectors.col(k);
        const Eigen::VectorXcd residual = l * l * (m.A * v) + l * (m.B * v) + m.K * v;
        const double terms = (std::norm(l) * m.A.norm() + std::abs(l) * m.B.norm() + m.K.norm()) * v.norm();
        EXPECT_LE(residual.norm(), state_digits * terms) << graph.name << " of " << bodies << ", root " << k;
      }
    }
}

/// Frequencies over the band and close to every pole.
std::vector<double> scan(const Eigen::VectorXcd& poles, double to) {
  constexpr int spread = 4000, around = 41;
  constexpr double apart = 1e-9, half_widths = 8;
  std::vector<double> omega;
  for (int i = 1; i <= spread; ++i) omega.push_back(to * i / spread);
  for (const numerics::Complex& pole : poles)
    for (int i = 0; i < around; ++i)
      if (const double w = pole.imag() + half_widths * std::abs(pole.real()) * (2.0 * i / (around - 1) - 1);
          w > 0 && w < to)
        omega.push_back(w);
  std::ranges::sort(omega);
  omega.erase(std::ranges::unique(omega, [](double a, double b) { return b - a < apart * b; }).begin(), omega.end());
  return omega;
}

TEST(PeaksOfManyBodies, AreAllThatAScanAroundEveryPoleFinds) {
  int seen = 0;
  for (const double damping : {0.3, 0.01})
    for (const Graph& graph : graphs(14)) {
      const DynamicMatrices m = system_of(graph, 4, damping);
      const numerics::Load load(CoupledBodies(6).load(m.size(), 5)), nothing(Eigen::Index{0});
      const Eigen::VectorXcd poles = numerics::poles(numerics::system_roots(m));
      std::vector<numerics::ObservedCurve> curves;
      const std::vector<Eigen::Index> rows = {0, m.size() / 2 + 1, m.size() - 2};
      for (const Eigen::Index row : rows)
        curves.push_back(numerics::observed_curve({Eigen::VectorXd::Unit(m.size(), row), {}, 0}));
      const numerics::DrivenSystem system{m, load, nothing};
      EXPECT_EQ(SparseSystem(m).has_sparse_factors(), graph.name != "full") << graph.name;
      const numerics::AxisSearch found = numerics::search_by_discs(system, curves, poles, {});
      const numerics::PeakRefinement refinement(system);
      const std::vector<double> omega = scan(poles, 1.1 * poles.imag().maxCoeff());
      const Eigen::MatrixXcd q = numerics::sweep(m, load, omega).response;
      for (std::size_t c = 0; c < curves.size(); ++c) {
        const Eigen::VectorXd y = q.row(rows[c]).cwiseAbs().transpose();
        const double size = y.maxCoeff();
        for (Eigen::Index i = 1; i + 1 < y.size(); ++i) {
          if (!(y(i) > y(i - 1) && y(i) > y(i + 1))) continue;
          if (!(y(i) - std::min(y(i - 1), y(i + 1)) > sweep_round_off * size)) continue;
          ++seen;
          const double from = omega[i - 1], to = omega[i + 1];
          const auto& extrema = found.curves[c].extrema;
          const auto peak = std::ranges::find_if(extrema, [&](const numerics::Extremum& e) {
            return e.maximum && e.angular_frequency >= from && e.angular_frequency <= to;
          });
          ASSERT_NE(peak, extrema.end()) << graph.name << ", damping " << damping << ", near " << omega[i];
          const numerics::RefinedPeak refined = refinement.refined(curves[c], peak->angular_frequency, peak->reach);
          EXPECT_TRUE(refined.converged);
          EXPECT_GE(refined.amplitude, y(i) * (1 - nine_digits));
          EXPECT_NEAR(peak->amplitude, refined.amplitude, nine_digits * refined.amplitude);
        }
      }
    }
  EXPECT_GT(seen, 100) << "the test means nothing without peaks";
}

}  // namespace many_bodies_test
