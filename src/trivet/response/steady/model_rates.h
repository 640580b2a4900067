// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"

namespace trivet::response {

/// An assembled model next to another one, with its weight in a difference formula. The derivative with respect to a
/// parameter of anything that needs no solution is the sum of weight × its value; the weights sum to 0.
struct WeightedModel {
  double weight = 0;  ///< [1/unit of the parameter]
  const model::System* system = nullptr;
  const assembly::Assembled* assembled = nullptr;
};

/// The models for the derivative with respect to one parameter.
using WeightedModels = std::vector<WeightedModel>;

/// Derivatives of the matrices of a system; K_loss is zero without loss factors.
struct MatrixRates {
  Eigen::MatrixXd A, B, K, K_loss;
};

[[nodiscard]] MatrixRates matrix_rates(const WeightedModels& models, const assembly::Assembled& here);

}  // namespace trivet::response
