// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/decoupling_slopes.h"

#include "trivet/foundation/index.h"
#include "trivet/modal/own_system.h"
#include "trivet/numerics/linalg/orthogonal.h"

namespace trivet::study {
namespace {

/// Derivatives of what the modes of a body depend on, per parameter.
std::vector<modal::OwnSystem> own_rates(const DesignNeighbours& neighbours, const modal::OwnSystem& here,
                                        std::size_t body) {
  std::vector<modal::OwnSystem> rates;
  for (std::size_t j = 0; j < neighbours.parameters(); ++j) {
    modal::OwnSystem& rate = rates.emplace_back(here);
    rate.matrices.A.setZero();
    rate.matrices.K.setZero();
    for (Eigen::MatrixXd& energy : rate.energy) energy.setZero();
    for (const response::WeightedModel& model : neighbours.along(j)) {
      const modal::OwnSystem there = modal::own_system(model.system->bodies()[body], *model.assembled,
                                                       modal::rows_of(*model.system, *model.assembled, body));
      rate.matrices.A += model.weight * (there.matrices.A - here.matrices.A);
      rate.matrices.K += model.weight * (there.matrices.K - here.matrices.K);
      for (std::size_t k = 0; k < rate.energy.size(); ++k)
        rate.energy[k] += model.weight * (there.energy[k] - here.energy[k]);
    }
  }
  return rates;
}

/// Derivatives of a shape, one column per parameter, in scaled coordinates and with the scaled frequency as one unknown
/// more. The smallest solution leaves shapes of equal frequencies as they are.
Eigen::MatrixXd shape_changes(const modal::OwnSystem& own, const Eigen::VectorXd& shape, double lambda,
                              const std::vector<modal::OwnSystem>& rates) {
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
    right.col(to_index(j)).head(n) =
        -(d.asDiagonal() * ((rates[j].matrices.K - lambda * rates[j].matrices.A) * shape)) / size;
    right(n, to_index(j)) = -shape.dot(rates[j].matrices.A * shape);
  }
  return d.asDiagonal() * numerics::smallest_solution(bordered, right).topRows(n);
}

/// Of the mode at one place.
Eigen::RowVectorXd share_slopes(const modal::OwnSystem& own, const modal::OwnModes& modes, Eigen::Index k,
                                const std::vector<modal::OwnSystem>& rates) {
  const Eigen::VectorXd shape = modes.shapes.col(k), moved = shape.head(own.energy[0].rows());
  Eigen::VectorXd shares(6);
  for (std::size_t j = 0; j < 6; ++j) shares(to_index(j)) = moved.dot(own.energy[j] * moved) / modes.norm(k);
  Eigen::Index purest = 0;
  const double share = shares.maxCoeff(&purest);
  const Eigen::MatrixXd& energy = own.energy[purest];
  const Eigen::MatrixXd changes = shape_changes(own, shape, modes.lambda(k), rates).topRows(moved.size());
  Eigen::RowVectorXd slopes = moved.transpose() * (energy + energy.transpose()) * changes;
  for (std::size_t j = 0; j < rates.size(); ++j) slopes(to_index(j)) += moved.dot(rates[j].energy[purest] * moved);
  return slopes / (modes.norm(k) * share);
}

}  // namespace

Eigen::MatrixXd decoupling_slopes(const CaseContext& c, const DesignNeighbours& neighbours, std::size_t body,
                                  const std::vector<std::size_t>& modes) {
  const modal::OwnSystem own =
      modal::own_system(c.system.bodies()[body], c.assembled, modal::rows_of(c.system, c.assembled, body));
  const modal::OwnModes found = modal::own_modes(own);
  const std::vector<modal::OwnSystem> rates = own_rates(neighbours, own, body);
  Eigen::MatrixXd slopes(to_index(modes.size()), to_index(neighbours.parameters()));
  for (std::size_t i = 0; i < modes.size(); ++i)
    slopes.row(to_index(i)) = share_slopes(own, found, to_index(modes[i]), rates);
  return slopes;
}

}  // namespace trivet::study
