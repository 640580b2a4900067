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

/// y, dy/dω, d²y/dω², and the size of the terms that make them up.
struct Jet {
  std::array<Complex, 3> y;
  std::array<Extended, 2> terms;
};

class Curve {
 public:
  Curve(const assembly::Assembled& assembled, const assembly::Channel& channel, const Eigen::VectorXcd& load)
      : derivative_(channel.derivative), d_(numerics::unit_scale(assembled.matrices.A)) {
    const numerics::DynamicMatrices m = numerics::scaled(assembled.matrices, d_);
    A_ = m.A.cast<Complex>();
    B_ = m.B.cast<Complex>();
    K_ = m.complex_stiffness().cast<Complex>();
    h_ = (d_.asDiagonal() * load).cast<Complex>();
    c0_ = (d_.asDiagonal() * channel.on_displacement).cast<Complex>();
    c1_ = (d_.asDiagonal() * channel.on_velocity).cast<Complex>();
  }

  Jet at(Extended w) const {
    const Complex i(0, 1);
    const numerics::RefinedSolver solver(ExtendedMatrix(K_ + i * w * B_ - w * w * A_));
    const ExtendedMatrix slope = i * B_ - Extended(2) * w * A_;
    const ExtendedVector q0 = solver.solve(h_);
    const ExtendedVector q1 = solver.solve(-(slope * q0));
    const ExtendedVector q2 = solver.solve(-(Extended(2) * (slope * q1)) + Extended(2) * (A_ * q0));
    const auto with = [](const ExtendedVector& c, const ExtendedVector& q) -> Complex { return c.transpose() * q; };
    // y = c0ᵀq + iω c1ᵀq, then each time derivative multiplies by iω.
    Jet jet;
    jet.y = {with(c0_, q0) + i * w * with(c1_, q0), with(c0_, q1) + i * (with(c1_, q0) + w * with(c1_, q1)),
             with(c0_, q2) + i * (Extended(2) * with(c1_, q1) + w * with(c1_, q2))};
    const auto size = [&](const ExtendedVector& q) -> Extended { return (c0_.cwiseAbs() + w * c1_.cwiseAbs()).dot(q.cwiseAbs()); };
    jet.terms = {size(q0), size(q1)};
    for (int k = 0; k < derivative_; ++k) {
      jet.terms = {w * jet.terms[0], w * jet.terms[1] + jet.terms[0]};
      jet.y = {i * w * jet.y[0], i * (jet.y[0] + w * jet.y[1]), i * (Extended(2) * jet.y[1] + w * jet.y[2])};
    }
    return jet;
  }

 private:
  int derivative_;
  Eigen::VectorXd d_;
  ExtendedMatrix A_, B_, K_;
  ExtendedVector h_, c0_, c1_;
};

}  // namespace

RefinedPeak refine_peak(const assembly::Assembled& assembled, const assembly::Channel& channel, const Eigen::VectorXcd& load, double omega,
                        double reach) {
  constexpr int most_steps = 8;
  constexpr Extended unit_round_off = std::numeric_limits<double>::epsilon() / 2;
  const Curve curve(assembled, channel, load);
  RefinedPeak result;
  Extended w = omega;
  Jet jet = curve.at(w);
  Extended previous = std::numeric_limits<Extended>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const Extended gradient = std::real(std::conj(jet.y[0]) * jet.y[1]);
    const Extended curvature = std::norm(jet.y[1]) + std::real(std::conj(jet.y[0]) * jet.y[2]);
    const Extended change = -gradient / curvature;
    if (!(curvature < 0) || !std::isfinite(change) || std::abs(w + change - Extended(omega)) > Extended(reach)) break;
    result.frequency_uncertainty =
        static_cast<double>(unit_round_off * (std::abs(jet.y[0]) * jet.terms[1] + std::abs(jet.y[1]) * jet.terms[0]) / -curvature);
    if (std::abs(change) >= Extended(0.5) * previous) {
      result.converged = std::abs(change) <= Extended(result.frequency_uncertainty) + Extended(1e-12) * w;
      break;
    }
    w += change;
    jet = curve.at(w);
    previous = std::abs(change);
    if (previous <= Extended(1e-17) * w) {
      result.converged = true;
      break;
    }
  }
  result.angular_frequency = static_cast<double>(w);
  result.amplitude = static_cast<double>(std::abs(jet.y[0]));
  result.amplitude_uncertainty = static_cast<double>(unit_round_off * jet.terms[0]);
  return result;
}

}  // namespace trivet::response
