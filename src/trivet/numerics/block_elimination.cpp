// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/block_elimination.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace trivet::numerics {
namespace {

constexpr Eigen::Index body_coordinates = 6, planar_coordinates = 3, largest_block = 8;

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Blocks of one size by order.
std::vector<Eigen::Index> equal_blocks(Eigen::Index n, Eigen::Index size) {
  std::vector<Eigen::Index> starts;
  for (Eigen::Index i = 0; i < n; i += size) starts.push_back(i);
  return starts;
}

/// Nine tenths of what either is coupled to both are.
template <typename Column>
bool like(const Column& a, const Column& b) {
  return 10 * (a && b).count() >= 9 * (a || b).count();
}

/// A row joins the block before it if the two are coupled to much the same.
std::vector<Eigen::Index> runs_of_like_rows(const Couplings& c) {
  std::vector<Eigen::Index> starts;
  for (Eigen::Index i = 0; i < c.rows(); ++i) {
    const bool joins = !starts.empty() && i - starts.back() < largest_block && like(c.col(i), c.col(i - 1));
    if (!joins) starts.push_back(i);
  }
  return starts;
}

/// Blocks that are cut where they have grown too large for a kernel.
std::vector<Eigen::Index> cut(const std::vector<Eigen::Index>& starts, Eigen::Index n) {
  std::vector<Eigen::Index> result;
  for (std::size_t b = 0; b < starts.size(); ++b) {
    const Eigen::Index end = b + 1 < starts.size() ? starts[b + 1] : n;
    for (Eigen::Index i = starts[b]; i < end; i += end - starts[b] > largest_block ? body_coordinates : end - starts[b]) result.push_back(i);
  }
  return result;
}

using Neighbours = std::vector<std::set<int>>;

Neighbours graph(const Couplings& c, const std::vector<int>& block_of_row, std::size_t blocks) {
  Neighbours neighbours(blocks);
  for (Eigen::Index j = 0; j < c.cols(); ++j)
    for (Eigen::Index i = 0; i < c.rows(); ++i)
      if (c(i, j) && block_of_row[at(i)] != block_of_row[at(j)]) neighbours[at(block_of_row[at(j)])].insert(block_of_row[at(i)]);
  return neighbours;
}

}  // namespace

Couplings couplings(const DynamicMatrices& m) {
  Couplings c = m.A.array() != 0 || m.B.array() != 0 || m.K.array() != 0;
  if (m.lossy()) c = c || m.K_loss.array() != 0;
  return c || c.transpose().eval();
}

BlockElimination block_elimination(const Couplings& couplings, const std::vector<Eigen::Index>& starts, const std::vector<bool>& loaded) {
  const Eigen::Index n = couplings.rows();
  const auto blocks = static_cast<int>(starts.size());
  std::vector<int> size, block_of_row(at(n));
  std::vector<char> has_load(starts.size(), 0);
  for (int b = 0; b < blocks; ++b) {
    const Eigen::Index end = b + 1 < blocks ? starts[at(b + 1)] : n;
    size.push_back(static_cast<int>(end - starts[at(b)]));
    for (Eigen::Index i = starts[at(b)]; i < end; ++i) {
      block_of_row[at(i)] = b;
      if (loaded[at(i)]) has_load[at(b)] = 1;
    }
  }
  Neighbours neighbours = graph(couplings, block_of_row, starts.size());
  const auto degree = [&](int b) { return std::accumulate(neighbours[at(b)].begin(), neighbours[at(b)].end(), 0, [&](int sum, int k) { return sum + size[at(k)]; }); };
  std::set<std::tuple<int, char, int>> waiting;
  const auto place = [&](int b) { return std::tuple(degree(b), has_load[at(b)], b); };
  for (int b = 0; b < blocks; ++b) waiting.insert(place(b));

  std::vector<int> order, turn(starts.size());
  BlockElimination result;
  while (!waiting.empty()) {
    const int next = std::get<int(2)>(*waiting.begin());
    waiting.erase(waiting.begin());
    turn[at(next)] = static_cast<int>(order.size());
    order.push_back(next);
    const std::set<int>& clique = neighbours[at(next)];
    for (const int k : clique) {
      waiting.erase(place(k));
      std::set<int> joined;
      std::set_union(neighbours[at(k)].begin(), neighbours[at(k)].end(), clique.begin(), clique.end(), std::inserter(joined, joined.end()));
      joined.erase(k);
      joined.erase(next);
      neighbours[at(k)] = std::move(joined);
    }
    for (const int k : clique) waiting.insert(place(k));
    result.below.emplace_back(clique.begin(), clique.end());
  }
  result.first.push_back(0);
  for (const int b : order) {
    for (int i = 0; i < size[at(b)]; ++i) result.rows.push_back(starts[at(b)] + i);
    result.first.push_back(static_cast<Eigen::Index>(result.rows.size()));
  }
  for (std::vector<int>& later : result.below) {
    for (int& b : later) b = turn[at(b)];
    std::sort(later.begin(), later.end());
  }
  return result;
}

double multiply_adds(const BlockElimination& e) {
  double sum = 0;
  for (int j = 0; j < e.count(); ++j) {
    double n = e.size(j), rows = 0;
    for (const int i : e.below[at(j)]) rows += e.size(i);
    sum += n * (n + 1) * (n + 2) / 6 + n * n + rows * n * (n + 1) / 2 + rows * (rows + 1) / 2 * n + 2 * rows * n;
  }
  return sum;
}

BlockElimination cheapest_block_elimination(const DynamicMatrices& m, const std::vector<bool>& loaded, const std::vector<FreeEntry>& free) {
  Couplings c = couplings(m);
  for (const FreeEntry& entry : free) c(entry.row, entry.column) = c(entry.column, entry.row) = true;
  std::vector<std::vector<Eigen::Index>> candidates = {equal_blocks(m.size(), body_coordinates), equal_blocks(m.size(), planar_coordinates), runs_of_like_rows(c)};
  if (!m.blocks.empty()) candidates = {cut(m.blocks, m.size())};
  BlockElimination best;
  for (const std::vector<Eigen::Index>& starts : candidates) {
    BlockElimination found = block_elimination(c, starts, loaded);
    if (best.count() == 0 || multiply_adds(found) < multiply_adds(best)) best = std::move(found);
  }
  return best;
}

}  // namespace trivet::numerics
