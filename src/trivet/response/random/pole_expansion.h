// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/numerics/linalg/pole_residue.h"

namespace trivet::response {

/// Lowest and highest power of s that an expansion keeps: two for a motion given by its acceleration and two for a free
/// motion, times what forces of elements with mass, driven through elements with mass, bring for an acceleration.
inline constexpr int lowest_power = -4, highest_power = 8;

/// All answers to one part of a load: H_c(s) = e^{−s delay} (Σ_k residue_ck/(s − λ_k) + Σ_m power_cm s^m).
struct PoleExpansion {
  std::size_t load = 0;
  double delay = 0;                  ///< [s]
  Eigen::MatrixXcd residue;          ///< channels × poles
  Eigen::MatrixXd possible_residue;  ///< the same if all terms worked together
  Eigen::MatrixXcd power;            ///< channels × powers from `lowest_power` to `highest_power`
  Eigen::MatrixXd possible_power;
};

struct PoleExpansions {
  Eigen::VectorXcd poles;            ///< without those at 0, whose terms are powers of s
  bool real = true;                  ///< conjugate poles, next to each other, have conjugate residues
  std::vector<PoleExpansion> parts;  ///< one for each load and delay
};

/// For constant matrices. Residues may be infinite or NaN where poles are defective.
[[nodiscard]] PoleExpansions pole_expansions(const assembly::Assembled& assembled,
                                             const std::vector<assembly::Channel>& channels,
                                             const std::vector<const assembly::Loading*>& loads);

/// Of the derivative: s H(s), again over poles. So its integrals converge as fast as it falls, which ω² times those of
/// H would not.
[[nodiscard]] PoleExpansion differentiated(const PoleExpansion& part, const Eigen::VectorXcd& poles);

}  // namespace trivet::response
