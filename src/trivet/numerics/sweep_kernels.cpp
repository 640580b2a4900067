// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/sweep_kernels.cpp"
#include <hwy/foreach_target.h>

#include "trivet/numerics/dense_solve-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

using sweep_kernels::Batch;
using sweep_kernels::Coefficients;

template <bool aimed>
bool fixed(const Coefficients& z, const sweep_kernels::Aim* aim, const Batch& batch) {
  switch (z.n) {
    case 1: return solve_all<1, aimed>(z, aim, batch);
    case 2: return solve_all<2, aimed>(z, aim, batch);
    case 3: return solve_all<3, aimed>(z, aim, batch);
    case 4: return solve_all<4, aimed>(z, aim, batch);
    case 5: return solve_all<5, aimed>(z, aim, batch);
    default: return solve_all<6, aimed>(z, aim, batch);
  }
}

bool solve_fixed(const Coefficients& z, const sweep_kernels::Aim* aim, const Batch& batch) {
  return aim ? fixed<true>(z, aim, batch) : fixed<false>(z, nullptr, batch);
}

bool solve_symmetric(const Coefficients& z, const Batch& batch) {
  PackArray l(z.n * z.n), u(z.n * z.n), q(z.n);
  bool all_good = true;
  for (long at = 0; at < batch.count; at += lane_count()) {
    const LaneMask good = solve_symmetric_pack(PackSystem(z, batch, at), l, u, q);
    store_pack(hn::IfThenZeroElse(good, all(1.0)), batch.error + at);
    all_good = all_good && hn::AllTrue(Lanes(), good);
  }
  return all_good;
}

bool solve_pivoted(const Coefficients& z, const Batch& batch) {
  PackArray lu(z.n * z.n), q(z.n);
  bool all_good = true;
  for (long at = 0; at < batch.count; at += lane_count()) {
    const LaneMask good = solve_pivoted_pack(PackSystem(z, batch, at), lu, q);
    store_pack(hn::IfThenZeroElse(good, all(1.0)), batch.error + at);
    all_good = all_good && hn::AllTrue(Lanes(), good);
  }
  return all_good;
}

void backward_errors(const Coefficients& z, const Batch& batch) {
  PackArray q(z.n);
  for (long at = 0; at < batch.count; at += lane_count()) store_pack(backward_error(PackSystem(z, batch, at), q), batch.error + at);
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/dispatch.h"

namespace trivet::numerics::sweep_kernels {

Coefficients::Coefficients(const DynamicMatrices& m) : n(static_cast<int>(m.size())) {
  const Eigen::Index size = m.size();
  const auto rows = [&](const Eigen::MatrixXd& x) {
    std::vector<double> all(static_cast<std::size_t>(size * size));
    for (Eigen::Index i = 0; i < size && x.size() > 0; ++i)
      for (Eigen::Index j = 0; j < size; ++j) all[static_cast<std::size_t>(i * size + j)] = x(i, j);
    return all;
  };
  K = rows(m.K), A = rows(m.A), B = rows(m.B), K_loss = rows(m.K_loss);
  // Round-off of the sum, where its terms cancel, must not enlarge it.
  constexpr double kept = 1 - 1e-12, margin = 1e-12;
  const Eigen::MatrixXd loss = m.lossy() ? m.K_loss : Eigen::MatrixXd::Zero(size, size);
  const double kk = m.K.squaredNorm() + loss.squaredNorm(), aa = m.A.squaredNorm(), bb = m.B.squaredNorm();
  norm[0] = kept * kk;
  norm[1] = 2 * m.B.cwiseProduct(loss).sum();
  norm[2] = bb - 2 * m.K.cwiseProduct(m.A).sum() - margin * bb;
  norm[3] = kept * aa;
}

}  // namespace trivet::numerics::sweep_kernels

namespace trivet::numerics {

TRIVET_VARIANTS(solve_fixed);
TRIVET_VARIANTS(solve_symmetric);
TRIVET_VARIANTS(solve_pivoted);
TRIVET_VARIANTS(backward_errors);

namespace sweep_kernels {
bool solve_fixed(const Coefficients& z, const Aim* aim, const Batch& batch) { return TRIVET_DISPATCH(solve_fixed)(z, aim, batch); }
bool solve_symmetric(const Coefficients& z, const Batch& batch) { return TRIVET_DISPATCH(solve_symmetric)(z, batch); }
bool solve_pivoted(const Coefficients& z, const Batch& batch) { return TRIVET_DISPATCH(solve_pivoted)(z, batch); }
void backward_errors(const Coefficients& z, const Batch& batch) { TRIVET_DISPATCH(backward_errors)(z, batch); }
}  // namespace sweep_kernels

}  // namespace trivet::numerics
#endif
