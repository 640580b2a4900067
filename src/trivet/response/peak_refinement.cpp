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

class Curve {
 public:
  Curve(const assembly::Assembled& assembled, const assembly::Channel& channel, const Eigen::VectorXcd& load)
      : derivative_(channel.derivative), d_(numerics::unit_scale(assembled.matrices)) {
    const numerics::DynamicMatrices m = numerics::scaled(assembled.matrices, d_);
    A_ = m.A.cast<Complex>();
    B_ = m.B.cast<Complex>();
    K_ = m.complex_stiffness().cast<Complex>();
    h_ = (d_.asDiagonal() * load).cast<Complex>();
    c0_ = (d_.asDiagonal() * channel.on_displacement).cast<Complex>();
    c1_ = (d_.asDiagonal() * channel.on_velocity).cast<Complex>();
    c2_ = (d_.asDiagonal() * channel.on_acceleration).cast<Complex>();
  }

  Jet at(Extended w) const {
    const Complex i(0, 1);
    const numerics::RefinedSolver solver(ExtendedMatrix(K_ + i * w * B_ - w * w * A_));
    const ExtendedMatrix slope = i * B_ - Extended(2) * w * A_;
    const ExtendedVector q0 = solver.solve(h_);
    const ExtendedVector q1 = solver.solve(-(slope * q0));
    const ExtendedVector q2 = solver.solve(-(Extended(2) * (slope * q1)) + Extended(2) * (A_ * q0));
    const auto with = [](const ExtendedVector& c, const ExtendedVector& q) -> Complex { return c.transpose() * q; };
    // y = cᵀq with c = c0 + iω c1 − ω² c2, then each time derivative multiplies by iω.
    const ExtendedVector c = c0_ + i * w * c1_ - w * w * c2_, slope_of_c = i * c1_ - Extended(2) * w * c2_;
    Jet y = {with(c, q0), with(slope_of_c, q0) + with(c, q1),
             Extended(2) * with(slope_of_c, q1) + with(c, q2) - Extended(2) * with(c2_, q0)};
    for (int k = 0; k < derivative_; ++k) y = {i * w * y[0], i * (y[0] + w * y[1]), i * (Extended(2) * y[1] + w * y[2])};
    return y;
  }

  /// δy = −pᵀ δZ q with pᵀ = cᵀZ⁻¹; entries of K and ω²A change by real, those of ωB by imaginary amounts of one unit of
  /// round-off. Only what lies along y changes its amplitude.
  Sensitivity sensitivity(Extended w) const {
    const Complex i(0, 1);
    const ExtendedMatrix z = K_ + i * w * B_ - w * w * A_;
    const ExtendedVector q = numerics::RefinedSolver(z).solve(h_);
    const ExtendedVector p = numerics::RefinedSolver(ExtendedMatrix(z.transpose())).solve(ExtendedVector(c0_ + i * w * c1_ - w * w * c2_));
    const Complex y = p.transpose() * h_;
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
  int derivative_;
  Eigen::VectorXd d_;
  ExtendedMatrix A_, B_, K_;
  ExtendedVector h_, c0_, c1_, c2_;
};

}  // namespace

RefinedPeak refine_peak(const assembly::Assembled& assembled, const assembly::Channel& channel, const Eigen::VectorXcd& load, double omega,
                        double reach) {
  constexpr int most_steps = 8;
  const Curve curve(assembled, channel, load);
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
