// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/peak_refinement.h"

#include <cmath>
#include <limits>

#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/numerics/peaks/jet.h"

namespace trivet::numerics {
namespace {

using Extended = long double;
using ExtendedComplex = std::complex<Extended>;
constexpr Extended unit_round_off = std::numeric_limits<double>::epsilon() / 2;

/// First-order bounds on the effect of round-off in the entries of A, B, K.
struct Sensitivity {
  Extended amplitude = 0;
  Extended value = 0;  ///< of the complex y, including its phase
};

/// A curve in coordinates scaled to a unit mass diagonal.
class Curve {
 public:
  Curve(const DrivenSystem& system, const ObservedCurve& curve)
      : d_(unit_scale(system.matrices)),
        m_(scaled(system.matrices, d_)),
        load_(system.load.scaled(d_)),
        given_(system.given),
        terms_{d_.asDiagonal() * curve.of_response.on_displacement, d_.asDiagonal() * curve.of_response.on_velocity,
               d_.asDiagonal() * curve.of_response.on_acceleration},
        of_given_(curve.of_given),
        derivative_(curve.derivative) {}

  Jet<ExtendedComplex> at(Extended w) const {
    const Jet<ExtendedMatrix> z = stiffness_jet(m_, w);
    const RefinedSolver solver(z[0]);
    const Jet<ExtendedVector> q =
        solution_jet<Extended>([&](const ExtendedVector& b) { return solver.solve(b); }, z, load_jet(load_, w));
    Jet<ExtendedComplex> y = dot<Extended>(terms_jet(terms_, m_.size(), w), q);
    const Jet<ExtendedComplex> direct = of_given(w);
    for (std::size_t k = 0; k < 3; ++k) y[k] += direct[k];
    for (int k = 0; k < derivative_; ++k) y = time_derivative(y, w);
    return y;
  }

  /// δy = −pᵀ δZ q with pᵀ = cᵀZ⁻¹; each entry of K and ω²A changes by a real amount, each of ωB by an imaginary one,
  /// of one unit of round-off. Only the part in phase with y changes the amplitude.
  Sensitivity sensitivity(Extended w) const {
    const ExtendedMatrix z = stiffness_jet(m_, w)[0], K = m_.complex_stiffness().cast<ExtendedComplex>();
    const ExtendedVector c = terms_jet(terms_, m_.size(), w)[0];
    const ExtendedVector q = RefinedSolver(z).solve(load_jet(load_, w)[0]);
    const ExtendedVector p = RefinedSolver(ExtendedMatrix(z.transpose())).solve(c);
    const ExtendedComplex y = ExtendedComplex(c.transpose() * q) + of_given(w)[0];
    const ExtendedComplex along = std::abs(y) > 0 ? std::conj(y) / std::abs(y) : ExtendedComplex(1);
    const Extended rate = std::pow(w, Extended(derivative_));
    Sensitivity sum;
    for (Eigen::Index row = 0; row < q.size(); ++row)
      for (Eigen::Index column = 0; column < q.size(); ++column) {
        const ExtendedComplex effect = along * p(row) * q(column);
        const Extended real = std::abs(K(row, column)) + w * w * std::abs(Extended(m_.A(row, column))),
                       imaginary = w * std::abs(Extended(m_.B(row, column)));
        sum.amplitude += rate * unit_round_off * (real * std::abs(effect.real()) + imaginary * std::abs(effect.imag()));
        sum.value += rate * unit_round_off * (real + imaginary) * std::abs(effect);
      }
    return sum;
  }

 private:
  Jet<ExtendedComplex> of_given(Extended w) const {
    if (of_given_.empty() || given_.vanishes()) return {};
    return dot<Extended>(terms_jet(of_given_, given_.size(), w), load_jet(given_, w));
  }

  Eigen::VectorXd d_;
  DynamicMatrices m_;
  Load load_, given_;
  CurveTerms terms_, of_given_;
  int derivative_;
};

}  // namespace

RefinedPeak refine_peak(const DrivenSystem& system, const ObservedCurve& of, double omega, double reach) {
  constexpr int most_steps = 8;
  const Curve curve(system, of);
  Extended w = omega;
  Jet<ExtendedComplex> y = curve.at(w);
  const Sensitivity sensitivity = curve.sensitivity(w);
  RefinedPeak result;
  result.amplitude_uncertainty = static_cast<double>(sensitivity.amplitude);
  // A change of the data moves the curve along the axis by about δy / y'.
  result.frequency_uncertainty =
      static_cast<double>(sensitivity.value / std::max(std::abs(y[1]), std::numeric_limits<Extended>::min()));
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

}  // namespace trivet::numerics
