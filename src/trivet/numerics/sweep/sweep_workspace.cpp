// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/sweep_workspace.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

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

namespace {

/// Frequencies for which blocks keep frequency-dependent parts.
constexpr long parts_together = sweep_kernels::granule;

std::size_t numbers(long planes) { return to_size(2 * planes * SweepWorkspace::chunk); }

}  // namespace

const sweep_kernels::Coefficients& SweepWorkspace::plain() {
  if (plan_->solver() != SweepSolver::aimed) return *plan_->solved_;
  if (!plain_) plain_.emplace(plan_->matrices_);
  return *plain_;
}

SweepWorkspace::SweepWorkspace(const SweepPlan& plan) : plan_(&plan) {
  for (LineMemory* one : {&omega_, &error_}) one->resize(chunk);
  const long n = plan.size();
  const bool by_blocks = plan.solver() == SweepSolver::blocks,
             one_frequency = plan.solver() == SweepSolver::one_frequency;
  q_.resize(numbers(n));
  if (!by_blocks && !one_frequency) load_.resize(numbers(n));
  if (plan.solver() == SweepSolver::aimed) amplitude_.resize(numbers(1));
  if (!plan.part_ || one_frequency) return;
  if (by_blocks) {
    part_.resize(2 * to_size(parts_together) * (plan.free_.size() + to_size(n)));
    z_part_.setZero(n, n);
  } else {
    part_.resize(numbers(n * n));
  }
}

void SweepWorkspace::fill_load(long count, bool all) {
  const bool aimed = plan_->solver() == SweepSolver::aimed;
  const Planes load = planes_in(load_), amplitude = aimed ? planes_in(amplitude_) : Planes{};
  if (!aimed || all) std::fill_n(load_.data(), load_.size(), 0.0);
  load_finite_ = true;
  if (aimed && !all && plan_->load_.is_constant()) {
    const Complex constant = plan_->load_.terms()[0].value(plan_->aim_.order.back());
    std::fill_n(amplitude.re, chunk, constant.real());
    std::fill_n(amplitude.im, chunk, constant.imag());
    return;
  }
  for (const LoadTerm& term : plan_->load_.terms())
    for (long f = 0; f < count; ++f) {
      const Complex factor = term.power == 0 && term.delay == 0 ? Complex(1) : term.factor(omega_.data()[f]);
      load_finite_ = load_finite_ && std::isfinite(std::norm(factor));
      if (aimed) amplitude.put(f, factor * term.value(plan_->aim_.order.back()));
      if (aimed && !all) continue;
      for (long i = 0; i < plan_->size(); ++i) {
        const Complex h = factor * term.value(i);
        load.re[i * chunk + f] += h.real();
        load.im[i * chunk + f] += h.imag();
      }
    }
}

void SweepWorkspace::fill_parts(long count) {
  const Eigen::Index n = plan_->size();
  const Planes part = planes_in(part_), load = planes_in(load_);
  Eigen::MatrixXcd z(n, n);
  Eigen::VectorXcd h(n);
  for (long f = 0; f < count; ++f) {
    const double omega = omega_.data()[f];
    if (f == 0 || omega != omega_.data()[f - 1]) {
      z.setZero();
      h.setZero();
      plan_->part_.add(omega, z, h);
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      load.re[i * chunk + f] += plan_->scale_(i) * h(i).real();
      load.im[i * chunk + f] += plan_->scale_(i) * h(i).imag();
      for (Eigen::Index j = 0; j < n; ++j)
        part.put((i * n + j) * chunk + f, plan_->scale_(i) * z(i, j) * plan_->scale_(j));
    }
  }
}

/// Evaluates the part at `count` ≤ `parts_together` frequencies: planes of free entries, then of h.
void SweepWorkspace::fill_free(long first, long count) {
  assert(count <= parts_together && first + count <= chunk && z_part_.isZero(0) &&
         "each part is removed after its use");
  const auto n = to_index(plan_->size());
  const Planes planes = {part_.data(), part_.data() + part_.size() / 2, parts_together};
  const auto entries = static_cast<long>(plan_->free_.size());
  const long all_planes = entries + n;
  Eigen::VectorXcd h(n);
  for (long f = 0; f < count; ++f) {
    const double omega = omega_.data()[first + f];
    if (f > 0 && omega == omega_.data()[first + f - 1]) {
      for (long k = 0; k < all_planes; ++k) {
        const long at = k * parts_together + f;
        planes.put(at, {planes.re[at - 1], planes.im[at - 1]});
      }
      continue;
    }
    h = plan_->load_.at(omega).cwiseQuotient(plan_->scale_);
    plan_->part_.add(omega, z_part_, h);
    for (long k = 0; k < entries; ++k) {
      const FreeEntry& at = plan_->free_[k];
      planes.put(k * parts_together + f, z_part_(at.row, at.column));
      z_part_(at.row, at.column) = z_part_(at.column, at.row) = 0;
    }
    for (Eigen::Index i = 0; i < n; ++i) planes.put((entries + i) * parts_together + f, h(i));
  }
}

void SweepWorkspace::solve_blocks(long padded, bool every_backward_error) {
  const Planes q = planes_in(q_);
  BlockBatch batch{omega_.data(), padded, {}, {}, q, error_.data(), every_backward_error};
  if (!plan_->part_) {
    plan_->blocks_->solve(batch, blocks_);
    return;
  }
  const auto entries = static_cast<long>(plan_->free_.size());
  batch.count = parts_together;
  batch.free = {part_.data(), part_.data() + part_.size() / 2, parts_together};
  batch.load = {batch.free.re + entries * parts_together, batch.free.im + entries * parts_together, parts_together};
  for (long first = 0; first < padded; first += parts_together) {
    fill_free(first, parts_together);
    batch.omega = omega_.data() + first;
    batch.response = {q.re + first, q.im + first, q.stride};
    batch.backward_error = error_.data() + first;
    plan_->blocks_->solve(batch, blocks_);
  }
  if (z_part_.isZero(0)) return;
  throw foundation::InvalidInput(
      "frequency-dependent part of the dynamic stiffness: it adds to entries outside its coupled rows; it must "
      "list all rows that it couples");
}

Planes SweepWorkspace::solve(const double* omega, long count, bool every_backward_error) {
  const long padded = sweep_kernels::filled_up(count, sweep_kernels::granule);
  std::copy_n(omega, count, omega_.data());
  std::fill(omega_.data() + count, omega_.data() + padded, omega[count - 1]);
  const Planes q = planes_in(q_);
  if (plan_->solver() == SweepSolver::one_frequency) {
    for (long f = 0; f < count; ++f) recompute_one(f);
    return q;
  }
  if (plan_->solver() == SweepSolver::blocks) {
    solve_blocks(padded, every_backward_error);
    recompute_rejected({}, count);
    return q;
  }
  const int wanted = every_backward_error ? 2 : 1;
  if (load_filled_ < wanted || !plan_->load_.is_constant() || plan_->part_)
    fill_load(plan_->load_.is_constant() ? chunk : padded, every_backward_error);
  load_filled_ = wanted;
  if (plan_->part_) fill_parts(padded);
  const Planes part = plan_->part_ ? planes_in(part_) : Planes{};
  sweep_kernels::Batch batch{omega_.data(), padded, planes_in(load_), part, plan_->scale_.data(), q, error_.data()};
  std::fill_n(error_.data(), padded, 0.0);
  bool good = false;
  switch (plan_->solver()) {
    case SweepSolver::aimed: {
      sweep_kernels::Batch aimed = batch;
      aimed.load = planes_in(amplitude_);
      good = sweep_kernels::solve_fixed(*plan_->solved_, &plan_->aim_, aimed);
      break;
    }
    case SweepSolver::fixed:
      good = sweep_kernels::solve_fixed(*plan_->solved_, nullptr, batch);
      break;
    case SweepSolver::pivoted:
      good = sweep_kernels::solve_pivoted(*plan_->solved_, batch);
      break;
    case SweepSolver::blocks:
    case SweepSolver::one_frequency:
      break;  // above
  }
  std::vector<char> untrusted;
  if (!good) {
    untrusted.resize(to_size(count));
    for (std::size_t f = 0; f < untrusted.size(); ++f) untrusted[f] = error_.data()[f] != 0;
  }
  if (!load_finite_) {
    // Growth does not include the load, which may be infinite at rest (a negative power of ω).
    untrusted.resize(to_size(count));
    for (long f = 0; f < count; ++f)
      if (!load_at(f).allFinite()) untrusted[f] = 1;
  }
  if (every_backward_error) {
    sweep_kernels::backward_errors(plain(), batch);
    recompute_rejected(untrusted, count);
  } else if (!untrusted.empty()) {
    recompute(untrusted);
  }
  return q;
}

}  // namespace trivet::numerics
