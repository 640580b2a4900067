// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/numerics/linalg/pole_residue.h"

namespace trivet::response {

/// Lowest and highest power of s in an expansion. Lowest: s⁻² of a motion given by its acceleration times s⁻² of a
/// rigid-body mode. Highest: acceleration of forces of elements with mass, driven through elements with mass.
inline constexpr int lowest_power = -4, highest_power = 8;

/// Frequency responses of all channels to one part of a load: H_c(s) = e^{−s delay} (Σ_k residue_ck/(s − λ_k) + Σ_m
/// power_cm s^m).
struct PoleExpansion {
  std::size_t load = 0;
  double delay = 0;                  ///< [s]
  Eigen::MatrixXcd residue;          ///< channels × poles
  Eigen::MatrixXd possible_residue;  ///< sums of the magnitudes of its terms
  Eigen::MatrixXcd power;            ///< channels × powers from `lowest_power` to `highest_power`
  Eigen::MatrixXd possible_power;
};

struct PoleExpansions {
  Eigen::VectorXcd poles;            ///< without those at 0, which give powers of s
  bool real = true;                  ///< conjugate poles are adjacent and have conjugate residues
  std::vector<PoleExpansion> parts;  ///< one for each load and delay
};

/// Pole expansions of all channels, for constant matrices. Residues may be infinite or NaN if poles are defective.
[[nodiscard]] PoleExpansions pole_expansions(const assembly::Assembled& assembled,
                                             const std::vector<assembly::Channel>& channels,
                                             const std::vector<const assembly::Loading*>& loads);

/// Expansion of the time derivative s H(s). Its integrals converge as fast as s H(s) decays, unlike ω² times those of
/// H.
[[nodiscard]] PoleExpansion differentiated(const PoleExpansion& part, const Eigen::VectorXcd& poles);

}  // namespace trivet::response
