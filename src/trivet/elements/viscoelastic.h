// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <string>
#include <variant>
#include <vector>

#include "trivet/foundation/problems.h"

/// Linear viscoelastic laws K*(ω) = K · m(ω) on any stiffness K. The relative modulus m is 1 at ω = 0: K is the relaxed
/// (long-term) stiffness. Signals e^{+iωt}, s = iω. Formulas, passivity and sources: docs/elements/viscoelastic.md.
namespace trivet::elements {

/// m = 1 + s τ: a dashpot in parallel with the spring. time τ [s] > 0.
struct KelvinVoigt {
  double time = 0;
};
/// m = 1 + g sτ/(1 + sτ): a Maxwell branch in parallel with the spring. ratio g = k_branch/K ≥ 0, time τ [s] > 0.
struct Zener {
  double ratio = 0;
  double time = 0;
};
/// m = 1 + Σ g_i sτ_i/(1 + sτ_i) (Prony series). g_i = k_i/K ≥ 0, times τ_i [s] > 0.
struct GeneralizedMaxwell {
  std::vector<double> ratios;
  std::vector<double> times;
};
/// m = 1 + g (sτ)^α/(1 + (sτ)^α). ratio g ≥ 0, time τ [s] > 0, order 0 < α ≤ 1.
struct FractionalZener {
  double ratio = 0;
  double time = 0;
  double order = 1;
};
using Viscoelastic = std::variant<KelvinVoigt, Zener, GeneralizedMaxwell, FractionalZener>;

/// m at the angular frequency ω [rad/s], complex or real: analytic for Re ω > 0 (everywhere except at its poles if the
/// law is rational), the principal branch of (iωτ)^α, and 1 at ω = 0. Negative real ω give the conjugate.
[[nodiscard]] std::complex<double> relative_modulus(const Viscoelastic& law, std::complex<double> angular_frequency);

/// m(s) = 1 + viscous_time · s + Σ ratios_i s times_i/(1 + s times_i), all numbers ≥ 0, so that it is passive; each
/// term is one extra state per deformation mode of the element.
struct RationalForm {
  double viscous_time = 0;  ///< [s]
  std::vector<double> ratios;
  std::vector<double> times;  ///< [s]
  double worst_error = 0;     ///< largest |m − m_law|/|m_law| over the requested band; 0 if exact
};
[[nodiscard]] std::complex<double> relative_modulus(const RationalForm& form, std::complex<double> angular_frequency);

/// The law as a rational function: exact except for the fractional law, which is fitted over [from, to] [rad/s], 0 <
/// from < to, with the fewest terms per decade that bring worst_error below `accuracy`. If even the densest series is
/// not accurate enough, worst_error exceeds `accuracy`.
/// @throws InvalidInput for an empty band or a law that check() rejects
[[nodiscard]] RationalForm rational_form(const Viscoelastic& law, double from, double to, double accuracy = 1e-3);

/// Errors of an unphysical law: it is passive and causal if every time is > 0, every ratio ≥ 0, the order in (0, 1].
[[nodiscard]] foundation::Problems check(const Viscoelastic& law);

/// "Kelvin–Voigt", "Zener", "generalized Maxwell", "fractional Zener".
[[nodiscard]] std::string name(const Viscoelastic& law);

/// "Zener, ratio 0.5, time 0.01 s".
[[nodiscard]] std::string law_description(const Viscoelastic& law);

}  // namespace trivet::elements
