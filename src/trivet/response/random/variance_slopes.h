// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/model_rates.h"

namespace trivet::response {

/// A result under random excitations.
struct RandomResult {
  std::string channel;  ///< full name
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<std::string> excitations;  ///< empty: all
};

/// Derivatives of ln of the root mean square of a result, per parameter, for constant matrices:
///
///   dV = 2 Re ∫ Σ_jk H_j* S_jk dH_k dω,  dH_k = λᵀ(dh_k − dZ q_k) + dcᵀq_k + d direct,  Zᵀλ = c.
///
/// q_k and λ are solved once at the nodes of an integral that is graded toward the poles; after that each derivative is
/// a sum of products with the matrices ∫ s^m λ q_kᵀ, so that many parameters cost little more than one.
/// @param poles   of the system
/// @param models  per parameter
[[nodiscard]] Eigen::RowVectorXd rms_slopes(const model::System& system, const assembly::Assembled& assembled,
                                            const RandomResult& result, const Eigen::VectorXcd& poles,
                                            const std::vector<WeightedModels>& models);

}  // namespace trivet::response
