// SPDX-License-Identifier: BSD-3-Clause
// LDLᵀ by blocks in lanes against pivoted LU in extended precision, on graphs of bodies of every shape.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <tuple>
#include <vector>

#include "support/coupled_bodies.h"
#include "support/matchers.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/numerics/sweep/block_sweep.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace block_sweep_test {

using namespace trivet;
using Eigen::Index;
using numerics::DynamicMatrices;
using test::chain_edges, test::full_edges, test::ring_edges, test::tree_edges;
using test::CoupledBodies, test::Edges, test::Sizes;

/// Backward stability allows round-off times the condition, and a little for the sums over many rows.
constexpr double condition_share = 64 * test::epsilon;

std::vector<double> frequencies(Index count, double highest = 80) {
  std::vector<double> omega;
  for (Index i = 0; i < count; ++i)
    omega.push_back(highest * (static_cast<double>(i) + 0.3) / static_cast<double>(count));
  return omega;
}

numerics::ExtendedMatrix extended(const DynamicMatrices& m, double omega) {
  const std::complex<long double> iw(0, omega);
  return m.complex_stiffness().cast<std::complex<long double>>() + iw * m.B.cast<std::complex<long double>>() +
      iw * iw * m.A.cast<std::complex<long double>>();
}

/// True backward error and error of every column.
void expect_solved(const DynamicMatrices& given, const numerics::Load& load, const std::vector<double>& omega,
                   const numerics::SweepResult& found, const std::string& name) {
  const Eigen::VectorXd d = numerics::unit_scale(given);
  const DynamicMatrices m = numerics::scaled(given, d);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const auto column = static_cast<Index>(i);
    const numerics::ExtendedMatrix z = extended(m, omega[i]);
    const numerics::ExtendedVector h = (d.asDiagonal() * load.at(omega[i])).cast<std::complex<long double>>();
    const numerics::ExtendedVector q =
        (d.cwiseInverse().asDiagonal() * found.response.col(column)).cast<std::complex<long double>>();
    const auto norm = z.cwiseAbs().rowwise().sum().maxCoeff();
    const auto backward =
        (z * q - h).cwiseAbs().maxCoeff() / (norm * q.cwiseAbs().maxCoeff() + h.cwiseAbs().maxCoeff());
    EXPECT_LE(static_cast<double>(backward), numerics::accepted_backward_error) << name << " at " << omega[i];
    EXPECT_LE(found.backward_error(column), numerics::accepted_backward_error) << name << " at " << omega[i];
    const numerics::RefinedSolver exact(z);
    const numerics::ExtendedVector truth = exact.solve(h);
    EXPECT_LE(static_cast<double>((q - truth).norm() / truth.norm()),
              condition_share * static_cast<double>(m.size()) * exact.condition())
        << name << " at " << omega[i];
  }
}

/// Writes some columns of a result.
void solve_columns(const numerics::BlockSweep& blocks, const std::vector<double>& omega, std::size_t first,
                   std::size_t last, numerics::SweepResult& result) {
  const auto begin = static_cast<Index>(first), count = static_cast<Index>(last - first), n = result.response.rows();
  Eigen::ArrayXXd re(count, n), im(count, n);
  numerics::LineMemory memory;
  blocks.solve(
      {omega.data() + first, count, {}, {}, {re.data(), im.data(), count}, result.backward_error.data() + first},
      memory);
  result.response.middleCols(begin, count).real() = re.transpose();
  result.response.middleCols(begin, count).imag() = im.transpose();
}

numerics::SweepResult room_for(Index n, const std::vector<double>& omega) {
  numerics::SweepResult result;
  result.response.resize(n, static_cast<Index>(omega.size()));
  result.backward_error.resize(static_cast<Index>(omega.size()));
  return result;
}

numerics::SweepResult by_blocks(const DynamicMatrices& m, const numerics::Load& load,
                                const std::vector<double>& omega) {
  numerics::SweepResult result = room_for(m.size(), omega);
  solve_columns(numerics::BlockSweep(m, load), omega, 0, omega.size(), result);
  return result;
}

TEST(BlockSweep, GraphsOfEveryShapeAgreeWithExtendedPrecision) {
  CoupledBodies random(3);
  const Sizes six(7, 6), mixed = {6, 3, 5, 1, 6, 8, 2, 6, 4};
  const std::vector<std::tuple<std::string, Sizes, Edges>> cases = {{"one body", {6}, {}},
                                                                    {"two", {6, 6}, chain_edges(2)},
                                                                    {"chain", six, chain_edges(7)},
                                                                    {"ring", six, ring_edges(7)},
                                                                    {"tree", Sizes(13, 6), tree_edges(13)},
                                                                    {"full", six, full_edges(7)},
                                                                    {"mixed chain", mixed, chain_edges(9)},
                                                                    {"mixed ring", mixed, ring_edges(9)},
                                                                    {"mixed tree", mixed, tree_edges(9)},
                                                                    {"mixed full", mixed, full_edges(9)},
                                                                    {"planar", Sizes(8, 3), ring_edges(8)},
                                                                    {"not coupled", {6, 6, 6}, chain_edges(2)}};
  for (const auto& [name, sizes, edges] : cases)
    for (const double damping : {0.3, 1e-3}) {
      DynamicMatrices m = random.bodies(sizes, edges, damping);
      for (const Index loaded : {Index(1), m.size()}) {
        const numerics::Load load = random.load(m.size(), loaded);
        const std::vector<double> omega = frequencies(11);
        expect_solved(m, load, omega, by_blocks(m, load, omega), name);
        DynamicMatrices unnamed = m;  // without names, blocks are found from the couplings
        unnamed.blocks.clear();
        expect_solved(m, load, omega, by_blocks(unnamed, load, omega), name + ", blocks found");
      }
    }
}

TEST(BlockSweep, NoCoordinatesHaveNoResponse) {
  const Eigen::MatrixXd none(0, 0);
  const numerics::SweepResult found = by_blocks({none, none, none, {}, true}, numerics::Load(0), {1.0, 2.0});
  EXPECT_EQ(found.response.size(), 0);
  EXPECT_EQ(found.backward_error, Eigen::VectorXd::Zero(2));
}

TEST(BlockSweep, LossFactorsAndLoadsThatVaryWithFrequencyAreFollowed) {
  CoupledBodies random(4);
  DynamicMatrices m = random.bodies(Sizes(4, 6), ring_edges(4), 0.02);
  m.K_loss = 0.1 * m.K;
  numerics::Load load(m.size());
  load.add({0, 0.01, random.load(m.size(), 3)});
  load.add({2, 0, random.load(m.size(), 5)});
  load.add({-1, 0.2, random.load(m.size(), 24)});
  const std::vector<double> omega = frequencies(19);
  expect_solved(m, load, omega, by_blocks(m, load, omega), "varying load");
}

TEST(BlockSweep, CoordinatesWithoutMassAreEliminatedLikeOthers) {
  CoupledBodies random(5);
  const Sizes sizes = {6, 1, 6, 1, 6, 3};
  DynamicMatrices m = random.bodies(sizes, chain_edges(6), 0.1);
  for (const Index row : {6, 13, 20, 21, 22}) {
    m.A.row(row).setZero();
    m.A.col(row).setZero();
  }
  const numerics::Load load = random.load(m.size(), 4);
  const std::vector<double> omega = frequencies(16);
  expect_solved(m, load, omega, by_blocks(m, load, omega), "without mass");
}

TEST(BlockSweep, EntriesAndLoadsGivenForEachFrequencyJoinThePlan) {
  CoupledBodies random(15);
  const DynamicMatrices m = random.bodies({6, 4, 6, 6, 3}, chain_edges(5), 0.1);
  const Index n = m.size();
  // Entries within a body, between coupled bodies, and between two bodies without another coupling.
  const std::vector<numerics::FreeEntry> free = {{0, 0}, {3, 1}, {2, 8}, {24, 4}, {12, 11}, {20, 20}};
  const std::vector<double> omega = frequencies(21);
  const auto count = static_cast<Index>(omega.size()), entries = static_cast<Index>(free.size());
  const Eigen::ArrayXXcd added = 300 * random.numbers(count, entries), load = random.numbers(count, n);
  Eigen::ArrayXXd free_re = added.real(), free_im = added.imag(), load_re = load.real(), load_im = load.imag(),
                  re(count, n), im(count, n);
  Eigen::VectorXd error(count);
  numerics::LineMemory memory;
  numerics::BlockSweep(m, free).solve({omega.data(),
                                       count,
                                       {free_re.data(), free_im.data(), count},
                                       {load_re.data(), load_im.data(), count},
                                       {re.data(), im.data(), count},
                                       error.data()},
                                      memory);
  for (Index f = 0; f < count; ++f) {
    Eigen::MatrixXcd z = m.at(omega[f]);
    for (Index k = 0; k < entries; ++k) {
      const auto [i, j] = free[k];
      z(i, j) += added(f, k);
      if (i != j) z(j, i) += added(f, k);
    }
    const numerics::RefinedSolver exact(z.cast<std::complex<long double>>());
    const Eigen::VectorXcd truth =
        exact.solve(load.row(f).transpose().matrix().cast<std::complex<long double>>()).cast<std::complex<double>>();
    const Eigen::VectorXcd found = re.row(f).transpose().cast<std::complex<double>>() +
        std::complex<double>(0, 1) * im.row(f).transpose().cast<std::complex<double>>();
    EXPECT_LE((found - truth).norm() / truth.norm(), condition_share * static_cast<double>(n) * exact.condition())
        << omega[f];
    EXPECT_LE(error(f), numerics::accepted_backward_error);
  }
}

double worst_difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  double worst = 0;
  for (Index i = 0; i < a.cols(); ++i) worst = std::max(worst, (a.col(i) - b.col(i)).norm() / b.col(i).norm());
  return worst;
}

/// Every body has an undamped leading pivot k − ω²m that vanishes exactly at ω = 10.
DynamicMatrices vanishing_pivots(CoupledBodies& random) {
  DynamicMatrices m = random.bodies(Sizes(4, 6), chain_edges(4), 0.05);
  for (Index body = 0; body < 4; ++body) {
    const Index i = 6 * body;
    m.B.row(i).setZero();
    m.B.col(i).setZero();
    m.K(i, i) = 100 * m.A(i, i);
    for (Index j = 0; j < i; ++j) m.K(i, j) = m.K(j, i) = 0;  // earlier eliminations leave this pivot unchanged
  }
  return m;
}

TEST(BlockSweep, AVanishingPivotIsRejectedAndChangesNoOtherFrequency) {
  CoupledBodies random(6);
  const DynamicMatrices m = vanishing_pivots(random);
  const numerics::Load load = random.load(m.size(), m.size());
  const std::vector<double> with = {3, 10, 20, 30}, without = {3, 20, 30};
  const numerics::SweepResult found = by_blocks(m, load, with), others = by_blocks(m, load, without);
  EXPECT_FALSE(found.backward_error(1) <= numerics::accepted_backward_error);
  EXPECT_EQ(found.response.col(0), others.response.col(0));
  EXPECT_EQ(found.response.rightCols(2), others.response.rightCols(2));
  const numerics::SweepResult mended = numerics::sweep(m, load, with);
  EXPECT_EQ(mended.fallbacks, 1);
  EXPECT_EQ(mended.singular, 0);
  expect_solved(m, load, with, mended, "vanishing pivots");
}

TEST(BlockSweep, PivotsThatNearlyVanishAreRefinedOrReplaced) {
  CoupledBodies random(6);
  const DynamicMatrices m = vanishing_pivots(random);
  const numerics::Load load = random.load(m.size(), m.size());
  std::vector<double> omega;
  for (int decade = 1; decade <= 15; ++decade) omega.push_back(10 * (1 + std::pow(10.0, -decade)));
  expect_solved(m, load, omega, numerics::sweep(m, load, omega), "nearly vanishing pivots");
}

TEST(BlockSweep, ResonancesWithLightDampingKeepTheirBackwardError) {
  CoupledBodies random(8);
  for (const double damping : {1e-3, 1e-6}) {
    const DynamicMatrices m = random.bodies(Sizes(6, 6), tree_edges(6), damping);
    const Eigen::VectorXd squares = numerics::symmetric_eigen(m.K, m.A).values;
    std::vector<double> omega;
    for (const double square : squares)
      for (const double shift : {0.0, 1e-9, -1e-6}) omega.push_back(std::sqrt(square) * (1 + shift));
    const numerics::Load load = random.load(m.size(), 2);
    expect_solved(m, load, omega, numerics::sweep(m, load, omega), "light damping");
  }
}

TEST(BlockSweep, SingularFrequenciesAreNotANumberAndTheRestIsRight) {
  CoupledBodies random(9);
  DynamicMatrices m = random.bodies(Sizes(4, 6), chain_edges(4), 0.02);
  m.K.topRows(6).setZero();  // the first body is free: it has only mass
  m.K.leftCols(6).setZero();
  m.B.topRows(6).setZero();
  m.B.leftCols(6).setZero();
  const numerics::Load load = random.load(m.size(), m.size());
  const std::vector<double> omega = {0.0, 5.0, 9.0};
  const numerics::SweepResult found = numerics::sweep(m, load, omega);
  EXPECT_EQ(found.singular, 1);
  EXPECT_TRUE(found.response.col(0).array().isNaN().all());
  numerics::SweepResult rest = found;
  rest.response = found.response.rightCols(2).eval();
  rest.backward_error = found.backward_error.tail(2).eval();
  expect_solved(m, load, {5.0, 9.0}, rest, "next to a singular frequency");
}

TEST(BlockSweep, AllInstructionSetsAgree) {
  CoupledBodies random(10);
  const DynamicMatrices m = random.bodies({6, 4, 6, 6, 1, 6, 8}, ring_edges(7), 0.05);
  const numerics::Load load = random.load(m.size(), 9);
  const std::vector<double> omega = frequencies(37);
  constexpr double round_off = 1e-11;  // ε times a condition of a few thousand
  const Eigen::MatrixXcd best = by_blocks(m, load, omega).response;
  for (const std::string& name : numerics::instruction_sets()) {
    numerics::use_instruction_set(name);
    const Eigen::MatrixXcd response = by_blocks(m, load, omega).response;
    numerics::use_instruction_set("");
    EXPECT_LE(worst_difference(response, best), round_off) << name;
  }
}

TEST(BlockSweep, SixteenThreadsGiveTheBytesOfOne) {
  CoupledBodies random(11);
  const DynamicMatrices m = random.bodies(Sizes(9, 6), tree_edges(9), 1e-4);
  const numerics::Load load = random.load(m.size(), 4);
  const std::vector<double> omega = frequencies(333);
  const numerics::BlockSweep blocks(m, load);
  const auto with_threads = [&](int threads) {
    numerics::SweepResult result = room_for(m.size(), omega);
    foundation::parallel_for(omega.size(), {.size = 48, .threads = threads}, [&](std::size_t first, std::size_t last) {
      solve_columns(blocks, omega, first, last, result);
    });
    return result;
  };
  const numerics::SweepResult one = with_threads(1), sixteen = with_threads(16);
  EXPECT_EQ(one.response, sixteen.response);
  EXPECT_EQ(one.backward_error, sixteen.backward_error);
}

}  // namespace block_sweep_test
