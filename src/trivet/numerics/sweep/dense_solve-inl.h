// SPDX-License-Identifier: BSD-3-Clause
// Dense complex systems of any size, one frequency per lane: LU with partial pivoting by masks, residuals.
// Include after hwy/foreach_target.h only.
#if defined(TRIVET_NUMERICS_DENSE_SOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_DENSE_SOLVE_INL_H_
#undef TRIVET_NUMERICS_DENSE_SOLVE_INL_H_
#else
#define TRIVET_NUMERICS_DENSE_SOLVE_INL_H_
#endif

#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/symmetric_solve-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Complex packs in memory, by index.
class PackArray {
 public:
  explicit PackArray(int count) : numbers_(to_size(count) * 16) {}
  HWY_INLINE ComplexPack operator[](int i) const {
    return {load_pack(&numbers_[at(i)]), load_pack(&numbers_[at(i) + 8])};
  }
  HWY_INLINE void set(int i, const ComplexPack& z) {
    store_pack(z.re, &numbers_[at(i)]);
    store_pack(z.im, &numbers_[at(i) + 8]);
  }

 private:
  static std::size_t at(int i) { return to_size(i) * 16; }
  std::vector<double> numbers_;
};

/// Z at one pack of frequencies.
struct PackSystem {
  const sweep_kernels::Coefficients& z;
  const sweep_kernels::Batch& batch;
  long at;
  Pack omega, square;

  HWY_INLINE PackSystem(const sweep_kernels::Coefficients& coefficients, const sweep_kernels::Batch& given, long first)
      : z(coefficients),
        batch(given),
        at(first),
        omega(load_pack(given.omega + first)),
        square(hn::Mul(omega, omega)) {}

  HWY_INLINE ComplexPack entry(int i, int j) const {
    const auto here = to_size(i * z.n + j);
    ComplexPack value{hn::NegMulAdd(square, all(z.A[here]), all(z.K[here])),
                      hn::MulAdd(omega, all(z.B[here]), all(z.K_loss[here]))};
    if (batch.extra.re) value = value + load_pack(batch.extra, (i * z.n + j) * batch.extra.stride + at);
    return value;
  }
  HWY_INLINE ComplexPack load(int i) const { return load_pack(batch.load, i * batch.load.stride + at); }
  HWY_INLINE void store(int i, const ComplexPack& q) const {
    store_pack(all(batch.scale[i]) * q, batch.q, i * batch.q.stride + at);
  }
};

/// Exchanges entries a and b in the lanes of a mask.
HWY_INLINE void exchange(const LaneMask& where, PackArray& array, int a, int b) {
  const ComplexPack x = array[a], y = array[b];
  array.set(a, {hn::IfThenElse(where, y.re, x.re), hn::IfThenElse(where, y.im, x.im)});
  array.set(b, {hn::IfThenElse(where, x.re, y.re), hn::IfThenElse(where, x.im, y.im)});
}

/// In each lane separately, moves the row with the largest |re| + |im| in column j up to row j by successive exchanges.
/// Returns that largest value.
HWY_INLINE Pack bring_up_pivot(PackArray& z, PackArray& q, int n, int j) {
  Pack largest = one_norm(z[j * n + j]);
  for (int i = j + 1; i < n; ++i) {
    const Pack size = one_norm(z[i * n + j]);
    const LaneMask larger = hn::Gt(size, largest);
    if (hn::AllFalse(Lanes(), larger)) continue;
    largest = hn::IfThenElse(larger, size, largest);
    for (int k = j; k < n; ++k) exchange(larger, z, j * n + k, i * n + k);
    exchange(larger, q, j, i);
  }
  return largest;
}

HWY_INLINE LaneMask solve_pivoted_pack(const PackSystem& s, PackArray& z, PackArray& q) {
  const int n = s.z.n;
  Pack norm = hn::Zero(Lanes());
  for (int i = 0; i < n; ++i) {
    Pack row = hn::Zero(Lanes());
    for (int j = 0; j < n; ++j) {
      const ComplexPack x = s.entry(i, j);
      row = hn::Add(row, one_norm(x));
      z.set(i * n + j, x);
    }
    norm = hn::Max(norm, row);
    q.set(i, s.load(i));
  }
  Pack smallest = norm;
  for (int j = 0; j < n; ++j) {
    smallest = hn::Min(smallest, bring_up_pivot(z, q, n, j));
    const ComplexPack by = inverse(z[j * n + j]);
    z.set(j * n + j, by);
    for (int i = j + 1; i < n; ++i) {
      const ComplexPack factor = z[i * n + j] * by;
      for (int k = j + 1; k < n; ++k) z.set(i * n + k, subtract_product(z[i * n + k], factor, z[j * n + k]));
      q.set(i, subtract_product(q[i], factor, q[j]));
    }
  }
  for (int i = n - 1; i >= 0; --i) {
    ComplexPack x = q[i];
    for (int k = i + 1; k < n; ++k) x = subtract_product(x, z[i * n + k], q[k]);
    x = x * z[i * n + i];
    q.set(i, x);
    s.store(i, x);
  }
  return hn::Gt(smallest, hn::Mul(all(negligible_pivot(n)), norm));
}

HWY_INLINE Pack backward_error(const PackSystem& s, PackArray& q) {
  const int n = s.z.n;
  Pack residual = hn::Zero(Lanes()), norm = residual, size = residual, load = residual,
       nothing = residual;  // Max may lose NaN
  for (int i = 0; i < n; ++i) {
    q.set(i, all(1 / s.batch.scale[i]) * load_pack(s.batch.q, i * s.batch.q.stride + s.at));
    size = hn::Max(size, one_norm(q[i]));
  }
  for (int i = 0; i < n; ++i) {
    ComplexPack r = s.load(i);
    load = hn::Max(load, one_norm(r));
    Pack row = hn::Zero(Lanes());
    for (int j = 0; j < n; ++j) {
      const ComplexPack x = s.entry(i, j);
      row = hn::Add(row, one_norm(x));
      r = subtract_product(r, x, q[j]);
    }
    norm = hn::Max(norm, row);
    residual = hn::Max(residual, one_norm(r));
    nothing = hn::MulAdd(hn::Zero(Lanes()), one_norm(r), nothing);
  }
  const Pack possible = hn::MulAdd(norm, size, load);
  return hn::Add(nothing, hn::IfThenElse(hn::Gt(possible, hn::Zero(Lanes())), hn::Div(residual, possible), residual));
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
