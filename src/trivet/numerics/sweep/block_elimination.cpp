// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/block_elimination.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <iterator>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::numerics {
namespace {

constexpr Eigen::Index body_coordinates = 6, planar_coordinates = 3, largest_block = largest_kernel_block;

/// First rows of blocks of equal size, in order.
std::vector<Eigen::Index> equal_blocks(Eigen::Index n, Eigen::Index size) {
  std::vector<Eigen::Index> starts;
  for (Eigen::Index i = 0; i < n; i += size) starts.push_back(i);
  return starts;
}

/// Whether two rows have nine tenths of all their couplings in common.
bool has_similar_couplings(const std::vector<int>& a, const std::vector<int>& b) {
  std::size_t both = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size(); a[i] < b[j] ? ++i : ++j)
    if (a[i] == b[j]) ++both;
  return 10 * both >= 9 * (a.size() + b.size() - both);
}

/// Blocks of consecutive rows: a row joins the previous block if its couplings are like those of the row before.
std::vector<Eigen::Index> runs_of_like_rows(const Couplings& c) {
  std::vector<Eigen::Index> starts;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto row = to_index(i);
    const bool joins = !starts.empty() && row - starts.back() < largest_block && has_similar_couplings(c[i], c[i - 1]);
    if (!joins) starts.push_back(row);
  }
  return starts;
}

/// Whether blocks of six are so full that smaller blocks, which need more visits, cannot be cheaper.
bool mostly_filled(const Couplings& c) {
  constexpr double most = 0.75;
  double entries = 0, room = 0;
  for (std::size_t first = 0; first < c.size(); first += body_coordinates) {
    const std::size_t rows = std::min(c.size() - first, to_size(body_coordinates));
    std::vector<int> columns;  // blocks
    for (std::size_t i = first; i < first + rows; ++i) {
      entries += static_cast<double>(c[i].size());
      for (int before = -1; const int j : c[i])
        if (const int block = j / body_coordinates; block != std::exchange(before, block)) columns.push_back(block);
    }
    std::ranges::sort(columns);
    room += static_cast<double>(rows) *
        static_cast<double>(body_coordinates * (std::ranges::unique(columns).begin() - columns.begin()));
  }
  return entries >= most * room;
}

/// First rows of the blocks, split if they are too large for a kernel.
std::vector<Eigen::Index> split_starts(const std::vector<Eigen::Index>& starts, Eigen::Index n) {
  std::vector<Eigen::Index> result;
  for (std::size_t b = 0; b < starts.size(); ++b) {
    const Eigen::Index end = b + 1 < starts.size() ? starts[b + 1] : n;
    for (Eigen::Index i = starts[b]; i<end; i += end - starts[b]> largest_block ? body_coordinates : end - starts[b])
      result.push_back(i);
  }
  return result;
}

/// Other blocks that each block is coupled to, ascending.
using Neighbours = std::vector<std::vector<int>>;

Neighbours graph(const Couplings& c, const std::vector<int>& block_of_row, std::size_t blocks) {
  Neighbours neighbours(blocks);
  for (std::size_t i = 0; i < c.size(); ++i)
    for (int before = block_of_row[i]; const int j : c[i])
      if (const int block = block_of_row[j]; block != std::exchange(before, block) && block != block_of_row[i])
        neighbours[block_of_row[i]].push_back(block);
  for (std::vector<int>& of_block : neighbours) {
    std::ranges::sort(of_block);
    of_block.erase(std::ranges::unique(of_block).begin(), of_block.end());
  }
  return neighbours;
}

}  // namespace

Couplings couplings(Eigen::Index rows, const std::vector<SymmetricEntry>& entries) {
  Couplings c(to_size(rows));
  assert(std::ranges::all_of(
             entries, [&](const SymmetricEntry& e) { return e.column >= 0 && e.column <= e.row && e.row < rows; }) &&
         "entries of the lower triangle");
  for (const SymmetricEntry& e : entries)
    c[e.row].push_back(static_cast<int>(e.column));  // columns come in order, and none right of the diagonal
  for (const SymmetricEntry& e : entries)
    if (e.row != e.column) c[e.column].push_back(static_cast<int>(e.row));
  return c;
}

BlockElimination block_elimination(const Couplings& couplings, const std::vector<Eigen::Index>& starts,
                                   const std::vector<bool>& loaded) {
  const auto n = to_index(couplings.size());
  const auto blocks = static_cast<int>(starts.size());
  assert(to_index(loaded.size()) == n && starts.empty() == (n == 0) && (starts.empty() || starts.front() == 0));
  std::vector<int> size, block_of_row(to_size(n));
  std::vector<char> has_load(starts.size(), 0);
  for (int b = 0; b < blocks; ++b) {
    const Eigen::Index end = b + 1 < blocks ? starts[b + 1] : n;
    size.push_back(static_cast<int>(end - starts[b]));
    assert(size.back() > 0 && size.back() <= largest_kernel_block && "the rows of a block fit the registers");
    for (Eigen::Index i = starts[b]; i < end; ++i) {
      block_of_row[i] = b;
      if (loaded[i]) has_load[b] = 1;
    }
  }
  Neighbours neighbours = graph(couplings, block_of_row, starts.size());
  const auto degree = [&](int b) {
    return std::accumulate(neighbours[b].begin(), neighbours[b].end(), 0,
                           [&](int sum, int k) { return sum + size[k]; });
  };
  using Waiting = std::tuple<int, char, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;  // may contain outdated degrees
  std::vector<int> now;                                                      // current degrees
  for (int b = 0; b < blocks; ++b) queue.emplace(now.emplace_back(degree(b)), has_load[b], b);

  std::vector<int> order, turn(starts.size(), -1), joined;
  BlockElimination result;
  while (!queue.empty()) {
    const auto [then, with_load, next] = queue.top();
    queue.pop();
    if (turn[next] >= 0 || then != now[next]) continue;
    turn[next] = static_cast<int>(order.size());
    order.push_back(next);
    const std::vector<int> clique = std::move(neighbours[next]);
    for (const int k : clique) {
      joined.clear();
      std::set_union(neighbours[k].begin(), neighbours[k].end(), clique.begin(), clique.end(),
                     std::back_inserter(joined));
      std::erase_if(joined, [&](int b) { return b == k || b == next; });
      neighbours[k] = joined;
      now[k] = degree(k);
    }
    for (const int k : clique) queue.emplace(now[k], has_load[k], k);
    result.below.push_back(clique);
  }
  assert(order.size() == starts.size() && "every block is eliminated once, also without couplings");
  result.first.push_back(0);
  for (const int b : order) {
    for (int i = 0; i < size[b]; ++i) result.rows.push_back(starts[b] + i);
    result.first.push_back(to_index(result.rows.size()));
  }
  for (std::vector<int>& later : result.below) {
    for (int& b : later) b = turn[b];
    assert(std::ranges::all_of(later, [&](int b) { return b > &later - result.below.data(); }) &&
           "a block acts on later ones only");
    std::ranges::sort(later);
  }
  return result;
}

double multiply_adds(const BlockElimination& e) {
  double sum = 0;
  for (int j = 0; j < e.count(); ++j) {
    double n = e.size(j), rows = 0;
    for (const int i : e.below[j]) rows += e.size(i);
    sum += n * (n + 1) * (n + 2) / 6 + n * n + rows * n * (n + 1) / 2 + rows * (rows + 1) / 2 * n + 2 * rows * n;
  }
  return sum;
}

double cost(const BlockElimination& e) {
  // Measured with AVX-512 for sizes from 1 to 8, in chains and fully coupled.
  constexpr double of_visit = 16, of_other_sizes = 1.35;
  double visits = 0;
  bool all_six = true;
  for (int j = 0; j < e.count(); ++j) {
    const auto below = static_cast<double>(e.below[j].size());
    visits += 1 + below + below * (below + 1) / 2;
    all_six = all_six && e.size(j) == body_coordinates;
  }
  return multiply_adds(e) * (all_six ? 1 : of_other_sizes) + of_visit * visits;
}

BlockElimination cheapest_block_elimination(const Couplings& c, const std::vector<Eigen::Index>& given,
                                            const std::vector<bool>& loaded) {
  const auto n = to_index(c.size());
  if (!given.empty()) return block_elimination(c, split_starts(given, n), loaded);
  BlockElimination best = block_elimination(c, equal_blocks(n, body_coordinates), loaded);
  if (mostly_filled(c)) return best;
  for (const std::vector<Eigen::Index>& starts : {equal_blocks(n, planar_coordinates), runs_of_like_rows(c)}) {
    BlockElimination found = block_elimination(c, starts, loaded);
    if (cost(found) < cost(best)) best = std::move(found);
  }
  return best;
}

}  // namespace trivet::numerics
