// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/design_neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/body_dynamics.h"

namespace trivet::study {
namespace {

constexpr int nodes = 5;
/// Distance of neighbours, as a share of the range or, with logarithmic spacing, of the value.
constexpr double distance = 1e-3;

/// Weights of d/dx at `x` of the polynomial through the values at `at`.
std::array<double, nodes> derivative_weights(const std::array<double, nodes>& at, double x) {
  std::array<double, nodes> weights{};
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t k = 0; k < nodes; ++k) {
      if (k == i) continue;
      double term = 1 / (at[i] - at[k]);
      for (std::size_t j = 0; j < nodes; ++j)
        if (j != i && j != k) term *= (x - at[j]) / (at[i] - at[j]);
      weights[i] += term;
    }
  return weights;
}

/// Five equally spaced values inside the range: around the given one where there is room, else above or below it.
std::vector<std::array<double, nodes>> stencils(const project::DesignAxis& axis, double value) {
  const double step = distance * (axis.logarithmic ? value : axis.to - axis.from);
  std::vector<std::array<double, nodes>> result;
  for (const double below : {2.0, 0.0, nodes - 1.0}) {
    const double first = std::clamp(value - below * step, axis.from, axis.to - (nodes - 1) * step);
    std::array<double, nodes>& at = result.emplace_back();
    for (std::size_t i = 0; i < nodes; ++i) at[i] = first + static_cast<double>(i) * step;
  }
  return result;
}

std::complex<double> with(const Eigen::VectorXcd& row, const Eigen::VectorXcd& column) {
  return row.cwiseProduct(column).sum();
}

/// One result of a model and its load, at any ω.
class DrivenResult {
 public:
  DrivenResult(const model::System& system, const assembly::Assembled& assembled, const RequirementResult& result)
      : assembled_(assembled),
        channel_(assembly::channels(system, assembled, {result.subject}, result.quantity).front()),
        load_(assembly::harmonic_loading(system, assembled, result.excitations)) {}

  [[nodiscard]] response::Dynamics at(double omega) const {
    return response::body_dynamics(
        response::dynamics(assembled_, channel_, load_, omega, response::element_jets(assembled_, omega)),
        assembled_.layout.of_bodies());
  }

 private:
  const assembly::Assembled& assembled_;
  assembly::Channel channel_;
  assembly::Loading load_;
};

/// Neighbours of a design along one parameter.
std::vector<DesignNeighbours::Neighbour> neighbours_at(const DesignSpace& space, const project::Case& variant,
                                                       const Eigen::VectorXd& values, std::size_t parameter,
                                                       const std::array<double, nodes>& at) {
  const std::array<double, nodes> weights = derivative_weights(at, values(to_index(parameter)));
  double largest = 0;
  for (const double weight : weights) largest = std::max(largest, std::abs(weight));
  constexpr double negligible = 1e-9;  // the middle of a symmetric formula
  std::vector<DesignNeighbours::Neighbour> neighbours;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (std::abs(weights[i]) <= negligible * largest) continue;
    Eigen::VectorXd moved = values;
    moved(to_index(parameter)) = at[i];
    auto system = std::make_unique<model::System>(space.system(variant, moved));
    assembly::Assembled assembled = assembly::assemble(*system);
    neighbours.push_back({weights[i], std::move(system), std::move(assembled)});
  }
  return neighbours;
}

}  // namespace

DesignNeighbours::DesignNeighbours(const DesignSpace& space, const project::Case& variant,
                                   const Eigen::VectorXd& values) {
  for (std::size_t j = 0; j < space.size(); ++j) {
    const auto choices = stencils(space.axes()[j], values(to_index(j)));
    for (std::size_t i = 0; i < choices.size(); ++i) {
      try {  // next to a design there may be no valid model
        all_.push_back(neighbours_at(space, variant, values, j, choices[i]));
        break;
      } catch (const foundation::NotComputable&) {
        if (i + 1 == choices.size()) throw;
      }
    }
  }
}

Eigen::MatrixXd DesignNeighbours::height_slopes(const CaseContext& context, const RequirementResult& result,
                                                const std::vector<double>& frequencies) const {
  const DrivenResult driven(context.system, context.assembled, result);
  std::vector<response::Dynamics> here;
  for (const double omega : frequencies) here.push_back(driven.at(omega));
  Eigen::MatrixXd slopes(to_index(frequencies.size()), to_index(all_.size()));
  for (std::size_t j = 0; j < all_.size(); ++j) {
    std::vector<response::Dynamics> change = here;
    for (std::size_t i = 0; i < here.size(); ++i) change[i].add(-1, here[i]);
    for (const Neighbour& neighbour : all_[j]) {
      const DrivenResult next(*neighbour.system, neighbour.assembled, result);
      for (std::size_t i = 0; i < here.size(); ++i) change[i].add(neighbour.weight, next.at(frequencies[i]));
    }
    for (std::size_t i = 0; i < here.size(); ++i) {
      const response::Motion motion = response::motion(here[i]);
      const Eigen::VectorXcd& q = motion.coordinates[0];
      const std::complex<double> y = motion.value[0];
      const std::complex<double> dy =
          with(response::adjoint(here[i])[0], change[i].load[0] - change[i].stiffness[0] * q) +
          with(change[i].channel[0], q) + change[i].direct[0];
      slopes(to_index(i), to_index(j)) = (std::conj(y) * dy).real() / std::norm(y);
    }
  }
  return slopes;
}

Eigen::RowVectorXd DesignNeighbours::frequency_slopes(const CaseContext& context, int number) const {
  const modal::Mode& mode = context.modes.list.at(to_size(number - 1));
  const Eigen::VectorXd& shape = mode.coordinates;
  Eigen::RowVectorXd slopes(to_index(all_.size()));
  for (std::size_t j = 0; j < all_.size(); ++j) {
    double change = 0;
    for (const Neighbour& neighbour : all_[j]) {
      const numerics::DynamicMatrices& m = neighbour.assembled.matrices;
      change += neighbour.weight * shape.dot(m.K * shape - mode.eigenvalue_squared * (m.A * shape));
    }
    slopes(to_index(j)) = change / mode.modal_mass / (2 * mode.eigenvalue_squared);
  }
  return slopes;
}

Eigen::MatrixXd DesignNeighbours::slopes(const CaseContext& context, const RequirementResult& result,
                                         const std::vector<RequirementResult::Candidate>& candidates) const {
  std::vector<double> places, minima;
  for (const RequirementResult::Candidate& candidate : candidates) {
    places.push_back(candidate.angular_frequency);
    minima.push_back(candidate.minimum_at);
  }
  Eigen::MatrixXd result_slopes(to_index(candidates.size()), to_index(all_.size()));
  switch (result.kind) {
    case RequirementKind::amplitude:
      return -height_slopes(context, result, places);
    case RequirementKind::no_peak:
      result_slopes = height_slopes(context, result, minima) - height_slopes(context, result, places);
      // margin (1 + a)/(1 + r) below 1 and a/r above, with 1 + r = peak / minimum
      for (std::size_t i = 0; i < candidates.size(); ++i)
        if (const double prominence = result.allowed / candidates[i].margin; candidates[i].margin >= 1)
          result_slopes.row(to_index(i)) *= (1 + prominence) / prominence;
      return result_slopes;
    case RequirementKind::avoided_frequencies:
      for (std::size_t i = 0; i < candidates.size(); ++i)
        result_slopes.row(to_index(i)) = (candidates[i].below ? -1 : 1) * frequency_slopes(context, candidates[i].mode);
      return result_slopes;
    case RequirementKind::separation:
      for (std::size_t i = 0; i < candidates.size(); ++i)
        result_slopes.row(to_index(i)) =
            frequency_slopes(context, candidates[i].mode + 1) - frequency_slopes(context, candidates[i].mode);
      return result_slopes;
    default:
      throw foundation::InvalidInput("DesignNeighbours: this requirement has no candidates");
  }
}

}  // namespace trivet::study
