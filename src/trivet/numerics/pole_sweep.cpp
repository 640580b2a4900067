// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/pole_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/numerics/pole_sweep.h"
#include "trivet/numerics/poles-inl.h"

#ifndef TRIVET_NUMERICS_POLE_SWEEP_ONCE
#define TRIVET_NUMERICS_POLE_SWEEP_ONCE
namespace trivet::numerics {

/// What one system needs of its modes for its roots: a root per lane, each in its own order of the modes, its own last.
struct RootsOfSystem {
  int n = 0;
  double centre[12], below[12][12], above[12][12];   ///< by root: i centre + offset; centre ∓ Ω of each mode
  double b[78][12];                                  ///< entry, root
  double offset_re[12], offset_im[12];               ///< where they start, and end
  double v_re[12][12], v_im[12][12];                 ///< mode, root
  double slope_re[12], slope_im[12];
  bool converged = false;
};

/// Real numbers of pairs of poles at some frequencies; `stride` from one coordinate to the next in re and im.
struct PairsAtFrequencies {
  int n = 0;
  const double* pairs = nullptr;
  const double* omega = nullptr;
  Eigen::Index count = 0;
  double *re = nullptr, *im = nullptr;  ///< without im: |q|²
  Eigen::Index stride = 0;
};

/// Z q = h of one system at some frequencies.
struct EquationAtFrequencies {
  int n = 0;
  const double *A = nullptr, *B = nullptr, *K = nullptr, *by_scale = nullptr, *load_re = nullptr, *load_im = nullptr;
  const double *omega = nullptr, *re = nullptr, *im = nullptr;
  Eigen::Index count = 0, stride = 0;
};

}  // namespace trivet::numerics
#endif

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
    s.converged = hn::AllTrue(Lanes(), converge(n, m, at)) && s.converged;
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

void roots_of_system(RootsOfSystem& s) { s.n == 6 ? roots_of_size(six_coordinates(), s) : roots_of_size(AtMostTwelve{s.n}, s); }

/// At least as many frequencies as lanes; where they do not fill the last pack, it takes some of the pack before once more.
template <bool complex_load, bool moduli, typename Size>
void pairs_of_size(Size n, const PairsAtFrequencies& s) {
  const int numbers = complex_load ? 4 * n + 3 : 2 * n + 3;
  const double* const pairs = s.pairs;
  for (Eigen::Index next = 0; next < s.count; next += lane_count()) {
    const Eigen::Index f = std::min<Eigen::Index>(next, s.count - lane_count());
    const Pack p = hn::LoadU(Lanes(), s.omega + f);
    ComplexPack g[Size::most];  // 1/((ω_k² − p²) + ip d)
    each(n, [&](int k) TRIVET_LANES {
      const double* pair = pairs + k * numbers;
      const Pack omega = all(pair[0]);
      g[k] = quick_inverse({hn::Mul(hn::Add(hn::Sub(omega, p), all(pair[1])), hn::Add(omega, p)), hn::Mul(all(pair[2]), p)});
    });
    each(n, [&](int j) TRIVET_LANES {
      const auto sum = [&](int from) TRIVET_LANES {  // Σ (c0 + ip c1) g
        ComplexPack constant = zero(), rate = zero();
        each(n, [&](int k) TRIVET_LANES {
          constant = add_product(constant, all(pairs[k * numbers + from + j]), g[k]);
          rate = add_product(rate, all(pairs[k * numbers + from + n + j]), g[k]);
        });
        return ComplexPack{hn::NegMulAdd(p, rate.im, constant.re), hn::MulAdd(p, rate.re, constant.im)};
      };
      ComplexPack q = sum(3);
      if constexpr (complex_load) {
        const ComplexPack imaginary = sum(3 + 2 * n);
        q = q + ComplexPack{hn::Neg(imaginary.im), imaginary.re};
      }
      hn::StoreU(moduli ? squared_modulus(q) : q.re, Lanes(), s.re + j * s.stride + f);
      if constexpr (!moduli) hn::StoreU(q.im, Lanes(), s.im + j * s.stride + f);
    });
  }
}

template <typename Size>
void pairs_of(Size n, const PairsAtFrequencies& s, bool complex_load) {
  if (s.im) return complex_load ? pairs_of_size<true, false>(n, s) : pairs_of_size<false, false>(n, s);
  complex_load ? pairs_of_size<true, true>(n, s) : pairs_of_size<false, true>(n, s);
}

void pairs_at(const PairsAtFrequencies& s, bool complex_load) {
  s.n == 6 ? pairs_of(six_coordinates(), s, complex_load) : pairs_of(AtMostTwelve{s.n}, s, complex_load);
}

/// The largest backward error of them, with |re| + |im| for the modulus.
double worst_backward_error(const EquationAtFrequencies& s) {
  const int n = s.n;
  Pack worst = all(0.0);
  for (Eigen::Index f = 0; f < s.count; f += lane_count()) {
    const Pack p = some(s.omega + f, s.count - f), square = hn::Mul(p, p), rest = hn::MulSub(p, p, square);
    ComplexPack q[12];
    Pack size = all(0.0), residual = size, norm = size, load = size;
    for (int j = 0; j < n; ++j) {
      q[j] = all(s.by_scale[j]) * ComplexPack{some(s.re + j * s.stride + f, s.count - f), some(s.im + j * s.stride + f, s.count - f)};
      size = hn::Max(size, one_norm(q[j]));
    }
    for (int i = 0; i < n; ++i) {
      ComplexPack r = {all(s.load_re[i]), all(s.load_im[i])};
      load = hn::Max(load, one_norm(r));
      Pack row = all(0.0);
      for (int j = 0; j < n; ++j) {
        const Pack a = all(s.A[i * n + j]), re = hn::NegMulAdd(rest, a, hn::NegMulAdd(square, a, all(s.K[i * n + j])));  // fused: right though it cancels
        const ComplexPack z = {re, hn::Mul(p, all(s.B[i * n + j]))};
        row = hn::Add(row, one_norm(z));
        r = subtract_product(r, z, q[j]);
      }
      norm = hn::Max(norm, row);
      residual = hn::Max(residual, one_norm(r));
    }
    const Pack error = hn::Div(residual, hn::MulAdd(norm, size, load));
    worst = hn::Max(worst, error);
    // Max may lose what is not a number.
    if (!hn::AllTrue(Lanes(), hn::And(hn::Lt(size, all(std::numeric_limits<double>::infinity())), hn::Le(error, worst)))) return std::numeric_limits<double>::infinity();
  }
  return hn::GetLane(hn::MaxOfLanes(Lanes(), worst));
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/design_modes.h"
#include "trivet/numerics/dispatch.h"
#include "trivet/numerics/frequency_sweep.h"

namespace trivet::numerics {

TRIVET_VARIANTS(roots_of_system);
TRIVET_VARIANTS(pairs_at);
TRIVET_VARIANTS(worst_backward_error);

namespace {

using Extended = long double;

/// Modes of the scaled system with frequencies to extended precision: errors of a shape enter its Rayleigh quotient squared.
struct ExtendedModes {
  Eigen::MatrixXd shapes, b;   ///< φᵀAφ = 1; ΦᵀBΦ
  Extended omega[12];
  bool coupled = false;
};

Extended quadratic_form(const Eigen::MatrixXd& m, const double* v) {
  Extended sum = 0;
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    Extended column = 0.5L * m(j, j) * v[j];
    for (Eigen::Index i = 0; i < j; ++i) column += Extended(m(i, j)) * v[i];
    sum += 2 * column * v[j];
  }
  return sum;
}

std::optional<ExtendedModes> extended_modes(const DynamicMatrices& m) {
  const int n = static_cast<int>(m.size());
  Designs design{Eigen::ArrayXXd(1, n * (n + 1) / 2), {}, Eigen::ArrayXXd(1, n * (n + 1) / 2), {}};
  for (int i = 0, entry = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j, ++entry) design.A(0, entry) = m.A(i, j), design.K(0, entry) = m.K(i, j);
  const DesignModes found = design_modes(design, {.threads = 1});
  if (!found.definite[0] || !(found.lambda(0, 0) > 0)) return std::nullopt;
  ExtendedModes modes;
  modes.shapes = Eigen::Map<const Eigen::MatrixXd>(found.shapes.data(), n, n);
  for (int k = 0; k < n; ++k) {
    const Extended mass = quadratic_form(m.A, modes.shapes.col(k).data()), stiffness = quadratic_form(m.K, modes.shapes.col(k).data());
    if (!(mass > 0 && stiffness > 0)) return std::nullopt;
    modes.omega[k] = std::sqrt(stiffness / mass);
    modes.shapes.col(k) /= static_cast<double>(std::sqrt(mass));
  }
  modes.b.noalias() = modes.shapes.transpose() * (m.B * modes.shapes).eval();
  constexpr double round_off = 1e-13;
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < k; ++l) {
      double& entry = modes.b(k, l);
      if (entry * entry <= round_off * round_off * modes.b(k, k) * modes.b(l, l)) entry = 0;
      modes.b(l, k) = entry;
      modes.coupled = modes.coupled || entry != 0;
    }
  return modes;
}

/// The kernel needs as many frequencies as the widest vector has lanes.
void pairs_at_any(PairsAtFrequencies s, bool complex_load) {
  constexpr Eigen::Index lanes = 8;
  if (s.count >= lanes) return TRIVET_DISPATCH(pairs_at)(s, complex_load);
  const Eigen::Index count = s.count, stride = s.stride;
  if (count == 0) return;
  double *const re = s.re, *const im = s.im;
  Eigen::ArrayXd omega = Eigen::ArrayXd::Constant(lanes, s.omega[count - 1]);
  std::copy(s.omega, s.omega + count, omega.data());
  Eigen::ArrayXXd some_re(lanes, s.n), some_im(lanes, s.n);
  s.omega = omega.data(), s.count = s.stride = lanes, s.re = some_re.data();
  if (im) s.im = some_im.data();
  TRIVET_DISPATCH(pairs_at)(s, complex_load);
  for (Eigen::Index j = 0; j < s.n; ++j) {
    std::copy(&some_re(0, j), &some_re(0, j) + count, re + j * stride);
    if (im) std::copy(&some_im(0, j), &some_im(0, j) + count, im + j * stride);
  }
}

struct PoleOfMode {
  std::complex<Extended> lambda;
  Eigen::VectorXcd shape;       ///< v in coordinates, of unit modal length
  Eigen::VectorXcd v;           ///< in modes
  Complex slope;
};

/// Poles of all modes, one each: the slower of two real ones, or that with Im > 0; or their partners.
bool poles_of_modes(const ExtendedModes& modes, bool partners, std::vector<PoleOfMode>& poles) {
  const int n = static_cast<int>(modes.b.rows());
  RootsOfSystem roots;
  roots.n = n;
  const auto seen = [&](int i, int own) { return i == n - 1 ? own : i + (i >= own); };
  for (int k = 0; k < n; ++k) {
    const double omega = static_cast<double>(modes.omega[k]), damping = 0.5 * modes.b(k, k);
    const double radical = std::sqrt(std::abs((damping - omega) * (damping + omega)));
    const bool real = damping > omega;
    const Extended centre = real ? 0 : modes.omega[k];
    const double fast = -(damping + radical), slow = omega * omega / fast;
    roots.centre[k] = static_cast<double>(centre);
    roots.offset_re[k] = real ? (partners ? fast : slow) : -damping;
    roots.offset_im[k] = real ? 0 : -damping * damping / (radical + omega);
    roots.slope_re[k] = 2 * (roots.offset_re[k] + damping);
    roots.slope_im[k] = 2 * (roots.centre[k] + roots.offset_im[k]);
    for (int i = 0; i < n; ++i) {
      const int mode = seen(i, k);
      roots.below[i][k] = static_cast<double>(centre - modes.omega[mode]);
      roots.above[i][k] = static_cast<double>(centre + modes.omega[mode]);
      for (int j = 0; j <= i; ++j) roots.b[i * (i + 1) / 2 + j][k] = modes.b(mode, seen(j, k));
      roots.v_re[i][k] = i == n - 1;
      roots.v_im[i][k] = 0;
    }
  }
  if (modes.coupled) {
    TRIVET_DISPATCH(roots_of_system)(roots);
    if (!roots.converged) return false;
  }
  poles.resize(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) {
    PoleOfMode& pole = poles[static_cast<std::size_t>(k)];
    const bool real = roots.centre[k] == 0;
    pole.lambda = {roots.offset_re[k], real ? Extended(0) : modes.omega[k] + roots.offset_im[k]};
    pole.slope = {roots.slope_re[k], roots.slope_im[k]};
    pole.v.resize(n);
    for (int i = 0; i < n; ++i) pole.v(seen(i, k)) = {roots.v_re[i][k], roots.v_im[i][k]};
    pole.shape.noalias() = modes.shapes * pole.v;
  }
  return true;
}

}  // namespace

std::optional<PoleSweep> PoleSweep::of(const DynamicMatrices& matrices, const Eigen::VectorXcd& load) {
  const int n = static_cast<int>(matrices.size());
  if (n < 1 || n > 12 || !matrices.symmetric || matrices.lossy()) return std::nullopt;
  PoleSweep result;
  // Powers of two: the scaled matrices are the given ones to the last bit, and so are their frequencies.
  result.scale_ = unit_scale(matrices).unaryExpr([](double d) { return std::exp2(std::round(std::log2(d))); });
  result.matrices_ = scaled(matrices, result.scale_);
  result.load_ = result.scale_.asDiagonal() * load;
  result.complex_load_ = !load.imag().isZero(0);
  const std::optional<ExtendedModes> modes = extended_modes(result.matrices_);
  if (!modes) return std::nullopt;
  std::vector<PoleOfMode> poles, partners;
  if (!poles_of_modes(*modes, false, poles)) return std::nullopt;
  const auto is_real = [](const PoleOfMode& pole) { return pole.lambda.imag() == 0; };
  if (std::any_of(poles.begin(), poles.end(), is_real) && !poles_of_modes(*modes, true, partners)) return std::nullopt;

  const Eigen::VectorXd load_re = result.load_.real(), load_im = result.load_.imag();
  result.pairs_.resize(3 + (result.complex_load_ ? 4 : 2) * n, n);
  Eigen::ArrayXd at_poles(n);
  Extended trace = 0, product = 1;
  for (int k = 0; k < n; ++k) {
    const PoleOfMode& one = poles[static_cast<std::size_t>(k)];
    PoleOfMode two{std::conj(one.lambda), one.shape.conjugate(), one.v.conjugate(), std::conj(one.slope)};
    if (is_real(one)) two = partners[static_cast<std::size_t>(k)];
    const Complex first(one.lambda), second(two.lambda);
    const Extended square = (one.lambda * two.lambda).real(), omega = std::sqrt(square);
    trace += (one.lambda + two.lambda).real();
    product *= square / (modes->omega[k] * modes->omega[k]);
    if (!(first.real() < 0 && second.real() < 0)) return std::nullopt;
    for (const PoleOfMode* pole : {&one, static_cast<const PoleOfMode*>(&two)})
      result.condition_ = std::max(result.condition_, 2 * std::abs(Complex(pole->lambda)) / std::abs(pole->slope));
    auto pair = result.pairs_.col(k);
    pair(0) = at_poles(k) = static_cast<double>(omega);
    pair(1) = static_cast<double>(omega - pair(0));
    pair(2) = static_cast<double>(-(one.lambda + two.lambda).real());
    const auto add_load = [&](const Eigen::VectorXd& h, Eigen::Index from) {
      const Eigen::VectorXd modal = modes->shapes.transpose() * h;
      const Complex a = one.v.cwiseProduct(modal.cast<Complex>()).sum() / one.slope;
      const Complex b = two.v.cwiseProduct(modal.cast<Complex>()).sum() / two.slope;
      pair.segment(from, n) = -result.scale_.array() * (one.shape * (a * second) + two.shape * (b * first)).real().array();
      pair.segment(from + n, n) = result.scale_.array() * (one.shape * a + two.shape * b).real().array();
    };
    add_load(load_re, 3);
    if (result.complex_load_) add_load(load_im, 3 + 2 * n);
  }
  constexpr double once = 1e-9, most_condition = 1e4;
  const double damping = modes->b.trace();
  if (!(std::abs(static_cast<double>(trace) + damping) <= once * damping && std::abs(static_cast<double>(product - 1)) <= once)) return std::nullopt;
  if (!(result.condition_ <= most_condition)) return std::nullopt;
  std::sort(at_poles.begin(), at_poles.end());
  Eigen::ArrayXd checked(2 * n + 1);
  for (int k = 0; k < n; ++k) {
    checked(2 * k) = k == 0 ? 0.5 * at_poles(0) : std::sqrt(at_poles(k - 1) * at_poles(k));
    checked(2 * k + 1) = at_poles(k);
  }
  checked(2 * n) = 2 * at_poles(n - 1);
  constexpr double share = 0.3;  // of what is accepted: only some frequencies are checked
  Eigen::ArrayXXd re(checked.size(), n), im(checked.size(), n);
  result.evaluate(checked, re, im);
  if (!(result.backward_error(checked, 0, checked.size(), re, im) <= share * accepted_backward_error)) return std::nullopt;
  return result;
}

void PoleSweep::evaluate(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Ref<Eigen::ArrayXXd> re, Eigen::Ref<Eigen::ArrayXXd> im) const {
  pairs_at_any({static_cast<int>(matrices_.size()), pairs_.data(), omega.data(), omega.size(), re.data(), im.data(), re.outerStride()}, complex_load_);
}

double PoleSweep::backward_error(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Index first, Eigen::Index count,
                                 const Eigen::Ref<const Eigen::ArrayXXd>& re, const Eigen::Ref<const Eigen::ArrayXXd>& im) const {
  const Eigen::VectorXd by_scale = scale_.cwiseInverse(), load_re = load_.real(), load_im = load_.imag();
  const EquationAtFrequencies equation{static_cast<int>(matrices_.size()), matrices_.A.data(), matrices_.B.data(), matrices_.K.data(),
                                       by_scale.data(), load_re.data(), load_im.data(),
                                       omega.data() + first, re.data() + first, im.data() + first, count, re.outerStride()};
  return TRIVET_DISPATCH(worst_backward_error)(equation);
}

bool PoleSweep::response(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Ref<Eigen::ArrayXXd> re, Eigen::Ref<Eigen::ArrayXXd> im) const {
  const Eigen::Index n = matrices_.size(), count = omega.size();
  if (re.rows() != count || im.rows() != count || re.cols() != n || im.cols() != n || re.outerStride() != im.outerStride())
    throw foundation::InvalidInput("response of a pole sweep: re and im must be frequencies × coordinates");
  evaluate(omega, re, im);
  constexpr Eigen::Index checked = 8, period = 64 * checked;
  for (Eigen::Index first = 0; first < count; first += period)
    if (!(backward_error(omega, first, std::min(checked, count - first), re, im) <= accepted_backward_error)) return false;
  return true;
}

void PoleSweep::squared_moduli(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Ref<Eigen::ArrayXXd> result) const {
  const Eigen::Index n = matrices_.size();
  if (result.rows() != omega.size() || result.cols() != n)
    throw foundation::InvalidInput("moduli of a pole sweep: the result must be frequencies × coordinates");
  pairs_at_any({static_cast<int>(n), pairs_.data(), omega.data(), omega.size(), result.data(), nullptr, result.outerStride()}, complex_load_);
}

}  // namespace trivet::numerics
#endif
