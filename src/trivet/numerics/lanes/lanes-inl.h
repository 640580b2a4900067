// SPDX-License-Identifier: BSD-3-Clause
// Vectors of doubles, one number of one frequency or one design per lane, for kernels that are compiled once for each
// instruction set (docs/decisions/lanes.md). Include after hwy/foreach_target.h only; the usual guard toggles from
// target to target.
#if defined(TRIVET_NUMERICS_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_LANES_INL_H_
#undef TRIVET_NUMERICS_LANES_INL_H_
#else
#define TRIVET_NUMERICS_LANES_INL_H_
#endif

#include <hwy/highway.h>

// Attributes of a lambda in a kernel, placed after its parameters.
#undef TRIVET_LANES
#define TRIVET_LANES __attribute__((always_inline)) HWY_ATTR

// Unrolls the next loop in optimised builds; the instrumented build keeps loops, because unrolling them takes minutes
// to compile.
#undef TRIVET_UNROLL
#ifdef NDEBUG
#define TRIVET_UNROLL _Pragma("GCC unroll 8")
#else
#define TRIVET_UNROLL
#endif

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;
using Pack = hn::Vec<Lanes>;
using LaneMask = hn::Mask<Lanes>;

HWY_INLINE Pack all(double value) { return hn::Set(Lanes(), value); }
HWY_INLINE int lane_count() { return static_cast<int>(hn::Lanes(Lanes())); }

/// One complex number per lane.
struct ComplexPack {
  Pack re, im;
};

HWY_INLINE ComplexPack operator+(const ComplexPack& a, const ComplexPack& b) {
  return {hn::Add(a.re, b.re), hn::Add(a.im, b.im)};
}
HWY_INLINE ComplexPack operator-(const ComplexPack& a, const ComplexPack& b) {
  return {hn::Sub(a.re, b.re), hn::Sub(a.im, b.im)};
}
HWY_INLINE ComplexPack operator*(const ComplexPack& a, const ComplexPack& b) {
  return {hn::NegMulAdd(a.im, b.im, hn::Mul(a.re, b.re)), hn::MulAdd(a.re, b.im, hn::Mul(a.im, b.re))};
}
HWY_INLINE ComplexPack operator*(const Pack& a, const ComplexPack& b) { return {hn::Mul(a, b.re), hn::Mul(a, b.im)}; }

/// target + a b
HWY_INLINE ComplexPack add_product(const ComplexPack& target, const ComplexPack& a, const ComplexPack& b) {
  return {hn::NegMulAdd(a.im, b.im, hn::MulAdd(a.re, b.re, target.re)),
          hn::MulAdd(a.im, b.re, hn::MulAdd(a.re, b.im, target.im))};
}
/// target − a b
HWY_INLINE ComplexPack subtract_product(const ComplexPack& target, const ComplexPack& a, const ComplexPack& b) {
  return {hn::MulAdd(a.im, b.im, hn::NegMulAdd(a.re, b.re, target.re)),
          hn::NegMulAdd(a.im, b.re, hn::NegMulAdd(a.re, b.im, target.im))};
}
/// target − a b with real a
HWY_INLINE ComplexPack subtract_product(const ComplexPack& target, const Pack& a, const ComplexPack& b) {
  return {hn::NegMulAdd(a, b.re, target.re), hn::NegMulAdd(a, b.im, target.im)};
}
HWY_INLINE Pack squared_modulus(const ComplexPack& z) { return hn::MulAdd(z.re, z.re, hn::Mul(z.im, z.im)); }
/// |re| + |im|: the modulus within √2
HWY_INLINE Pack one_norm(const ComplexPack& z) { return hn::Add(hn::Abs(z.re), hn::Abs(z.im)); }
HWY_INLINE ComplexPack inverse(const ComplexPack& z) {
  const Pack scale = hn::Div(all(1.0), squared_modulus(z));
  return {hn::Mul(z.re, scale), hn::Neg(hn::Mul(z.im, scale))};
}

/// A number of coordinates or an index: a compile-time constant, or a value with an upper limit.
template <int N>
struct Fixed {
  static constexpr int most = N;
  constexpr operator int() const { return N; }  // NOLINT: it is that number
};
template <int N>
struct AtMost {
  static constexpr int most = N;
  int value;
  constexpr operator int() const { return value; }  // NOLINT
};
using AtMostTwelve = AtMost<12>;
/// Six coordinates, a compile-time constant in optimised builds. The instrumented build keeps its loops, because
/// unrolling them takes minutes to compile.
constexpr auto six_coordinates() {
#ifdef NDEBUG
  return Fixed<6>();
#else
  return AtMostTwelve{6};
#endif
}
template <int N>
constexpr Fixed<N + 1> after(Fixed<N>) {
  return {};
}
constexpr int after(int i) { return i + 1; }

/// body(i) for i = first … last − 1; unrolled if both are compile-time constants.
template <int first, int last, typename Body>
HWY_INLINE void each(Fixed<first> i, Fixed<last> end, const Body& body) {
  if constexpr (first < last) {
    body(i);
    each(after(i), end, body);
  }
}
template <typename Body>
HWY_INLINE void each(int first, int last, const Body& body) {
  for (int i = first; i < last; ++i) body(i);
}
template <typename Size, typename Body>
HWY_INLINE void each(Size n, const Body& body) {
  each(Fixed<0>(), n, body);
}

/// Position of entry (i, j), j ≤ i, of a symmetric matrix in its packed lower triangle.
constexpr int packed(int i, int j) { return i * (i + 1) / 2 + j; }
/// The same for any order of i and j.
constexpr int packed_of(int i, int j) { return i > j ? packed(i, j) : packed(j, i); }

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
