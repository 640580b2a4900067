// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sweep/pole_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/quadratic_form.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/numerics/sweep/pole_kernels.h"

namespace trivet::numerics {
namespace {

using Extended = long double;

/// Modes of the scaled system with frequencies in extended precision: the error of a shape enters its Rayleigh quotient
/// squared.
struct ExtendedModes {
  Eigen::MatrixXd shapes, b;  ///< φᵀAφ = 1; ΦᵀBΦ
  Extended omega[12];
  bool coupled = false;
};

std::optional<ExtendedModes> extended_modes(const DynamicMatrices& m) {
  const int n = static_cast<int>(m.size());
  Designs design{Eigen::ArrayXXd(1, n * (n + 1) / 2), {}, Eigen::ArrayXXd(1, n * (n + 1) / 2), {}};
  pack(m.A, design.A, 0);
  pack(m.K, design.K, 0);
  const DesignModes found = design_modes(design, {.threads = 1});
  if (!found.definite[0] || !(found.lambda(0, 0) > 0)) return std::nullopt;
  ExtendedModes modes;
  modes.shapes = Eigen::Map<const Eigen::MatrixXd>(found.shapes.data(), n, n);
  const QuadraticForm mass_form(m.A), stiffness_form(m.K);
  for (int k = 0; k < n; ++k) {
    const Extended mass = mass_form(modes.shapes.col(k)), stiffness = stiffness_form(modes.shapes.col(k));
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

/// Repeats the last frequency if necessary: the kernel needs as many as the widest vector has lanes.
void pairs_at_any(PairsAtFrequencies s, bool complex_load) {
  constexpr Eigen::Index lanes = 8;
  if (s.count >= lanes) return pairs_at(s, complex_load);
  const Eigen::Index count = s.count, stride = s.stride;
  if (count == 0) return;
  double *const re = s.re, *const im = s.im;
  Eigen::ArrayXd omega = Eigen::ArrayXd::Constant(lanes, s.omega[count - 1]);
  std::copy(s.omega, s.omega + count, omega.data());
  Eigen::ArrayXXd some_re(lanes, s.n), some_im(lanes, s.n);
  s.omega = omega.data(), s.count = s.stride = lanes, s.re = some_re.data();
  if (im) s.im = some_im.data();
  pairs_at(s, complex_load);
  for (Eigen::Index j = 0; j < s.n; ++j) {
    std::copy(&some_re(0, j), &some_re(0, j) + count, re + j * stride);
    if (im) std::copy(&some_im(0, j), &some_im(0, j) + count, im + j * stride);
  }
}

struct PoleOfMode {
  std::complex<Extended> lambda;
  Eigen::VectorXcd shape;  ///< v in coordinates, of unit modal length
  Eigen::VectorXcd v;      ///< in modes
  Complex slope;
};

/// Poles of all modes, one each: the slower of two real ones, or the one with Im > 0; or their partners.
bool poles_of_modes(const ExtendedModes& modes, bool partners, std::vector<PoleOfMode>& poles) {
  const int n = static_cast<int>(modes.b.rows());
  RootsOfSystem roots;
  roots.n = n;
  const auto mode_order = [&](int i, int own) { return i == n - 1 ? own : i + (i >= own); };
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
      const int mode = mode_order(i, k);
      roots.below[i][k] = static_cast<double>(centre - modes.omega[mode]);
      roots.above[i][k] = static_cast<double>(centre + modes.omega[mode]);
      for (int j = 0; j <= i; ++j) roots.b[i * (i + 1) / 2 + j][k] = modes.b(mode, mode_order(j, k));
      roots.v_re[i][k] = i == n - 1;
      roots.v_im[i][k] = 0;
    }
  }
  if (modes.coupled) {
    roots_of_system(roots);
    if (!roots.converged) return false;
  }
  poles.resize(to_size(n));
  for (int k = 0; k < n; ++k) {
    PoleOfMode& pole = poles[to_size(k)];
    const bool real = roots.centre[k] == 0;
    pole.lambda = {roots.offset_re[k], real ? Extended(0) : modes.omega[k] + roots.offset_im[k]};
    pole.slope = {roots.slope_re[k], roots.slope_im[k]};
    pole.v.resize(n);
    for (int i = 0; i < n; ++i) pole.v(mode_order(i, k)) = {roots.v_re[i][k], roots.v_im[i][k]};
    pole.shape.noalias() = modes.shapes * pole.v;
  }
  return true;
}

}  // namespace

std::optional<PoleSweep> PoleSweep::try_build(const DynamicMatrices& matrices, const Eigen::VectorXcd& load) {
  const int n = static_cast<int>(matrices.size());
  if (n < 1 || n > 12 || !matrices.symmetric || matrices.lossy()) return std::nullopt;
  PoleSweep result;
  // Powers of two, so that scaling does not round: the frequencies are exactly those of the given matrices.
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
  double condition = 0;
  for (int k = 0; k < n; ++k) {
    const PoleOfMode& one = poles[to_size(k)];
    PoleOfMode two{std::conj(one.lambda), one.shape.conjugate(), one.v.conjugate(), std::conj(one.slope)};
    if (is_real(one)) two = partners[to_size(k)];
    const Complex first(one.lambda), second(two.lambda);
    const Extended square = (one.lambda * two.lambda).real(), omega = std::sqrt(square);
    trace += (one.lambda + two.lambda).real();
    product *= square / (modes->omega[k] * modes->omega[k]);
    if (!(first.real() < 0 && second.real() < 0)) return std::nullopt;
    for (const PoleOfMode* pole : {&one, static_cast<const PoleOfMode*>(&two)})
      condition = std::max(condition, 2 * std::abs(Complex(pole->lambda)) / std::abs(pole->slope));
    auto pair = result.pairs_.col(k);
    pair(0) = at_poles(k) = static_cast<double>(omega);
    pair(1) = static_cast<double>(omega - pair(0));
    pair(2) = static_cast<double>(-(one.lambda + two.lambda).real());
    const auto add_load = [&](const Eigen::VectorXd& h, Eigen::Index from) {
      const Eigen::VectorXd modal = modes->shapes.transpose() * h;
      const Complex a = one.v.cwiseProduct(modal.cast<Complex>()).sum() / one.slope;
      const Complex b = two.v.cwiseProduct(modal.cast<Complex>()).sum() / two.slope;
      pair.segment(from, n) =
          -result.scale_.array() * (one.shape * (a * second) + two.shape * (b * first)).real().array();
      pair.segment(from + n, n) = result.scale_.array() * (one.shape * a + two.shape * b).real().array();
    };
    add_load(load_re, 3);
    if (result.complex_load_) add_load(load_im, 3 + 2 * n);
  }
  constexpr double once = 1e-9, most_condition = 1e4;
  const double damping = modes->b.trace();
  if (!(std::abs(static_cast<double>(trace) + damping) <= once * damping &&
        std::abs(static_cast<double>(product - 1)) <= once))
    return std::nullopt;
  if (!(condition <= most_condition)) return std::nullopt;
  std::sort(at_poles.begin(), at_poles.end());
  Eigen::ArrayXd checked(2 * n + 1);
  for (int k = 0; k < n; ++k) {
    checked(2 * k) = k == 0 ? 0.5 * at_poles(0) : std::sqrt(at_poles(k - 1) * at_poles(k));
    checked(2 * k + 1) = at_poles(k);
  }
  checked(2 * n) = 2 * at_poles(n - 1);
  constexpr double share = 0.3;  // of the accepted error, because only some frequencies are checked
  Eigen::ArrayXXd re(checked.size(), n), im(checked.size(), n);
  result.evaluate(checked, re, im);
  if (!(result.backward_error(checked, 0, checked.size(), re, im) <= share * accepted_backward_error))
    return std::nullopt;
  return result;
}

void PoleSweep::evaluate(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Ref<Eigen::ArrayXXd> re,
                         Eigen::Ref<Eigen::ArrayXXd> im) const {
  pairs_at_any({static_cast<int>(matrices_.size()), pairs_.data(), omega.data(), omega.size(), re.data(), im.data(),
                re.outerStride()},
               complex_load_);
}

double PoleSweep::backward_error(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Index first, Eigen::Index count,
                                 const Eigen::Ref<const Eigen::ArrayXXd>& re,
                                 const Eigen::Ref<const Eigen::ArrayXXd>& im) const {
  const Eigen::VectorXd by_scale = scale_.cwiseInverse(), load_re = load_.real(), load_im = load_.imag();
  const EquationAtFrequencies equation{static_cast<int>(matrices_.size()),
                                       matrices_.A.data(),
                                       matrices_.B.data(),
                                       matrices_.K.data(),
                                       by_scale.data(),
                                       load_re.data(),
                                       load_im.data(),
                                       omega.data() + first,
                                       re.data() + first,
                                       im.data() + first,
                                       count,
                                       re.outerStride()};
  return worst_backward_error(equation);
}

bool PoleSweep::response(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Ref<Eigen::ArrayXXd> re,
                         Eigen::Ref<Eigen::ArrayXXd> im) const {
  const Eigen::Index n = matrices_.size(), count = omega.size();
  if (re.rows() != count || im.rows() != count || re.cols() != n || im.cols() != n ||
      re.outerStride() != im.outerStride())
    throw foundation::InvalidInput("response of a pole sweep: re and im must be frequencies × coordinates");
  evaluate(omega, re, im);
  constexpr Eigen::Index checked = 8, period = 64 * checked;
  for (Eigen::Index first = 0; first < count; first += period)
    if (!(backward_error(omega, first, std::min(checked, count - first), re, im) <= accepted_backward_error))
      return false;
  return true;
}

}  // namespace trivet::numerics
