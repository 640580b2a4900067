// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/block_plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::numerics {
namespace {

/// Writes the plan of one elimination.
class Planner {
 public:
  Planner(const BlockElimination& elimination, std::vector<SymmetricEntry> entries)
      : e_(elimination), entries_(std::move(entries)) {}

  BlockPlan plan(const Load* load, const Eigen::VectorXd& scale) {
    plan_.rows = e_.rows.size();
    plan_.given_load = load == nullptr;
    plan_.multiply_adds = multiply_adds(e_);
    for (const Eigen::Index row : e_.rows) {
      plan_.given_row.push_back(to_size(row));
      plan_.scale.push_back(scale(row));
    }
    add_load(load);
    put_in_order();
    for (int j = 0; j < e_.count(); ++j) add_column_blocks(j);
    add_values();
    for (int j = 0; j < e_.count(); ++j) mark_kept(j);
    place_kept();
    touched_.assign(plan_.blocks.size(), false);
    for (int j = 0; j < e_.count(); ++j) add_column(j);
    add_entries();
    add_large_rows();
    add_weights();
    return std::move(plan_);
  }

 private:
  void add_load(const Load* load) {
    loaded_.assign(to_size(e_.count()), load == nullptr);
    if (load == nullptr) return;
    for (const LoadTerm& term : load->terms()) {
      plan_.load.push_back({term, {}});
      for (int j = 0; j < e_.count(); ++j)
        for (Eigen::Index i = e_.first[j]; i < e_.first[j + 1]; ++i)
          if (const std::complex<double> value = term.value(e_.rows[i]); value != 0.0) {
            plan_.load.back().rows.push_back({to_size(i), value});
            loaded_[j] = true;
          }
    }
  }

  /// Renumbers rows and columns of the entries in elimination order, again as a lower triangle.
  void put_in_order() {
    std::vector<Eigen::Index> turn(plan_.rows);
    for (std::size_t i = 0; i < plan_.rows; ++i) turn[plan_.given_row[i]] = to_index(i);
    for (SymmetricEntry& e : entries_) {
      const Eigen::Index a = turn[e.row], b = turn[e.column];
      e.row = std::max(a, b), e.column = std::min(a, b);
    }
    for (int j = 0; j < e_.count(); ++j) block_of_row_.insert(block_of_row_.end(), to_size(e_.size(j)), j);
  }

  void add_block(int i, int j) {
    BlockPlan::Block block;
    block.rows = e_.size(i), block.columns = e_.size(j), block.diagonal = i == j;
    plan_.blocks.push_back(block);
  }

  /// Adds the diagonal block, then those below it.
  void add_column_blocks(int j) {
    first_of_column_.push_back(static_cast<int>(plan_.blocks.size()));
    add_block(j, j);
    for (const int i : e_.below[j]) add_block(i, j);
  }

  [[nodiscard]] int number(int i, int j) const {
    if (i == j) return first_of_column_[j];
    const std::vector<int>& below = e_.below[j];
    assert(std::ranges::binary_search(below, i) && "the elimination knows every block that it fills");
    return first_of_column_[j] + 1 + static_cast<int>(std::ranges::lower_bound(below, i) - below.begin());
  }

  void add_values() {
    std::vector<int> block_of_entry;
    for (const SymmetricEntry& e : entries_) {
      block_of_entry.push_back(number(block_of_row_[e.row], block_of_row_[e.column]));
      BlockPlan::Block& block = plan_.blocks[block_of_entry.back()];
      block.has_K |= e.K != 0, block.has_loss |= e.loss != 0, block.has_B |= e.B != 0, block.has_A |= e.A != 0;
      block.free_end += e.free >= 0 ? 1 : 0;  // their number, for now
    }
    std::size_t values = 0, free = 0;
    for (BlockPlan::Block& block : plan_.blocks) {
      block.values = values;
      values += to_size(block.entries()) * to_size(block.has_K + block.has_loss + block.has_B + block.has_A);
      block.kept = block.diagonal || block.has_free();
      block.free_first = free;
      free += block.free_end;
      block.free_end = block.free_first;
    }
    plan_.values.assign(values, 0);
    plan_.free.resize(free);
    for (std::size_t k = 0; k < entries_.size(); ++k) put(entries_[k], plan_.blocks[block_of_entry[k]]);
  }

  void put(SymmetricEntry& e, BlockPlan::Block& block) {
    const Eigen::Index i = e.row - e_.first[block_of_row_[e.row]], j = e.column - e_.first[block_of_row_[e.column]];
    const Eigen::Index entry = block.diagonal ? i * (i + 1) / 2 + j : i * block.columns + j;
    assert(entry >= 0 && entry < block.entries() && i >= 0 && j >= 0 && j < block.columns);
    std::size_t to = block.values + to_size(entry);
    for (const auto& [has, value] :
         {std::pair(block.has_K, e.K), {block.has_loss, e.loss}, {block.has_B, e.B}, {block.has_A, e.A}}) {
      if (has) plan_.values[to] = value, to += to_size(block.entries());
    }
    if (e.free < 0) return;
    plan_.free[block.free_end] = {to_size(entry), to_size(e.free), plan_.scale[e.row] * plan_.scale[e.column],
                                  to_size(e.row), to_size(e.column)};
    e.free = static_cast<int>(block.free_end++);
  }

  /// Marks the blocks that are updated before they are divided.
  void mark_kept(int j) {
    const std::vector<int>& below = e_.below[j];
    for (std::size_t left = 0; left < below.size(); ++left)
      for (std::size_t right = 0; right <= left; ++right) plan_.blocks[number(below[left], below[right])].kept = true;
  }

  void place_kept() {
    for (BlockPlan::Block& block : plan_.blocks) {
      block.place = plan_.factors;
      if (block.kept) plan_.factors += to_size(block.entries());
    }
  }

  bool first_touch(int block) {
    const bool first = !touched_[block];
    touched_[block] = true;
    return first;
  }

  void add_column(int j) {
    BlockPlan::Column column;
    column.size = e_.size(j), column.row = to_size(e_.first[j]), column.diagonal = number(j, j);
    column.first = first_touch(column.diagonal);
    column.loaded = loaded_[j];
    column.below_first = plan_.below.size(), column.update_first = plan_.updates.size();
    std::size_t entries = 0;
    const std::vector<int>& below = e_.below[j];
    for (const int i : below) {
      const int block = number(i, j);
      plan_.below.push_back({block, to_size(e_.first[i]), first_touch(block) && plan_.blocks[block].kept, entries});
      entries += to_size(plan_.blocks[block].entries());
      if (column.loaded) loaded_[i] = true;
    }
    for (std::size_t left = 0; left < below.size(); ++left)
      for (std::size_t right = 0; right <= left; ++right) {
        const int target = number(below[left], below[right]);
        plan_.updates.push_back({target, column.below_first + left, column.below_first + right, first_touch(target)});
      }
    column.below_end = plan_.below.size(), column.update_end = plan_.updates.size();
    plan_.widest = std::max(plan_.widest, entries);
    plan_.columns.push_back(column);
  }

  /// Adds the entries of both triangles by rows.
  void add_entries() {
    plan_.entry_first.assign(plan_.rows + 1, 0);
    for (const SymmetricEntry& e : entries_) {
      ++plan_.entry_first[e.row + 1];
      if (e.row != e.column) ++plan_.entry_first[e.column + 1];
    }
    std::partial_sum(plan_.entry_first.begin(), plan_.entry_first.end(), plan_.entry_first.begin());
    plan_.entries.resize(plan_.entry_first.back());
    std::vector<std::size_t> next = plan_.entry_first;
    for (const SymmetricEntry& e : entries_) {
      plan_.entries[next[e.row]++] = {to_size(e.column), e.A, e.B, e.K, e.loss, e.free};
      if (e.row != e.column) plan_.entries[next[e.column]++] = {to_size(e.row), e.A, e.B, e.K, e.loss, e.free};
    }
  }

  void add_large_rows() {
    assert(plan_.entry_first.back() == plan_.entries.size() && "each row ends where the next one begins");
    using Part = double BlockPlan::Entry::*;
    for (const Part part :
         {&BlockPlan::Entry::A, &BlockPlan::Entry::B, &BlockPlan::Entry::K, &BlockPlan::Entry::loss}) {
      std::size_t largest = 0;
      double most = 0;
      for (std::size_t i = 0; i < plan_.rows; ++i) {
        double sum = 0;
        for (std::size_t k = plan_.entry_first[i]; k < plan_.entry_first[i + 1]; ++k)
          sum += std::abs(plan_.entries[k].*part);
        if (sum > most) most = sum, largest = i;
      }
      if (most > 0 && std::ranges::find(plan_.large_rows, largest) == plan_.large_rows.end())
        plan_.large_rows.push_back(largest);
    }
  }

  void add_weights() {
    std::uint64_t state = 0x9e3779b97f4a7c15u;  // any fixed sequence without a pattern: Knuth's linear congruential one
    for (std::size_t i = 0; i < plan_.rows; ++i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      const double size = 0.5 + static_cast<double>(state >> 12) * 0x1p-53;
      plan_.weight.push_back((state >> 11 & 1) != 0 ? size : -size);
    }
    for (BlockPlan::Term& term : plan_.load)
      for (const BlockPlan::LoadRow& row : term.rows) term.weighted += plan_.weight[row.row] * row.value;
    plan_.weighted_A.assign(plan_.rows, 0);
    plan_.weighted_B = plan_.weighted_K = plan_.weighted_loss = plan_.weighted_A;
    for (std::size_t i = 0; i < plan_.rows; ++i)
      for (std::size_t k = plan_.entry_first[i]; k < plan_.entry_first[i + 1]; ++k) {
        const BlockPlan::Entry& entry = plan_.entries[k];
        plan_.weighted_A[entry.column] += plan_.weight[i] * entry.A;
        plan_.weighted_B[entry.column] += plan_.weight[i] * entry.B;
        plan_.weighted_K[entry.column] += plan_.weight[i] * entry.K;
        plan_.weighted_loss[entry.column] += plan_.weight[i] * entry.loss;
      }
  }

  const BlockElimination& e_;
  std::vector<SymmetricEntry> entries_;
  BlockPlan plan_;
  std::vector<int> block_of_row_, first_of_column_;
  std::vector<bool> loaded_, touched_;
};

}  // namespace

BlockPlan block_plan(const DynamicMatrices& matrices, const Load* load, const Eigen::VectorXd& scale,
                     const std::vector<FreeEntry>& free) {
  std::vector<bool> loaded(to_size(matrices.size()), load == nullptr);
  if (load != nullptr)
    for (const LoadTerm& term : load->terms())
      for (Eigen::Index i = 0; i < term.value.size(); ++i)
        if (term.value(i) != 0.0) loaded[i] = true;
  std::vector<SymmetricEntry> entries = symmetric_entries(matrices, scale);
  add_free(free, entries);
  const BlockElimination elimination =
      cheapest_block_elimination(couplings(matrices.size(), entries), matrices.blocks, loaded);
  return Planner(elimination, std::move(entries)).plan(load, scale);
}

}  // namespace trivet::numerics
