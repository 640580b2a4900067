// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/block_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace trivet::numerics {
namespace {

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Writes the plan of one elimination.
class Planner {
 public:
  Planner(const DynamicMatrices& m, const BlockElimination& elimination, const std::vector<FreeEntry>& free) : m_(m), e_(elimination), given_free_(free) {}

  BlockPlan plan(const Load* load, const Eigen::VectorXd& scale) {
    plan_.rows = at(m_.size());
    plan_.given_load = load == nullptr;
    plan_.multiply_adds = multiply_adds(e_);
    for (const Eigen::Index row : e_.rows) {
      plan_.given_row.push_back(at(row));
      plan_.scale.push_back(scale(row));
    }
    add_load(load);
    place_free();
    for (int j = 0; j < e_.count(); ++j) add_column_blocks(j);
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
    loaded_.assign(at(e_.count()), load == nullptr);
    if (load == nullptr) return;
    for (const LoadTerm& term : load->terms()) {
      plan_.load.push_back({term, {}});
      for (int j = 0; j < e_.count(); ++j)
        for (Eigen::Index i = e_.first[at(j)]; i < e_.first[at(j) + 1]; ++i)
          if (const std::complex<double> value = term.value(e_.rows[at(i)]); value != 0.0) {
            plan_.load.back().rows.push_back({at(i), value});
            loaded_[at(j)] = true;
          }
    }
  }

  /// Free entries by their place in the order of elimination, lower triangle.
  void place_free() {
    std::vector<std::size_t> turn(plan_.rows);
    for (std::size_t i = 0; i < plan_.rows; ++i) turn[plan_.given_row[i]] = i;
    for (std::size_t k = 0; k < given_free_.size(); ++k) {
      const std::size_t a = turn[at(given_free_[k].row)], b = turn[at(given_free_[k].column)];
      free_at_[{std::max(a, b), std::min(a, b)}] = k;
    }
  }

  /// Those in the block (i, j).
  void add_free(int i, int j, BlockPlan::Block& block) {
    block.free_first = plan_.free.size();
    std::size_t entry = 0;
    for (std::size_t r = at(e_.first[at(i)]); r < at(e_.first[at(i) + 1]); ++r)
      for (std::size_t c = at(e_.first[at(j)]); c < (i == j ? r + 1 : at(e_.first[at(j) + 1])); ++c, ++entry)
        if (const auto found = free_at_.find({r, c}); found != free_at_.end()) {
          free_number_[{r, c}] = static_cast<int>(plan_.free.size());
          plan_.free.push_back({entry, found->second, plan_.scale[r] * plan_.scale[c]});
        }
    block.free_end = plan_.free.size();
  }

  /// Values of one matrix in the block (i, j). Returns whether there are any.
  bool add_values(const Eigen::MatrixXd& matrix, int i, int j) {
    const std::size_t before = plan_.values.size();
    bool any = false;
    for (Eigen::Index r = e_.first[at(i)]; r < e_.first[at(i) + 1]; ++r)
      for (Eigen::Index c = e_.first[at(j)]; c < (i == j ? r + 1 : e_.first[at(j) + 1]); ++c) {
        plan_.values.push_back(matrix(e_.rows[at(r)], e_.rows[at(c)]));
        any = any || plan_.values.back() != 0;
      }
    if (!any) plan_.values.resize(before);
    return any;
  }

  void add_block(int i, int j) {
    BlockPlan::Block block;
    block.rows = e_.size(i), block.columns = e_.size(j), block.diagonal = i == j;
    block.values = plan_.values.size();
    block.has_K = add_values(m_.K, i, j);
    block.has_loss = m_.lossy() && add_values(m_.K_loss, i, j);
    block.has_B = add_values(m_.B, i, j);
    block.has_A = add_values(m_.A, i, j);
    if (!free_at_.empty()) add_free(i, j, block);
    block.kept = i == j || block.has_free();
    number_[{i, j}] = static_cast<int>(plan_.blocks.size());
    plan_.blocks.push_back(block);
  }

  void add_column_blocks(int j) {
    add_block(j, j);
    for (const int i : e_.below[at(j)]) add_block(i, j);
  }

  /// Blocks from which something is subtracted before they divide.
  void mark_kept(int j) {
    const std::vector<int>& below = e_.below[at(j)];
    for (std::size_t left = 0; left < below.size(); ++left)
      for (std::size_t right = 0; right <= left; ++right) plan_.blocks[at(number_.at({below[left], below[right]}))].kept = true;
  }

  void place_kept() {
    for (BlockPlan::Block& block : plan_.blocks) {
      block.place = plan_.factors;
      if (block.kept) plan_.factors += at(block.entries());
    }
  }

  bool first_touch(int block) {
    const bool first = !touched_[at(block)];
    touched_[at(block)] = true;
    return first;
  }

  void add_column(int j) {
    BlockPlan::Column column;
    column.size = e_.size(j), column.row = at(e_.first[at(j)]), column.diagonal = number_.at({j, j});
    column.first = first_touch(column.diagonal);
    column.loaded = loaded_[at(j)];
    column.below_first = plan_.below.size(), column.update_first = plan_.updates.size();
    std::size_t entries = 0;
    const std::vector<int>& below = e_.below[at(j)];
    for (const int i : below) {
      const int block = number_.at({i, j});
      plan_.below.push_back({block, at(e_.first[at(i)]), first_touch(block) && plan_.blocks[at(block)].kept, entries});
      entries += at(plan_.blocks[at(block)].entries());
      if (column.loaded) loaded_[at(i)] = true;
    }
    for (std::size_t left = 0; left < below.size(); ++left)
      for (std::size_t right = 0; right <= left; ++right) {
        const int target = number_.at({below[left], below[right]});
        plan_.updates.push_back({target, column.below_first + left, column.below_first + right, first_touch(target)});
      }
    column.below_end = plan_.below.size(), column.update_end = plan_.updates.size();
    plan_.widest = std::max(plan_.widest, entries);
    plan_.columns.push_back(column);
  }

  void add_entries() {
    plan_.entry_first.push_back(0);
    for (const Eigen::Index i : e_.rows) {
      for (std::size_t c = 0; c < plan_.rows; ++c) {
        const Eigen::Index j = e_.rows[c];
        BlockPlan::Entry entry{c, m_.A(i, j), m_.B(i, j), m_.K(i, j), m_.lossy() ? m_.K_loss(i, j) : 0.0};
        const std::size_t r = plan_.entry_first.size() - 1;
        if (const auto found = free_number_.find({std::max(r, c), std::min(r, c)}); found != free_number_.end()) entry.free = found->second;
        if (entry.A != 0 || entry.B != 0 || entry.K != 0 || entry.loss != 0 || entry.free >= 0) plan_.entries.push_back(entry);
      }
      plan_.entry_first.push_back(plan_.entries.size());
    }
  }

  void add_large_rows() {
    using Part = double BlockPlan::Entry::*;
    for (const Part part : {&BlockPlan::Entry::A, &BlockPlan::Entry::B, &BlockPlan::Entry::K, &BlockPlan::Entry::loss}) {
      std::size_t largest = 0;
      double most = -1;
      for (std::size_t i = 0; i < plan_.rows; ++i) {
        double sum = 0;
        for (std::size_t k = plan_.entry_first[i]; k < plan_.entry_first[i + 1]; ++k) sum += std::abs(plan_.entries[k].*part);
        if (sum > most) most = sum, largest = i;
      }
      if (std::find(plan_.large_rows.begin(), plan_.large_rows.end(), largest) == plan_.large_rows.end()) plan_.large_rows.push_back(largest);
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

  const DynamicMatrices& m_;
  const BlockElimination& e_;
  const std::vector<FreeEntry>& given_free_;
  BlockPlan plan_;
  std::map<std::pair<int, int>, int> number_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> free_at_;
  std::map<std::pair<std::size_t, std::size_t>, int> free_number_;
  std::vector<bool> loaded_, touched_;
};

}  // namespace

BlockPlan block_plan(const DynamicMatrices& matrices, const Load* load, const Eigen::VectorXd& scale, const std::vector<FreeEntry>& free) {
  std::vector<bool> loaded(at(matrices.size()), load == nullptr);
  if (load != nullptr)
    for (const LoadTerm& term : load->terms())
      for (Eigen::Index i = 0; i < term.value.size(); ++i)
        if (term.value(i) != 0.0) loaded[at(i)] = true;
  const BlockElimination elimination = cheapest_block_elimination(matrices, loaded, free);
  return Planner(matrices, elimination, free).plan(load, scale);
}

}  // namespace trivet::numerics
