// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/materials.h"

/// Apparent moduli of a thin rubber layer between rigid bonded plates: Ec in axial stiffness Ec A/h, Eb in tilting
/// stiffness Eb I/h. The pressure solution models the layer as a film squeezed sideways, ∇²p − 12G/(K h²) p = −12G/h²
/// (strain), p = 0 at free edges: exact as h → 0, without the uniform stretching of a thicker layer. K may be infinite.
/// Lengths [m] > 0, results [Pa]. Sources and accuracy: docs/elements/rubber.md.
namespace trivet::elements {

/// Loaded area over free area: solid or hollow disc (the hole's wall is free), rectangular block.
[[nodiscard]] double disc_shape_factor(double radius, double hole_radius, double thickness);
[[nodiscard]] double block_shape_factor(double width_1, double width_2, double thickness);

/// 3G(1 + 2S²), in series with K (Gent and Lindley 1959).
[[nodiscard]] double gent_lindley_modulus(const Rubber& rubber, double shape_factor);
/// 3G(1 + ⅔S²), in series with K: tilting of a disc (Gent and Meinecke 1970).
[[nodiscard]] double gent_meinecke_bending_modulus(const Rubber& rubber, double shape_factor);

/// Pressure solution of a disc: K I₂(λ)/I₀(λ) and K I₃(λ)/I₁(λ), λ = S √(48 G/K).
[[nodiscard]] double disc_pressure_modulus(const Rubber& rubber, double radius, double thickness);
[[nodiscard]] double disc_pressure_bending_modulus(const Rubber& rubber, double radius, double thickness);

/// Pressure solution of a disc with a free hole.
[[nodiscard]] double ring_pressure_modulus(const Rubber& rubber, double radius, double hole_radius, double thickness);
[[nodiscard]] double ring_pressure_bending_modulus(const Rubber& rubber, double radius, double hole_radius,
                                                   double thickness);

/// Pressure solution of a rectangle; bending strains vary along width_1.
[[nodiscard]] double block_pressure_modulus(const Rubber& rubber, double width_1, double width_2, double thickness);
[[nodiscard]] double block_pressure_bending_modulus(const Rubber& rubber, double width_1, double width_2,
                                                    double thickness);

}  // namespace trivet::elements
