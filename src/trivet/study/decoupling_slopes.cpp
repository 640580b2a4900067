// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/decoupling_slopes.h"

#include "trivet/foundation/index.h"
#include "trivet/modal/own_system.h"
#include "trivet/numerics/linalg/orthogonal.h"

namespace trivet::study {
namespace {

/// Derivatives of what the modes of a body depend on.
struct OwnRates {
  Eigen::MatrixXd A, K, energy;
};

/// @param coordinate  of `energy`
OwnRates own_rates(const response::WeightedModels& models, const modal::OwnSystem& here, std::size_t body,
                   std::size_t coordinate) {
  OwnRates rates{0 * here.matrices.A, 0 * here.matrices.K, 0 * here.energy[coordinate]};
  for (const response::WeightedModel& model : models) {
    const modal::OwnSystem there = modal::own_system(model.system->bodies()[body], *model.assembled,
                                                     modal::rows_of(*model.system, *model.assembled, body));
    rates.A += model.weight * (there.matrices.A - here.matrices.A);
    rates.K += model.weight * (there.matrices.K - here.matrices.K);
    rates.energy += model.weight * (there.energy[coordinate] - here.energy[coordinate]);
  }
  return rates;
}

/// Derivatives of a shape, one column per parameter, in scaled coordinates and with the scaled frequency as one unknown
/// more. The smallest solution leaves shapes of equal frequencies as they are.
Eigen::MatrixXd shape_changes(const modal::OwnSystem& own, const Eigen::VectorXd& shape, double lambda,
                              const std::vector<OwnRates>& rates) {
  const numerics::DynamicMatrices& m = own.matrices;
  const Eigen::Index n = m.size();
  const Eigen::VectorXd d = numerics::unit_scale(m);
  Eigen::MatrixXd bordered = Eigen::MatrixXd::Zero(n + 1, n + 1);
  bordered.topLeftCorner(n, n) = d.asDiagonal() * (m.K - lambda * m.A) * d.asDiagonal();
  const double size = bordered.cwiseAbs().maxCoeff();
  bordered /= size;
  bordered.topRightCorner(n, 1) = -(d.asDiagonal() * (m.A * shape));
  bordered.bottomLeftCorner(1, n) = (d.asDiagonal() * ((m.A + m.A.transpose()) * shape)).transpose();
  Eigen::MatrixXd right(n + 1, to_index(rates.size()));
  for (std::size_t j = 0; j < rates.size(); ++j) {
    right.col(to_index(j)).head(n) = -(d.asDiagonal() * ((rates[j].K - lambda * rates[j].A) * shape)) / size;
    right(n, to_index(j)) = -shape.dot(rates[j].A * shape);
  }
  return d.asDiagonal() * numerics::smallest_solution(bordered, right).topRows(n);
}

}  // namespace

Eigen::RowVectorXd decoupling_slopes(const CaseContext& c, const DesignNeighbours& neighbours, std::size_t body,
                                     std::size_t mode) {
  const modal::OwnSystem own =
      modal::own_system(c.system.bodies()[body], c.assembled, modal::rows_of(c.system, c.assembled, body));
  const modal::OwnModes modes = modal::own_modes(own);
  const auto k = to_index(mode);
  const Eigen::VectorXd shape = modes.shapes.col(k), moved = shape.head(own.energy[0].rows());
  Eigen::VectorXd shares(6);
  for (std::size_t j = 0; j < 6; ++j) shares(to_index(j)) = moved.dot(own.energy[j] * moved) / modes.norm(k);
  Eigen::Index purest = 0;
  const double share = shares.maxCoeff(&purest);
  std::vector<OwnRates> rates;
  for (std::size_t j = 0; j < neighbours.parameters(); ++j)
    rates.push_back(own_rates(neighbours.along(j), own, body, to_size(purest)));
  const Eigen::MatrixXd& energy = own.energy[to_size(purest)];
  const Eigen::MatrixXd changes = shape_changes(own, shape, modes.lambda(k), rates).topRows(moved.size());
  Eigen::RowVectorXd slopes = moved.transpose() * (energy + energy.transpose()) * changes;
  for (std::size_t j = 0; j < rates.size(); ++j) slopes(to_index(j)) += moved.dot(rates[j].energy * moved);
  return slopes / (modes.norm(k) * share);
}

}  // namespace trivet::study
