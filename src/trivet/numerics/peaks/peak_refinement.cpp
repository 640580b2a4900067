// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/peak_refinement.h"

#include <cmath>
#include <limits>

#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/sparse_system.h"
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

}  // namespace

/// The system in coordinates scaled to a unit mass diagonal.
struct PeakRefinement::Scaled {
  explicit Scaled(const DrivenSystem& system)
      : d(unit_scale(system.matrices)),
        system_in_units(scaled(system.matrices, d)),
        load(system.load.scaled(d)),
        given(system.given) {}

  Eigen::VectorXd d;
  SparseSystem system_in_units;
  Load load, given;
};

namespace {

/// A curve with its derivatives with respect to ω.
class Curve {
 public:
  Curve(const Eigen::VectorXd& d, const SparseSystem& system, const Load& load, const Load& given,
        const ObservedCurve& curve)
      : system_(system),
        load_(load),
        given_(given),
        terms_{d.asDiagonal() * curve.of_response.on_displacement, d.asDiagonal() * curve.of_response.on_velocity,
               d.asDiagonal() * curve.of_response.on_acceleration},
        of_given_(curve.of_given),
        derivative_(curve.derivative) {}

  /// @param factors  of Z at a nearby ω
  Jet<ExtendedComplex> at(Extended w, const SystemFactors& factors) const {
    const auto solve = [&](const ExtendedVector& b) { return system_.solution(factors, w, b); };
    const auto slope = [&](const ExtendedVector& x) { return system_.product<Extended>(1, w, x); };
    const Jet<ExtendedVector> b = load_jet(load_, w);
    Jet<ExtendedVector> q;
    q[0] = solve(b[0]);
    q[1] = solve(b[1] - slope(q[0]));
    q[2] = solve(b[2] - Extended(2) * slope(q[1]) - system_.product<Extended>(2, w, q[0]));
    Jet<ExtendedComplex> y = dot<Extended>(terms_jet(terms_, system_.size(), w), q);
    const Jet<ExtendedComplex> direct = of_given(w);
    for (std::size_t k = 0; k < 3; ++k) y[k] += direct[k];
    for (int k = 0; k < derivative_; ++k) y = time_derivative(y, w);
    return y;
  }

  /// δy = −pᵀ δZ q with pᵀ = cᵀZ⁻¹; each entry of K and ω²A changes by a real amount, each of ωB by an imaginary one,
  /// of one unit of round-off. Only the part in phase with y changes the amplitude.
  Sensitivity sensitivity(Extended w, const SystemFactors& factors) const {
    const ExtendedVector c = terms_jet(terms_, system_.size(), w)[0];
    const ExtendedVector q = system_.solution(factors, w, load_jet(load_, w)[0]);
    const ExtendedVector p = system_.symmetric()
        ? system_.solution(factors, w, c)
        : system_.solution(system_.factors(static_cast<double>(w), true), w, c, true);
    const ExtendedComplex y = ExtendedComplex(c.transpose() * q) + of_given(w)[0];
    const ExtendedComplex along = std::abs(y) > 0 ? std::conj(y) / std::abs(y) : ExtendedComplex(1);
    const Extended rate = std::pow(w, Extended(derivative_));
    Sensitivity sum;
    for (const SparseSystem::Entry& e : system_.entries()) {
      const ExtendedComplex effect = along * p(e.row) * q(e.column);
      const Extended real = std::abs(e.k) + w * w * std::abs(Extended(e.a)), imaginary = w * std::abs(Extended(e.b));
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

  const SparseSystem& system_;
  const Load &load_, &given_;
  CurveTerms terms_, of_given_;
  int derivative_;
};

}  // namespace

PeakRefinement::PeakRefinement(const DrivenSystem& system) : scaled_(std::make_shared<Scaled>(system)) {}

RefinedPeak PeakRefinement::refined(const ObservedCurve& of, double omega, double reach) const {
  constexpr int most_steps = 8;
  // Share of |y / y'|, about half the width of a peak, within which factors gain four digits a step of a solution.
  constexpr Extended nearby = 1e-4;
  const Curve curve(scaled_->d, scaled_->system_in_units, scaled_->load, scaled_->given, of);
  Extended w = omega;
  SystemFactors factors = scaled_->system_in_units.factors(omega);
  Extended factors_at = omega;
  Jet<ExtendedComplex> y = curve.at(w, factors);
  const Sensitivity sensitivity = curve.sensitivity(w, factors);
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
    if (result.converged) break;  // so near a maximum no digit of the amplitude changes any more
    if (std::abs(change) >= Extended(0.5) * previous) {
      result.converged = std::abs(change) <= Extended(result.frequency_uncertainty) + Extended(1e-12) * w;
      break;
    }
    w += change;
    if (std::abs(w - factors_at) > nearby * std::abs(y[0] / y[1])) {
      factors_at = w;
      factors = scaled_->system_in_units.factors(static_cast<double>(w));
    }
    y = curve.at(w, factors);
    previous = std::abs(change);
  }
  result.angular_frequency = static_cast<double>(w);
  result.amplitude = static_cast<double>(std::abs(y[0]));
  return result;
}

}  // namespace trivet::numerics
