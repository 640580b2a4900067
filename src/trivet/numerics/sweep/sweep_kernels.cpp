// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/sweep/sweep_kernels.cpp"
#include <hwy/foreach_target.h>

#include <cassert>

#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/dense_solve-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

using sweep_kernels::Batch;
using sweep_kernels::Coefficients;

template <bool aimed>
bool fixed(const Coefficients& z, const sweep_kernels::Aim* aim, const Batch& batch) {
  assert(z.n >= 1 && z.n <= sweep_kernels::most_fixed && batch.count % sweep_kernels::granule == 0);
  assert(aimed == (aim != nullptr) && (!aimed || aim->order.size() == to_size(z.n)));
  switch (z.n) {
    case 1:
      return solve_all<1, aimed>(z, aim, batch);
    case 2:
      return solve_all<2, aimed>(z, aim, batch);
    case 3:
      return solve_all<3, aimed>(z, aim, batch);
    case 4:
      return solve_all<4, aimed>(z, aim, batch);
    case 5:
      return solve_all<5, aimed>(z, aim, batch);
    default:
      return solve_all<6, aimed>(z, aim, batch);
  }
}

bool solve_fixed(const Coefficients& z, const sweep_kernels::Aim* aim, const Batch& batch) {
  return aim ? fixed<true>(z, aim, batch) : fixed<false>(z, nullptr, batch);
}

bool solve_pivoted(const Coefficients& z, const Batch& batch) {
  PackArray lu(z.n * z.n), q(z.n);
  assert(batch.count % lane_count() == 0 && "batches are padded to whole packs");
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
  assert(batch.count % lane_count() == 0 && "batches are padded to whole packs");
  for (long at = 0; at < batch.count; at += lane_count())
    store_pack(backward_error(PackSystem(z, batch, at), q), batch.error + at);
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics::sweep_kernels {
namespace {

/// Σ |K − ω²A|² + |K_loss + ωB|² as a polynomial, shifted by a share of its terms.
void squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& K, const Eigen::MatrixXd& loss,
             double share, double* polynomial) {
  const double of_loss = loss.squaredNorm(), of_damping = B.squaredNorm();
  polynomial[0] = (1 + share) * (K.squaredNorm() + of_loss);
  polynomial[1] = 2 * B.cwiseProduct(loss).sum();
  polynomial[2] = (1 + share) * of_damping - 2 * K.cwiseProduct(A).sum();
  polynomial[3] = (1 + share) * A.squaredNorm();
}

}  // namespace

Coefficients::Coefficients(const DynamicMatrices& m) : n(static_cast<int>(m.size())) {
  const Eigen::Index size = m.size();
  const auto rows = [&](const Eigen::MatrixXd& x) {
    std::vector<double> all(to_size(size * size));
    for (Eigen::Index i = 0; i < size && x.size() > 0; ++i)
      for (Eigen::Index j = 0; j < size; ++j) all[i * size + j] = x(i, j);
    return all;
  };
  K = rows(m.K), A = rows(m.A), B = rows(m.B), K_loss = rows(m.K_loss);
  const Eigen::MatrixXd loss = m.lossy() ? m.K_loss : Eigen::MatrixXd::Zero(size, size);
  // If their terms cancel, round-off of these sums must not increase the first or decrease the second.
  constexpr double margin = 1e-12;
  squares(m.A, m.B, m.K, loss, -margin, norm);
  squares(m.A.col(0), m.B.col(0), m.K.col(0), loss.col(0), margin, first);
}

}  // namespace trivet::numerics::sweep_kernels

namespace trivet::numerics {

TRIVET_VARIANTS(solve_fixed);
TRIVET_VARIANTS(solve_pivoted);
TRIVET_VARIANTS(backward_errors);

namespace sweep_kernels {
bool solve_fixed(const Coefficients& z, const Aim* aim, const Batch& batch) {
  return TRIVET_DISPATCH(solve_fixed)(z, aim, batch);
}
bool solve_pivoted(const Coefficients& z, const Batch& batch) { return TRIVET_DISPATCH(solve_pivoted)(z, batch); }
void backward_errors(const Coefficients& z, const Batch& batch) { TRIVET_DISPATCH(backward_errors)(z, batch); }
}  // namespace sweep_kernels

}  // namespace trivet::numerics
#endif
