// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/law.h"
#include "trivet/elements/materials.h"
#include "trivet/foundation/problems.h"

namespace trivet::elements {

/// Cross-section with principal axes e1, e2 and its shear centre at the centroid. Index 1: bending about e1 (deflection
/// along e2), shear along e1.
struct Section {
  double area = 0;                    ///< [m²]
  double moment_1 = 0, moment_2 = 0;  ///< ∫ y² dA about e1, ∫ x² dA about e2 [m⁴]
  double torsion_constant = 0;        ///< Saint-Venant J [m⁴]; rotary inertia about e3 is moment_1 + moment_2
  double shear_factor_1 = 1, shear_factor_2 = 1;  ///< κ in κGA; infinity = Euler–Bernoulli
};

/// Shear factors by Cowper 1966 for Poisson's ratio E/2G − 1; the torsion constant of the rectangle is a series
/// (accuracy 1e-10).
[[nodiscard]] Section round_section(double diameter, const Metal& metal);
[[nodiscard]] Section tube_section(double outer_diameter, double inner_diameter, const Metal& metal);
[[nodiscard]] Section rectangular_section(double width_1, double width_2, const Metal& metal);

/// Straight uniform Timoshenko beam along e3, N at 0, K at (0, 0, length), both clamped to their bodies.
struct Beam {
  Metal metal;
  Section section;
  double length = 0;  ///< [m]
};

/// Exact static stiffness 12×12.
[[nodiscard]] Matrix12 beam_stiffness(const Beam& beam);
/// Consistent 12×12 mass matrix, with rotary inertia, of the static deflection shapes [kg, kg m, kg m²]. Natural
/// frequencies of the beam itself are too high: docs/elements/beam.md states how many beams in series a band needs.
[[nodiscard]] Matrix12 beam_mass(const Beam& beam);
/// What an axial tension adds to the stiffness, per newton [1/m, 1, m]: ∫ w′ᵀw′ dz of the static deflection shapes, and
/// the polar radius of gyration squared over the length in torsion. First order in the tension: of a clamped-free
/// column it gives a buckling load 0.75 % too high. It is not 0 for rigid rotations, which rotate the tension.
[[nodiscard]] Matrix12 beam_stiffness_per_tension(const Beam& beam);
[[nodiscard]] foundation::Problems check(const Beam& beam);

/// Rod with a ball joint at each end, the reference points: its static force acts only along e3.
struct Link {
  double axial_stiffness = 0;  ///< EA/L [N/m], ≥ 0
  double length = 0;           ///< [m], > 0
  double tension = 0;          ///< static tension [N]; < 0 is compression. Lateral stiffness tension/length
};

/// Tangent stiffness 12×12, arm (0, 0, length). With tension it is not 0 for rigid rotations, which rotate the preload.
[[nodiscard]] Matrix12 link_stiffness(const Link& link);
/// The lateral stiffness per newton of tension [1/m].
[[nodiscard]] Matrix12 link_stiffness_per_tension(double length);
/// Forces on the two ends in equilibrium with the static tension [N, N m].
[[nodiscard]] spatial::Vector12 link_preload(const Link& link);
[[nodiscard]] foundation::Problems check(const Link& link);

}  // namespace trivet::elements
