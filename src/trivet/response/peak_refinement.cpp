// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/peak_refinement.h"

#include <array>
#include <cmath>
#include <limits>

#include "trivet/numerics/refined_solution.h"

namespace trivet::response {
namespace {

using Extended = long double;
using Complex = std::complex<Extended>;
using numerics::ExtendedMatrix;
using numerics::ExtendedVector;
constexpr Extended unit_round_off = std::numeric_limits<double>::epsilon() / 2;

/// y, dy/dω and d²y/dω².
using Jet = std::array<Complex, 3>;

/// First-order bounds on what round-off in the entries of A, B, K can do.
struct Sensitivity {
  Extended amplitude = 0;
  Extended value = 0;  ///< of the complex y: also turns of its phase
};

using VectorJet = std::array<ExtendedVector, 3>;

/// h, dh/dω and d²h/dω² of Σ (iω)^p e^{−iωd} v, ω > 0.
VectorJet jet_of(const numerics::Load& load, Extended w) {
  VectorJet jet;
  jet.fill(ExtendedVector::Zero(load.size()));
  for (const numerics::LoadTerm& term : load.terms()) {
    const Complex factor = numerics::integer_power(Complex(0, w), term.power) * std::polar(Extended(1), -w * Extended(term.delay));
    const Complex rate(Extended(term.power) / w, -Extended(term.delay));  // of its logarithm
    const ExtendedVector value = term.value.cast<Complex>() * factor;
    jet[0] += value;
    jet[1] += value * rate;
    jet[2] += value * (rate * rate - Extended(term.power) / (w * w));
  }
  return jet;
}

/// cᵀq with c = c0 + iω c1 − ω² c2.
Jet weighted(const ExtendedVector& c0, const ExtendedVector& c1, const ExtendedVector& c2, const VectorJet& q, Extended w) {
  const Complex i(0, 1);
  const auto with = [](const ExtendedVector& c, const ExtendedVector& v) -> Complex { return c.transpose() * v; };
  const ExtendedVector c = c0 + i * w * c1 - w * w * c2, slope = i * c1 - Extended(2) * w * c2;
  return {with(c, q[0]), with(slope, q[0]) + with(c, q[1]), Extended(2) * with(slope, q[1]) + with(c, q[2]) - Extended(2) * with(c2, q[0])};
}

class Curve {
 public:
  Curve(const assembly::Assembled& assembled, const assembly::Channel& channel, const assembly::Loading& loading)
      : derivative_(channel.derivative), d_(numerics::unit_scale(assembled.matrices)) {
    const numerics::DynamicMatrices m = numerics::scaled(assembled.matrices, d_);
    A_ = m.A.cast<Complex>();
    B_ = m.B.cast<Complex>();
    K_ = m.complex_stiffness().cast<Complex>();
    h_ = assembly::right_side(assembled, loading).scaled(d_);
    ground_ = loading.motion;
    c0_ = (d_.asDiagonal() * channel.on_displacement).cast<Complex>();
    c1_ = (d_.asDiagonal() * channel.on_velocity).cast<Complex>();
    c2_ = (d_.asDiagonal() * channel.on_acceleration).cast<Complex>();
    if (!channel.ground.empty()) {
      g0_ = channel.ground.on_displacement.cast<Complex>();
      g1_ = channel.ground.on_velocity.cast<Complex>();
      g2_ = channel.ground.on_acceleration.cast<Complex>();
    }
  }

  Jet at(Extended w) const {
    const Complex i(0, 1);
    const numerics::RefinedSolver solver(ExtendedMatrix(K_ + i * w * B_ - w * w * A_));
    const ExtendedMatrix slope = i * B_ - Extended(2) * w * A_;
    const VectorJet h = jet_of(h_, w);
    const ExtendedVector q0 = solver.solve(h[0]);
    const ExtendedVector q1 = solver.solve(h[1] - slope * q0);
    const ExtendedVector q2 = solver.solve(h[2] - Extended(2) * (slope * q1) + Extended(2) * (A_ * q0));
    Jet y = weighted(c0_, c1_, c2_, {q0, q1, q2}, w);
    if (g0_.size() > 0 && !ground_.vanishes()) {
      const Jet moved = weighted(g0_, g1_, g2_, jet_of(ground_, w), w);
      for (std::size_t k = 0; k < 3; ++k) y[k] += moved[k];
    }
    for (int k = 0; k < derivative_; ++k) y = {i * w * y[0], i * (y[0] + w * y[1]), i * (Extended(2) * y[1] + w * y[2])};
    return y;
  }

  /// δy = −pᵀ δZ q with pᵀ = cᵀZ⁻¹; entries of K and ω²A change by real, those of ωB by imaginary amounts of one unit of
  /// round-off. Only what lies along y changes its amplitude.
  Sensitivity sensitivity(Extended w) const {
    const Complex i(0, 1);
    const ExtendedMatrix z = K_ + i * w * B_ - w * w * A_;
    const ExtendedVector q = numerics::RefinedSolver(z).solve(jet_of(h_, w)[0]);
    const ExtendedVector p = numerics::RefinedSolver(ExtendedMatrix(z.transpose())).solve(c_of(w));
    Complex y = c_of(w).transpose() * q;
    if (g0_.size() > 0 && !ground_.vanishes()) y += weighted(g0_, g1_, g2_, jet_of(ground_, w), w)[0];
    const Complex along = std::abs(y) > 0 ? std::conj(y) / std::abs(y) : Complex(1);
    const Extended rate = std::pow(w, Extended(derivative_));
    Sensitivity sum;
    for (Eigen::Index row = 0; row < q.size(); ++row)
      for (Eigen::Index column = 0; column < q.size(); ++column) {
        const Complex effect = along * p(row) * q(column);
        const Extended real = std::abs(K_(row, column)) + w * w * std::abs(A_(row, column)), imaginary = w * std::abs(B_(row, column));
        sum.amplitude += rate * unit_round_off * (real * std::abs(effect.real()) + imaginary * std::abs(effect.imag()));
        sum.value += rate * unit_round_off * (real + imaginary) * std::abs(effect);
      }
    return sum;
  }

 private:
  ExtendedVector c_of(Extended w) const { return c0_ + Complex(0, w) * c1_ - w * w * c2_; }

  int derivative_;
  Eigen::VectorXd d_;
  ExtendedMatrix A_, B_, K_;
  numerics::Load h_{Eigen::Index{0}}, ground_{Eigen::Index{0}};
  ExtendedVector c0_, c1_, c2_, g0_, g1_, g2_;
};

}  // namespace

RefinedPeak refine_peak(const assembly::Assembled& assembled, const assembly::Channel& channel, const assembly::Loading& loading, double omega,
                        double reach) {
  constexpr int most_steps = 8;
  const Curve curve(assembled, channel, loading);
  Extended w = omega;
  Jet y = curve.at(w);
  const Sensitivity sensitivity = curve.sensitivity(w);
  RefinedPeak result;
  result.amplitude_uncertainty = static_cast<double>(sensitivity.amplitude);
  // A change of the data moves the curve along the axis by about δy / y'.
  result.frequency_uncertainty = static_cast<double>(sensitivity.value / std::max(std::abs(y[1]), std::numeric_limits<Extended>::min()));
  Extended previous = std::numeric_limits<Extended>::infinity();
  for (int step = 0; step < most_steps && !result.converged; ++step) {
    const Extended gradient = std::real(std::conj(y[0]) * y[1]);
    const Extended curvature = std::norm(y[1]) + std::real(std::conj(y[0]) * y[2]);
    const Extended change = -gradient / curvature;
    if (!(curvature < 0) || !std::isfinite(change) || std::abs(w + change - Extended(omega)) > Extended(reach)) break;
    result.converged = std::abs(change) <= Extended(1e-17) * w;
    if (std::abs(change) >= Extended(0.5) * previous) {
      result.converged = std::abs(change) <= Extended(result.frequency_uncertainty) + Extended(1e-12) * w;
      break;
    }
    w += change;
    y = curve.at(w);
    previous = std::abs(change);
  }
  result.angular_frequency = static_cast<double>(w);
  result.amplitude = static_cast<double>(std::abs(y[0]));
  return result;
}

}  // namespace trivet::response
