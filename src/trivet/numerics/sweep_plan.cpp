// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep_plan.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {
namespace {

/// Coordinates up to which full parts that depend on ω are kept for a whole chunk, some ten megabytes.
constexpr Eigen::Index most_with_part = 48;

/// Frequencies for which blocks keep such parts.
constexpr long parts_together = sweep_kernels::granule;

long filled_up(long count, long granule) { return (count + granule - 1) / granule * granule; }

std::size_t numbers(long planes) { return static_cast<std::size_t>(2 * planes * SweepWorkspace::chunk); }

/// Planes of a chunk: real parts first, then imaginary parts.
Planes planes_in(const LineMemory& memory) { return {memory.data(), memory.data() + memory.size() / 2, SweepWorkspace::chunk}; }

void put(const Planes& planes, long at, Complex value) {
  planes.re[at] = value.real();
  planes.im[at] = value.imag();
}

/// The real vector times a complex number that a load term is, or none.
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
  std::set<std::pair<Eigen::Index, Eigen::Index>> places;
  for (const std::vector<Eigen::Index>& rows : groups)
    for (const Eigen::Index i : rows)
      for (const Eigen::Index j : rows)
        if (i >= j) places.emplace(j, i);
  std::vector<FreeEntry> entries;
  for (const auto& [column, row] : places) entries.push_back({row, column});
  return entries;
}

}  // namespace

SweepPlan::SweepPlan(const DynamicMatrices& matrices, const Load& load, FrequencyPart part)
    : scale_(unit_scale(matrices)), load_(load.scaled(scale_)), part_(std::move(part)) {
  // Measured with AVX-512 from 7 to 14 coordinates, all coupled: blocks take 0.5 … 0.9 of the time of loops over all, their check included.
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
    if (part_ && matrices_.size() > most_with_part) solver_ = SweepSolver::alone;
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
  Eigen::PermutationMatrix<Eigen::Dynamic> exchange(n);
  exchange.setIdentity();
  std::swap(exchange.indices()(last), exchange.indices()(n - 1));
  Eigen::VectorXd ratio = Eigen::VectorXd::Zero(n);
  aim_.order.resize(static_cast<std::size_t>(n));
  aim_.ratio.resize(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    aim_.order[at] = exchange.indices()(i);
    if (i < n - 1) ratio(i) = (term.value(aim_.order[at]) / term.value(last)).real();
    aim_.ratio[at] = ratio(i);
  }
  const auto carried = [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
    if (x.size() == 0) return x;
    Eigen::MatrixXd y = exchange.transpose() * x * exchange;
    y -= ratio * y.row(n - 1).eval();
    y -= y.col(n - 1).eval() * ratio.transpose();
    return y;
  };
  solved_.emplace(DynamicMatrices{carried(matrices_.A), carried(matrices_.B), carried(matrices_.K), carried(matrices_.K_loss), true});
  solver_ = SweepSolver::aimed;
}

const sweep_kernels::Coefficients& SweepWorkspace::plain() {
  if (plan_->solver() != SweepSolver::aimed) return *plan_->solved_;
  if (!plain_) plain_.emplace(plan_->matrices_);
  return *plain_;
}

void SweepWorkspace::take(const SweepPlan& plan) {
  plan_ = &plan;
  plain_.reset();
  load_filled_ = 0;
  for (LineMemory* one : {&omega_, &error_}) one->resize(chunk);
  const long n = plan.size();
  const bool blocks = plan.solver() == SweepSolver::blocks;
  q_.resize(numbers(n));
  load_.resize(blocks ? 0 : numbers(n));
  amplitude_.resize(plan.solver() == SweepSolver::aimed ? numbers(1) : 0);
  part_.resize(!plan.part_ || plan.solver() == SweepSolver::alone ? 0 : blocks ? 2 * static_cast<std::size_t>(parts_together) * (plan.free_.size() + plan.scale_.size()) : numbers(n * n));
  z_part_.setZero(blocks && plan.part_ ? n : 0, blocks && plan.part_ ? n : 0);
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
      if (aimed) put(amplitude, f, factor * term.value(plan_->aim_.order.back()));
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
      for (Eigen::Index j = 0; j < n; ++j) put(part, (i * n + j) * chunk + f, plan_->scale_(i) * z(i, j) * plan_->scale_(j));
    }
  }
}

/// What the part brings at `count` ≤ `parts_together` frequencies: planes of free entries, then of h.
void SweepWorkspace::fill_free(long first, long count) {
  const auto n = static_cast<Eigen::Index>(plan_->size());
  const Planes planes = {part_.data(), part_.data() + part_.size() / 2, parts_together};
  const auto entries = static_cast<long>(plan_->free_.size());
  Eigen::VectorXcd h(n);
  for (long f = 0; f < count; ++f) {
    const double omega = omega_.data()[first + f];
    h = plan_->load_.at(omega).cwiseQuotient(plan_->scale_);
    plan_->part_.add(omega, z_part_, h);
    for (long k = 0; k < entries; ++k) {
      const FreeEntry& at = plan_->free_[static_cast<std::size_t>(k)];
      put(planes, k * parts_together + f, z_part_(at.row, at.column));
      z_part_(at.row, at.column) = z_part_(at.column, at.row) = 0;
    }
    for (Eigen::Index i = 0; i < n; ++i) put(planes, (entries + i) * parts_together + f, h(i));
  }
}

void SweepWorkspace::solve_blocks(bool every_backward_error, const Planes& q) {
  BlockBatch batch{omega_.data(), padded_, {}, {}, q, error_.data(), every_backward_error};
  if (!plan_->part_) {
    plan_->blocks_->solve(batch, blocks_);
    return;
  }
  const auto entries = static_cast<long>(plan_->free_.size());
  batch.count = parts_together;
  batch.free = {part_.data(), part_.data() + part_.size() / 2, parts_together};
  batch.load = {batch.free.re + entries * parts_together, batch.free.im + entries * parts_together, parts_together};
  for (long first = 0; first < padded_; first += parts_together) {
    fill_free(first, parts_together);
    batch.omega = omega_.data() + first;
    batch.response = {q.re + first, q.im + first, q.stride};
    batch.backward_error = error_.data() + first;
    plan_->blocks_->solve(batch, blocks_);
  }
  if (z_part_.isZero(0)) return;
  throw foundation::InvalidInput("part of the dynamic stiffness that depends on frequency: it adds to entries beside its coupled rows; it must name all rows that it couples");
}

Planes SweepWorkspace::solve(const double* omega, long count, bool every_backward_error, Planes target) {
  const long padded = padded_ = filled_up(count, sweep_kernels::granule);
  std::copy_n(omega, count, omega_.data());
  std::fill(omega_.data() + count, omega_.data() + padded, omega[count - 1]);
  const Planes q = target.re && padded == count ? target : planes_in(q_);
  if (plan_->solver() == SweepSolver::alone) {
    for (long f = 0; f < count; ++f) redo_alone(f, q);
    return q;
  }
  if (plan_->solver() == SweepSolver::blocks) {
    solve_blocks(every_backward_error, q);
    redo_missed({}, count, q);
    return q;
  }
  const int wanted = every_backward_error ? 2 : 1;
  if (load_filled_ < wanted || !plan_->load_.is_constant() || plan_->part_) fill_load(plan_->load_.is_constant() ? chunk : padded, every_backward_error);
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
    case SweepSolver::fixed: good = sweep_kernels::solve_fixed(*plan_->solved_, nullptr, batch); break;
    case SweepSolver::pivoted: good = sweep_kernels::solve_pivoted(*plan_->solved_, batch); break;
    case SweepSolver::blocks:
    case SweepSolver::alone: break;  // above
  }
  std::vector<char> untrusted;
  if (!good) {
    untrusted.resize(static_cast<std::size_t>(count));
    for (std::size_t f = 0; f < untrusted.size(); ++f) untrusted[f] = error_.data()[f] != 0;
  }
  if (!load_finite_) {
    // Growth knows nothing of the load: of a power of ω at rest.
    untrusted.resize(static_cast<std::size_t>(count));
    for (long f = 0; f < count; ++f)
      if (!load_at(f).allFinite()) untrusted[static_cast<std::size_t>(f)] = 1;
  }
  if (every_backward_error) {
    sweep_kernels::backward_errors(plain(), batch);
    redo_missed(untrusted, count, q);
  } else if (!untrusted.empty()) {
    redo(untrusted, q);
  }
  return q;
}

/// Redoes those that are marked and those whose backward error is not accepted.
void SweepWorkspace::redo_missed(std::vector<char> marked, long count, const Planes& q) {
  for (std::size_t f = 0; f < static_cast<std::size_t>(count); ++f)
    if (!(error_.data()[f] <= accepted_backward_error)) {
      marked.resize(static_cast<std::size_t>(count));
      marked[f] = 1;
    }
  if (!marked.empty()) redo(marked, q);
}

/// The marked frequencies by LU with partial pivoting in lanes, and what that does not settle one by one.
void SweepWorkspace::redo(const std::vector<char>& marked, const Planes& q) {
  std::vector<long> which;
  for (std::size_t f = 0; f < marked.size(); ++f)
    if (marked[f]) which.push_back(static_cast<long>(f));
  const auto n = static_cast<Eigen::Index>(plan_->size());
  const auto count = static_cast<long>(which.size());
  std::vector<char> settled(which.size());
  if (plan_->solver() != SweepSolver::pivoted) counts_.fallbacks += static_cast<int>(count);
  if (plan_->solver() != SweepSolver::pivoted && plan_->solver() != SweepSolver::blocks) {
    which.resize(static_cast<std::size_t>(filled_up(count, sweep_kernels::widest_pack)), which.back());
    const auto width = static_cast<long>(which.size());
    const Planes all_parts = plan_->part_ ? planes_in(part_) : Planes{};
    std::vector<double> omega(which.size()), error(which.size()), memory(2 * which.size() * static_cast<std::size_t>(2 * n + (plan_->part_ ? n * n : 0)));
    auto planes = [&, next = memory.data()](Eigen::Index entries) mutable {
      const Planes these{next, next + entries * width, width};
      next += 2 * entries * width;
      return these;
    };
    const Planes load = planes(n), solution = planes(n), part = plan_->part_ ? planes(n * n) : Planes{};
    for (long k = 0; k < width; ++k) {
      const long f = which[static_cast<std::size_t>(k)];
      omega[static_cast<std::size_t>(k)] = omega_.data()[f];
      const Eigen::VectorXcd h = load_at(f);
      for (Eigen::Index i = 0; i < n; ++i) put(load, i * width + k, h(i));
      for (Eigen::Index e = 0; e < n * n && part.re; ++e) put(part, e * width + k, {all_parts.re[e * chunk + f], all_parts.im[e * chunk + f]});
    }
    const sweep_kernels::Batch batch{omega.data(), width, load, part, plan_->scale_.data(), solution, error.data()};
    (void)sweep_kernels::solve_pivoted(plain(), batch);
    const std::vector<double> singular = error;
    sweep_kernels::backward_errors(plain(), batch);
    for (std::size_t k = 0; k < settled.size(); ++k) {
      settled[k] = singular[k] == 0 && error[k] <= accepted_backward_error;
      error_.data()[which[k]] = error[k];
      for (Eigen::Index i = 0; i < n; ++i)
        put(q, i * q.stride + which[k], {solution.re[i * width + static_cast<long>(k)], solution.im[i * width + static_cast<long>(k)]});
    }
  }
  for (std::size_t k = 0; k < settled.size(); ++k)
    if (!settled[k]) redo_alone(which[k], q);
  for (long f = static_cast<long>(marked.size()); f < padded_; ++f)
    for (Eigen::Index i = 0; i < n; ++i) {
      const long last = i * q.stride + static_cast<long>(marked.size()) - 1;
      put(q, i * q.stride + f, {q.re[last], q.im[last]});
    }
}

/// h of one frequency of the chunk in scaled coordinates.
Eigen::VectorXcd SweepWorkspace::load_at(long f) const {
  if (plan_->solver() == SweepSolver::aimed || plan_->solver() == SweepSolver::blocks || plan_->solver() == SweepSolver::alone)
    return plan_->load_.at(omega_.data()[f]);
  Eigen::VectorXcd h(plan_->size());
  const Planes load = planes_in(load_);
  for (Eigen::Index i = 0; i < h.size(); ++i) {
    h(i) = {load.re[i * chunk + f], load.im[i * chunk + f]};
  }
  return h;
}

/// One frequency with partial pivoting and one step of refinement; not a number if Z is singular.
void SweepWorkspace::redo_alone(long f, const Planes& q) {
  const auto n = static_cast<Eigen::Index>(plan_->size());
  Eigen::MatrixXcd z = plan_->blocks_ ? plan_->blocks_->scaled_matrix(omega_.data()[f]) : plan_->matrices_.at(omega_.data()[f]);
  const Planes part = plan_->part_ && !plan_->evaluates_part_alone() ? planes_in(part_) : Planes{};
  for (Eigen::Index i = 0; i < n && part.re; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const long at = (i * n + j) * chunk + f;
      z(i, j) += Complex(part.re[at], part.im[at]);
    }
  Eigen::VectorXcd h = load_at(f);
  if (plan_->evaluates_part_alone()) {
    Eigen::MatrixXcd z_part = Eigen::MatrixXcd::Zero(n, n);
    Eigen::VectorXcd h_part = Eigen::VectorXcd::Zero(n);
    plan_->part_.add(omega_.data()[f], z_part, h_part);
    z += plan_->scale_.asDiagonal() * z_part * plan_->scale_.asDiagonal();
    h += plan_->scale_.cwiseProduct(h_part);
  }
  const double norm = z.cwiseAbs().rowwise().sum().maxCoeff();
  const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(z);
  Eigen::VectorXcd x = lu.solve(h);
  x += lu.solve(h - z * x);
  double& error = error_.data()[f];
  if (!x.allFinite() || lu.matrixLU().diagonal().cwiseAbs().minCoeff() <= sweep_kernels::negligible_pivot(plan_->size()) * norm) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    x.setConstant({nan, nan});
    error = nan;
    ++counts_.singular;
  } else {
    const double possible = norm * x.cwiseAbs().maxCoeff() + h.cwiseAbs().maxCoeff();
    error = possible > 0 ? (h - z * x).cwiseAbs().maxCoeff() / possible : 0;
  }
  for (Eigen::Index i = 0; i < n; ++i) put(q, i * q.stride + f, plan_->scale_(i) * x(i));
}

}  // namespace trivet::numerics
