// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/elements/coil_dynamics.h"

namespace trivet::elements {

/// A coil spring with the mass of its wire, reduced by the Craig–Bampton method: 12 seat motions and m natural modes
/// with both seats held, each with modal mass 1. Undamped equations in (seats, modes): stiffness diag(K, ω_k²), mass
/// [M, C; Cᵀ, I]. As D(ω) = K − ω²M − ω⁴ Σ c_k c_kᵀ/(ω_k² − ω²) this is exact for m → ∞.
struct ReducedCoil {
  Matrix12 stiffness;                   ///< K, static
  Matrix12 mass;                        ///< M, of the static shapes, dead coils included [kg, kg m, kg m²]
  Eigen::VectorXd natural_frequencies;  ///< ω_k, ascending [rad/s]
  Eigen::Matrix<double, 12, Eigen::Dynamic> coupling;  ///< c_k as columns, ∫ (static shapes)ᵀ ρ mode [√kg, √kg m]

  [[nodiscard]] Eigen::MatrixXd extended_stiffness() const;
  [[nodiscard]] Eigen::MatrixXd extended_mass() const;
};

/// @param modes  ≥ 0
[[nodiscard]] ReducedCoil reduced(const SeatedCoil& coil, int modes);
[[nodiscard]] ReducedCoil reduced(const CoilSpring& spring, int modes);

}  // namespace trivet::elements
