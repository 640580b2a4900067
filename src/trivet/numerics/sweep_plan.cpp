// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep_plan.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/pivoted_solution.h"

namespace trivet::numerics {
namespace {

using sweep_kernels::Planes;

/// Coordinates from which on blocks are the faster way, measured with AVX-512: two bodies take 0.11 µs in a chain and 0.13 µs coupled in full, as by loops over
/// all. Beyond that blocks win on chains and trees by the number of bodies, and lose nothing where all is coupled.
constexpr Eigen::Index fewest_for_blocks = 13;

/// Coordinates up to which the parts that depend on ω are kept for a whole chunk, some ten megabytes.
constexpr Eigen::Index most_with_part = 48;

long filled_up(long count, long granule) { return (count + granule - 1) / granule * granule; }

std::size_t numbers(long planes) { return static_cast<std::size_t>(2 * planes * SweepWorkspace::chunk); }

/// Planes of a chunk: real parts first, then imaginary parts.
Planes planes_in(const ChunkMemory& memory) { return {memory.data(), memory.data() + memory.size() / 2, SweepWorkspace::chunk}; }

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

}  // namespace

SweepPlan::SweepPlan(const DynamicMatrices& matrices, const Load& load, FrequencyPart part)
    : scale_(unit_scale(matrices)), matrices_(scaled(matrices, scale_)), load_(load.scaled(scale_)), part_(std::move(part)) {
  choose_solver(matrices, load);
  if (!solved_) solved_.emplace(matrices_);
}

void SweepPlan::choose_solver(const DynamicMatrices& given, const Load& given_load) {
  if (part_ && matrices_.size() > most_with_part) {
    solver_ = SweepSolver::alone;
    return;
  }
  if (!matrices_.symmetric) return;
  solver_ = SweepSolver::symmetric;
  if (part_) return;
  if (matrices_.size() >= fewest_for_blocks) {
    blocks_.emplace(given, given_load);
    solver_ = SweepSolver::blocks;
    return;
  }
  if (matrices_.size() > sweep_kernels::most_fixed) return;
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

void ChunkMemory::resize(std::size_t size) {
  if (size == size_) return;
  numbers_.reset(size > 0 ? new (line) double[size] : nullptr);
  size_ = size;
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
  for (ChunkMemory* one : {&omega_, &error_}) one->resize(chunk);
  for (ChunkMemory* each : {&load_, &q_}) each->resize(numbers(plan.size()));
  amplitude_.resize(plan.solver() == SweepSolver::aimed ? numbers(1) : 0);
  part_.resize(plan.part_ && plan.solver() != SweepSolver::alone ? numbers(long{plan.size()} * plan.size()) : 0);
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
      plan_->part_(omega, z, h);
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      load.re[i * chunk + f] += plan_->scale_(i) * h(i).real();
      load.im[i * chunk + f] += plan_->scale_(i) * h(i).imag();
      for (Eigen::Index j = 0; j < n; ++j) put(part, (i * n + j) * chunk + f, plan_->scale_(i) * z(i, j) * plan_->scale_(j));
    }
  }
}

Planes SweepWorkspace::solve(const double* omega, long count, bool every_backward_error, Planes target) {
  const long padded = padded_ = filled_up(count, sweep_kernels::granule);
  std::copy_n(omega, count, omega_.data());
  std::fill(omega_.data() + count, omega_.data() + padded, omega[count - 1]);
  const int wanted = every_backward_error ? 2 : 1;
  if (load_filled_ < wanted || !plan_->load_.is_constant() || plan_->part_) fill_load(plan_->load_.is_constant() ? chunk : padded, every_backward_error);
  load_filled_ = wanted;
  const Planes q = target.re && padded == count ? target : planes_in(q_);
  if (plan_->solver() == SweepSolver::alone) {
    for (long f = 0; f < count; ++f) redo_alone(f, q);
    return q;
  }
  if (plan_->part_) fill_parts(padded);
  const Planes part = plan_->part_ ? planes_in(part_) : Planes{};
  sweep_kernels::Batch batch{omega_.data(), padded, planes_in(load_), part, plan_->scale_.data(), q, error_.data()};
  std::fill_n(error_.data(), padded, 0.0);
  bool good = false, measured = false;  // measured: error_ holds backward errors, not marks
  switch (plan_->solver()) {
    case SweepSolver::aimed: {
      sweep_kernels::Batch aimed = batch;
      aimed.load = planes_in(amplitude_);
      good = sweep_kernels::solve_fixed(*plan_->solved_, &plan_->aim_, aimed);
      break;
    }
    case SweepSolver::fixed: good = sweep_kernels::solve_fixed(*plan_->solved_, nullptr, batch); break;
    case SweepSolver::blocks:
      plan_->blocks_->solve({omega_.data(), padded, {}, {}, {q.re, q.im, q.stride}, error_.data(), every_backward_error});
      measured = good = true;
      break;
    case SweepSolver::symmetric: good = sweep_kernels::solve_symmetric(*plan_->solved_, batch); break;
    case SweepSolver::pivoted: good = sweep_kernels::solve_pivoted(*plan_->solved_, batch); break;
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
  if (every_backward_error || measured) {
    if (!measured) sweep_kernels::backward_errors(plain(), batch);
    for (std::size_t f = 0; f < static_cast<std::size_t>(count); ++f)
      if (!(error_.data()[f] <= accepted_backward_error)) {
        untrusted.resize(static_cast<std::size_t>(count));
        untrusted[f] = 1;
      }
  }
  if (!untrusted.empty()) redo(untrusted, q, padded);
  return q;
}

/// The marked frequencies by LU with partial pivoting in lanes, and what that does not settle one by one.
void SweepWorkspace::redo(const std::vector<char>& marked, const Planes& q, long padded) {
  std::vector<long> which;
  for (std::size_t f = 0; f < marked.size(); ++f)
    if (marked[f]) which.push_back(static_cast<long>(f));
  const auto n = static_cast<Eigen::Index>(plan_->size());
  const auto count = static_cast<long>(which.size());
  std::vector<char> settled(which.size());
  if (plan_->solver() != SweepSolver::pivoted) {
    counts_.fallbacks += static_cast<int>(count);
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
  for (long f = static_cast<long>(marked.size()); f < padded; ++f)
    for (Eigen::Index i = 0; i < n; ++i) {
      const long last = i * q.stride + static_cast<long>(marked.size()) - 1;
      put(q, i * q.stride + f, {q.re[last], q.im[last]});
    }
}

/// h of one frequency of the chunk in scaled coordinates.
Eigen::VectorXcd SweepWorkspace::load_at(long f) const {
  if (plan_->solver() == SweepSolver::aimed) return plan_->load_.at(omega_.data()[f]);
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
  Eigen::MatrixXcd z = plan_->matrices_.at(omega_.data()[f]);
  const bool alone = plan_->solver() == SweepSolver::alone;
  const Planes part = plan_->part_ && !alone ? planes_in(part_) : Planes{};
  for (Eigen::Index i = 0; i < n && part.re; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const long at = (i * n + j) * chunk + f;
      z(i, j) += Complex(part.re[at], part.im[at]);
    }
  Eigen::VectorXcd h = load_at(f);
  if (alone) {
    Eigen::MatrixXcd z_part = Eigen::MatrixXcd::Zero(n, n);
    Eigen::VectorXcd h_part = Eigen::VectorXcd::Zero(n);
    plan_->part_(omega_.data()[f], z_part, h_part);
    z += plan_->scale_.asDiagonal() * z_part * plan_->scale_.asDiagonal();
    h += plan_->scale_.cwiseProduct(h_part);
  }
  const PivotedSolution solution = pivoted_solution(z, h);
  error_.data()[f] = solution.backward_error;
  if (std::isnan(solution.backward_error)) ++counts_.singular;
  for (Eigen::Index i = 0; i < n; ++i) put(q, i * q.stride + f, plan_->scale_(i) * solution.x(i));
}

}  // namespace trivet::numerics
