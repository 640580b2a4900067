// SPDX-License-Identifier: BSD-3-Clause
// The order of elimination of coupled bodies: fill and cost on graphs whose best order is known.
#include "trivet/numerics/sweep/block_elimination.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/coupled_bodies.h"
#include "trivet/foundation/index.h"

namespace block_elimination_test {

using namespace trivet;
using Eigen::Index;
using numerics::DynamicMatrices;
using test::chain_edges, test::full_edges, test::ring_edges, test::tree_edges;
using test::CoupledBodies, test::Edges, test::Sizes;

numerics::Couplings couplings_of(const DynamicMatrices& m) {
  return numerics::couplings(m.size(), numerics::symmetric_entries(m, Eigen::VectorXd::Ones(m.size())));
}

/// Blocks that are filled during elimination, in addition to the couplings.
std::size_t filled(const Edges& edges, Index bodies) {
  CoupledBodies random(12);
  const DynamicMatrices m = random.bodies(Sizes(to_size(bodies), 6), edges, 0.1);
  const numerics::BlockElimination found =
      numerics::block_elimination(couplings_of(m), m.blocks, std::vector<bool>(to_size(m.size()), true));
  std::size_t below = 0;
  for (const auto& column : found.below) below += column.size();
  return below - edges.size();
}

TEST(BlockElimination, ChainsAndTreesFillNothingAndARingOneBlockPerBody) {
  EXPECT_EQ(filled(chain_edges(20), 20), 0U);
  EXPECT_EQ(filled(tree_edges(40), 40), 0U);
  EXPECT_EQ(filled(ring_edges(20), 20), 17U);
  EXPECT_EQ(filled(full_edges(8), 8), 0U);
}

TEST(BlockElimination, ALoadIsEliminatedLastIfThatCostsNothing) {
  CoupledBodies random(13);
  const DynamicMatrices m = random.bodies(Sizes(12, 6), chain_edges(12), 0.1);
  for (const Index body : {0, 5, 11}) {
    std::vector<bool> loaded(to_size(m.size()), false);
    loaded[6 * body + 2] = true;
    const numerics::BlockElimination found = numerics::block_elimination(couplings_of(m), m.blocks, loaded);
    EXPECT_EQ(found.rows.back() / 6, body);
  }
}

TEST(BlockElimination, BodiesAreFoundInTheCouplings) {
  constexpr double times_the_cost = 1.3;  // of the elimination by the bodies themselves
  CoupledBodies random(14);
  for (const Sizes& sizes : {Sizes(10, 6), Sizes(10, 3), Sizes{6, 3, 6, 3, 6, 3}}) {
    const auto bodies = static_cast<Index>(sizes.size());
    DynamicMatrices m = random.bodies(sizes, chain_edges(bodies), 0.1);
    const std::vector<bool> loaded(to_size(m.size()), true);
    const double named = numerics::cost(numerics::cheapest_block_elimination(couplings_of(m), m.blocks, loaded));
    m.blocks.clear();
    EXPECT_LE(numerics::cost(numerics::cheapest_block_elimination(couplings_of(m), m.blocks, loaded)),
              times_the_cost * named);
  }
}

TEST(BlockElimination, BodiesWithZerosInTheirCouplingsAreNotCutIntoSmallBlocks) {
  // As with skew dampers in a plane: blocks of one row need a few multiplications less, but many more visits.
  CoupledBodies random(16);
  DynamicMatrices m = random.bodies(Sizes(10, 6), chain_edges(10), 0.1);
  const std::array<const char*, 6> pattern = {"xx.xxx", "xx.xxx", "..xxx.", "xxxxxx", "xxxxxx", "xx.xxx"};
  for (Eigen::MatrixXd* matrix : {&m.A, &m.B, &m.K})
    for (Index i = 0; i < m.size(); ++i)
      for (Index j = 0; j < m.size(); ++j)
        if (pattern[i % 6][j % 6] == '.') (*matrix)(i, j) = 0;
  m.blocks.clear();
  std::vector<bool> loaded(to_size(m.size()), false);
  std::fill(loaded.end() - 6, loaded.end(), true);
  const numerics::BlockElimination found = numerics::cheapest_block_elimination(couplings_of(m), m.blocks, loaded);
  EXPECT_EQ(found.count(), 10);
}

}  // namespace block_elimination_test
