// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/sweep_plan.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::numerics {
namespace {

/// Largest number of coordinates for which full frequency-dependent parts are kept for a whole chunk, some ten
/// megabytes.
constexpr Eigen::Index most_with_part = 48;

/// Whether a load term is a real vector times a complex number.
bool has_real_direction(const Eigen::VectorXcd& value, Eigen::Index largest) {
  for (const Complex& v : value)
    if ((v * std::conj(value(largest))).imag() != 0) return false;
  return true;
}

/// Entries of the lower triangle that a part may change.
std::vector<FreeEntry> entries_of(const FrequencyPart& part, Eigen::Index n) {
  std::vector<std::vector<Eigen::Index>> groups = part.coupled_rows;
  if (groups.empty()) {
    groups.resize(1);
    for (Eigen::Index i = 0; i < n; ++i) groups[0].push_back(i);
  }
  std::vector<std::pair<Eigen::Index, Eigen::Index>> places;
  for (const std::vector<Eigen::Index>& rows : groups)
    for (const Eigen::Index i : rows)
      for (const Eigen::Index j : rows)
        if (i >= j) places.emplace_back(j, i);
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
  std::vector<FreeEntry> entries;
  assert(places.empty() || (places.front().first >= 0 && places.back().second < n));
  for (const auto& [column, row] : places) entries.push_back({row, column});
  return entries;
}

}  // namespace

SweepPlan::SweepPlan(const DynamicMatrices& matrices, const Load& load, FrequencyPart part)
    : scale_(unit_scale(matrices)), load_(load.scaled(scale_)), part_(std::move(part)) {
  assert(load.vanishes() || load.size() == matrices.size());
  // Measured with AVX-512 from 7 to 14 coordinates, all coupled: blocks take 0.5 … 0.9 of the time of loops over all
  // coordinates, including their check.
  if (matrices.symmetric && (part_ || matrices.size() > sweep_kernels::most_fixed)) {
    use_blocks(matrices, load);
    return;
  }
  matrices_ = scaled(matrices, scale_);
  choose_solver();
  if (!solved_) solved_.emplace(matrices_);
}

void SweepPlan::use_blocks(const DynamicMatrices& given, const Load& given_load) {
  solver_ = SweepSolver::blocks;
  if (part_) {
    free_ = entries_of(part_, given.size());
    blocks_.emplace(given, free_);
  } else {
    blocks_.emplace(given, given_load);
  }
}

void SweepPlan::choose_solver() {
  if (!matrices_.symmetric) {
    if (part_ && matrices_.size() > most_with_part) solver_ = SweepSolver::one_frequency;
    return;
  }
  solver_ = SweepSolver::fixed;
  if (load_.terms().size() != 1) return;
  Eigen::Index largest = 0;
  const LoadTerm& term = load_.terms()[0];
  term.value.cwiseAbs().maxCoeff(&largest);
  if (has_real_direction(term.value, largest)) aim(term, largest);
}

/// With T = I − e_n ratioᵀ after an exchange of `last` with n: Tᵀh = h_n e_n.
void SweepPlan::aim(const LoadTerm& term, Eigen::Index last) {
  const Eigen::Index n = matrices_.size();
  aim_.order.resize(to_size(n));
  aim_.ratio.resize(to_size(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = to_size(i);
    aim_.order[at] = static_cast<int>(i == last ? n - 1 : i == n - 1 ? last : i);
    aim_.ratio[at] = i < n - 1 ? (term.value(aim_.order[at]) / term.value(last)).real() : 0;
    assert(std::abs(aim_.ratio[at]) <= 1 + 1e-12 && "the load acts most on `last`, so T does not grow rounding");
  }
  const auto transformed = [&](Eigen::MatrixXd x) {
    if (x.size() == 0) return x;
    x.row(last).swap(x.row(n - 1));
    x.col(last).swap(x.col(n - 1));
    for (Eigen::Index i = 0; i < n - 1; ++i) x.row(i) -= aim_.ratio[i] * x.row(n - 1);
    for (Eigen::Index j = 0; j < n - 1; ++j) x.col(j) -= aim_.ratio[j] * x.col(n - 1);
    return x;
  };
  solved_.emplace(DynamicMatrices{transformed(matrices_.A), transformed(matrices_.B), transformed(matrices_.K),
                                  transformed(matrices_.K_loss), true});
  solver_ = SweepSolver::aimed;
}

}  // namespace trivet::numerics
