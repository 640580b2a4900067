// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/sweep/pole_kernels.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/numerics/roots/poles-inl.h"
#include "trivet/numerics/sweep/pole_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

HWY_INLINE Pack some(const double* from, Eigen::Index count) {
  if (count >= lane_count()) return hn::LoadU(Lanes(), from);
  HWY_ALIGN double buffer[8];
  for (Eigen::Index lane = 0; lane < lane_count(); ++lane) buffer[lane] = from[std::min(lane, count - 1)];
  return hn::Load(Lanes(), buffer);
}

HWY_INLINE void store(const Pack& value, double* to, Eigen::Index count) {
  if (count >= lane_count()) return hn::StoreU(value, Lanes(), to);
  HWY_ALIGN double buffer[8];
  hn::Store(value, Lanes(), buffer);
  std::copy(buffer, buffer + count, to);
}

template <typename Size>
void roots_of_size(Size n, RootsOfSystem& s) {
  constexpr double settled = 1e-10;
  s.converged = true;
  for (int first = 0; first < n; first += lane_count()) {
    const Eigen::Index count = n - first;
    Pencil<Size> m[1];
    Root<Size> at[1];
    m[0].centre = some(s.centre + first, count);
    for (int i = 0; i < n; ++i) {
      m[0].below[i] = some(s.below[i] + first, count);
      m[0].above[i] = some(s.above[i] + first, count);
    }
    for (int entry = 0; entry < n * (n + 1) / 2; ++entry) m[0].b[entry] = some(s.b[entry] + first, count);
    at[0].offset = {some(s.offset_re + first, count), some(s.offset_im + first, count)};
    s.converged = hn::AllTrue(Lanes(), converge(n, m, at, settled)) && s.converged;
    store(at[0].offset.re, s.offset_re + first, count);
    store(at[0].offset.im, s.offset_im + first, count);
    store(at[0].slope.re, s.slope_re + first, count);
    store(at[0].slope.im, s.slope_im + first, count);
    for (int i = 0; i < n; ++i) {
      store(at[0].v[i].re, s.v_re[i] + first, count);
      store(at[0].v[i].im, s.v_im[i] + first, count);
    }
  }
}

void roots_in_lanes(RootsOfSystem& s) {
  s.n == 6 ? roots_of_size(six_coordinates(), s) : roots_of_size(AtMostTwelve{s.n}, s);
}

/// Number of frequencies before the first one that starts a cache line in every row of the results; −1 if the rows
/// differ.
inline Eigen::Index before_first_line(const PairsAtFrequencies& s) {
  constexpr std::uintptr_t line = 64;
  const auto off = [](const double* p) { return reinterpret_cast<std::uintptr_t>(p) % line; };
  if (s.stride % 8 != 0 || (s.im && off(s.im) != off(s.re)) || off(s.re) % sizeof(double) != 0) return -1;
  return to_index((line - off(s.re)) % line / sizeof(double));
}

/// Whether results are too many for the caches and bypass them in whole lines: else each line is read before it is
/// written.
inline bool goes_past_caches(const PairsAtFrequencies& s) {
  constexpr Eigen::Index most = 4'000'000;  // numbers
  return lane_count() == 8 && s.count * s.n * 2 > most && before_first_line(s) >= 0;
}

/// Needs at least as many frequencies as lanes; if they do not fill the last pack, it repeats some of the previous
/// pack.
template <bool complex_load, typename Size>
void pairs_of_size(Size n, const PairsAtFrequencies& s) {
  const int numbers = complex_load ? 4 * n + 3 : 2 * n + 3;
  const double* const pairs = s.pairs;
  const bool past_caches = goes_past_caches(s);
  const Eigen::Index first_line = past_caches ? before_first_line(s) : 0;
  for (Eigen::Index next = 0; next < s.count; next = next < first_line ? first_line : next + lane_count()) {
    const Eigen::Index f = std::min<Eigen::Index>(next, s.count - lane_count());
    const auto put = [&](const Pack& value, double* to) TRIVET_LANES {
      if (past_caches && f == next && f >= first_line) hn::Stream(value, Lanes(), to);
      else hn::StoreU(value, Lanes(), to);
    };
    const Pack p = hn::LoadU(Lanes(), s.omega + f);
    ComplexPack g[Size::most];  // conjugate of 1/((ω_k² − p²) + ip d)
    each(n, [&](int k) TRIVET_LANES {
      const double* pair = pairs + k * numbers;
      const Pack omega = all(pair[0]);
      const ComplexPack z = {hn::Mul(hn::Add(hn::Sub(omega, p), all(pair[1])), hn::Add(omega, p)),
                             hn::Mul(all(pair[2]), p)};
      g[k] = reciprocal(squared_modulus(z)) * z;
    });
    each(n, [&](int j) TRIVET_LANES {
      const auto sum = [&](int from) TRIVET_LANES {  // Σ (c0 + ip c1) g
        ComplexPack constant = zero(), rate = zero();
        each(n, [&](int k) TRIVET_LANES {
          constant = add_product(constant, all(pairs[k * numbers + from + j]), g[k]);
          rate = add_product(rate, all(pairs[k * numbers + from + n + j]), g[k]);
        });
        return ComplexPack{hn::MulAdd(p, rate.im, constant.re), hn::MulSub(p, rate.re, constant.im)};
      };
      ComplexPack q = sum(3);
      if constexpr (complex_load) {
        const ComplexPack imaginary = sum(3 + 2 * n);
        q = q + ComplexPack{hn::Neg(imaginary.im), imaginary.re};
      }
      put(q.re, s.re + j * s.stride + f);
      put(q.im, s.im + j * s.stride + f);
    });
  }
  if (past_caches) hwy::FlushStream();
}

template <typename Size>
void pairs_of(Size n, const PairsAtFrequencies& s, bool complex_load) {
  complex_load ? pairs_of_size<true>(n, s) : pairs_of_size<false>(n, s);
}

void pairs_in_lanes(const PairsAtFrequencies& s, bool complex_load) {
  s.n == 6 ? pairs_of(six_coordinates(), s, complex_load) : pairs_of(AtMostTwelve{s.n}, s, complex_load);
}

double error_in_lanes(const EquationAtFrequencies& s) {
  const int n = s.n;
  Pack worst = all(0.0);
  for (Eigen::Index f = 0; f < s.count; f += lane_count()) {
    const Pack p = some(s.omega + f, s.count - f), square = hn::Mul(p, p), rest = hn::MulSub(p, p, square);
    ComplexPack q[12];
    Pack size = all(0.0), residual = size, norm = size, load = size;
    for (int j = 0; j < n; ++j) {
      q[j] = all(s.by_scale[j]) *
          ComplexPack{some(s.re + j * s.stride + f, s.count - f), some(s.im + j * s.stride + f, s.count - f)};
      size = hn::Max(size, one_norm(q[j]));
    }
    for (int i = 0; i < n; ++i) {
      ComplexPack r = {all(s.load_re[i]), all(s.load_im[i])};
      load = hn::Max(load, one_norm(r));
      Pack row = all(0.0);
      for (int j = 0; j < n; ++j) {
        const Pack a = all(s.A[i * n + j]),
                   re = hn::NegMulAdd(rest, a,
                                      hn::NegMulAdd(square, a, all(s.K[i * n + j])));  // fused: accurate if it cancels
        const ComplexPack z = {re, hn::Mul(p, all(s.B[i * n + j]))};
        row = hn::Add(row, one_norm(z));
        r = subtract_product(r, z, q[j]);
      }
      norm = hn::Max(norm, row);
      residual = hn::Max(residual, one_norm(r));
    }
    const Pack error = hn::Div(residual, hn::MulAdd(norm, size, load));
    worst = hn::Max(worst, error);
    // Max may lose NaN.
    if (!hn::AllTrue(Lanes(),
                     hn::And(hn::Lt(size, all(std::numeric_limits<double>::infinity())), hn::Le(error, worst))))
      return std::numeric_limits<double>::infinity();
  }
  return hn::GetLane(hn::MaxOfLanes(Lanes(), worst));
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {

TRIVET_VARIANTS(roots_in_lanes);
TRIVET_VARIANTS(pairs_in_lanes);
TRIVET_VARIANTS(error_in_lanes);

void roots_of_system(RootsOfSystem& system) { TRIVET_DISPATCH(roots_in_lanes)(system); }
void pairs_at(const PairsAtFrequencies& sums, bool complex_load) {
  TRIVET_DISPATCH(pairs_in_lanes)(sums, complex_load);
}
double worst_backward_error(const EquationAtFrequencies& equation) { return TRIVET_DISPATCH(error_in_lanes)(equation); }

}  // namespace trivet::numerics
#endif
