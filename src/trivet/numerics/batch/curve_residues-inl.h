// SPDX-License-Identifier: BSD-3-Clause
// Determines which curves the poles of a table give to nine digits: the load must move them by more than round-off, and
// their sums must not cancel.
#if defined(TRIVET_NUMERICS_CURVE_RESIDUES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_CURVE_RESIDUES_INL_H_
#undef TRIVET_NUMERICS_CURVE_RESIDUES_INL_H_
#else
#define TRIVET_NUMERICS_CURVE_RESIDUES_INL_H_
#endif

#include <cassert>

#include "trivet/numerics/batch/peak_request.h"
#include "trivet/numerics/batch/round_off-inl.h"
#include "trivet/numerics/batch/tabled_roots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Residues of a pack of designs, and scales for a curve: coordinate j is weighted by √A_jj.
struct PackOfResidues {
  PairPack r[most_pairs][most_pairs];              ///< [pair][coordinate]
  Pack unit[most_pairs];                           ///< 1/√A_jj
  Pack visible[most_pairs], possible[most_pairs];  ///< by pair of poles, see round_off-inl.h
};

template <typename Size>
HWY_INLINE void residues_in_table(Size n, const RootTable& table, int lane, const PolePairs& roots,
                                  PackOfResidues& residues) {
  Pack mass[Size::most], motion[Size::most], modulus[Size::most], by_modulus[Size::most], at_rest = hn::Zero(Lanes()),
                                                                                          accelerated = at_rest;
  each(n, [&](int j) TRIVET_LANES {
    mass[j] = from_table(table.mass[j], lane);
    residues.unit[j] = inverse_root(mass[j]);
  });
  each(n, [&](int k) TRIVET_LANES {
    motion[k] = hn::Zero(Lanes());
    each(n, [&](int j) TRIVET_LANES {
      residues.r[k][j] = {from_table(table.r_first[k][j], lane), from_table(table.r_second[k][j], lane)};
      motion[k] = hn::Max(motion[k], hn::Mul(squared_size(residues.r[k][j]), mass[j]));
    });
    const PairPack lambda = roots.lambda[k];
    modulus[k] = hn::IfThenElse(roots.real[k], hn::Abs(hn::Mul(lambda.first, lambda.second)), squared_size(lambda));
    by_modulus[k] = reciprocal(modulus[k]);
    at_rest = hn::Max(at_rest, hn::Mul(motion[k], by_modulus[k]));
    accelerated = hn::Max(accelerated, hn::Mul(motion[k], modulus[k]));
  });
  each(n, [&](int k) TRIVET_LANES {
    const Pack decay = roots.lambda[k].first;
    // Squares at the distance |Re λ| of the axis from pole k: |r_k|² itself, or (at rest) max_l |r_l|²/|λ_l|² (Re
    // λ_k)².
    residues.visible[k] = hn::Max(motion[k], hn::Mul(at_rest, hn::Mul(decay, decay)));
    residues.possible[k] = hn::Max(motion[k], hn::Mul(accelerated, by_modulus[k]));
  });
}

/// A row times the residues of one pair of poles; zeros of the row are skipped.
HWY_INLINE PairPack row_times(const Eigen::VectorXd& row, const PairPack* r) {
  assert(row.size() <= most_pairs);
  PairPack sum = {hn::Zero(Lanes()), hn::Zero(Lanes())};
  for (Eigen::Index j = 0; j < row.size(); ++j)
    if (row(j) != 0)
      sum = {hn::MulAdd(all(row(j)), r[j].first, sum.first), hn::MulAdd(all(row(j)), r[j].second, sum.second)};
  return sum;
}

/// Σ_j |row_j| / √A_jj
HWY_INLINE Pack weight_of(const Eigen::VectorXd& row, const Pack* unit) {
  Pack sum = hn::Zero(Lanes());
  for (Eigen::Index j = 0; j < row.size(); ++j)
    if (row(j) != 0) sum = hn::MulAdd(all(std::abs(row(j))), unit[j], sum);
  return sum;
}

/// Residues of one channel. @return lanes in which they are accurate
template <typename Size>
HWY_NOINLINE LaneMask residues_of(Size n, const PackOfResidues& residues, const PolePairs& poles,
                                  const ObservedRow& row, PairPack* r) {
  assert(row.on_displacement.size() == n && (row.on_velocity.size() == 0 || row.on_velocity.size() == n));
  const Pack plain = weight_of(row.on_displacement, residues.unit), of_rate = weight_of(row.on_velocity, residues.unit);
  Pack weight[most_pairs];
  for (int k = 0; k < n; ++k) {
    r[k] = row_times(row.on_displacement, residues.r[k]);
    weight[k] = plain;
    if (row.on_velocity.size() > 0) {
      const PairPack lambda = poles.lambda[k],
                     turned = times(poles.real[k], lambda, row_times(row.on_velocity, residues.r[k]));
      r[k] = {hn::Add(r[k].first, turned.first), hn::Add(r[k].second, turned.second)};
      weight[k] = hn::MulAdd(hn::Add(hn::Abs(lambda.first), hn::Abs(lambda.second)), of_rate, plain);
    }
    weight[k] = hn::Mul(weight[k], weight[k]);
  }
  return drop_round_off(n, hn::Eq(plain, plain), residues.visible, residues.possible, weight, r);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
