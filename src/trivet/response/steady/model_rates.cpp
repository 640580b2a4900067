// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/model_rates.h"

namespace trivet::response {

MatrixRates matrix_rates(const WeightedModels& models, const assembly::Assembled& here) {
  const numerics::DynamicMatrices& h = here.matrices;
  const Eigen::Index n = h.size();
  MatrixRates rates;
  rates.A = rates.B = rates.K = rates.K_loss = Eigen::MatrixXd::Zero(n, n);
  // The weights sum to 0: in differences from here, entries that do not change leave no round-off.
  for (const WeightedModel& model : models) {
    const numerics::DynamicMatrices& m = model.assembled->matrices;
    rates.A += model.weight * (m.A - h.A);
    rates.B += model.weight * (m.B - h.B);
    rates.K += model.weight * (m.K - h.K);
    if (m.lossy()) rates.K_loss += model.weight * m.K_loss;
    if (h.lossy()) rates.K_loss -= model.weight * h.K_loss;
  }
  return rates;
}

}  // namespace trivet::response
