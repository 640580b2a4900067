// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/design_neighbours.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::study {
namespace {

using Nodes = DesignNeighbours::Nodes;
/// Distance of neighbours, as a share of the range or, with logarithmic spacing, of the value.
constexpr double distance = 1e-4;

/// Weights of d/dx at `x` of the polynomial through the values at `at`.
Nodes derivative_weights(const Nodes& at, double x) {
  Nodes weights{};
  for (std::size_t i = 0; i < at.size(); ++i)
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (k == i) continue;
      double term = 1 / (at[i] - at[k]);
      for (std::size_t j = 0; j < at.size(); ++j)
        if (j != i && j != k) term *= (x - at[j]) / (at[i] - at[j]);
      weights[i] += term;
    }
  return weights;
}

/// Five equally spaced values inside the range: around the given one where there is room, else above or below it.
std::vector<Nodes> stencils(const project::DesignAxis& axis, double value) {
  const double step = distance * (axis.logarithmic ? value : axis.to - axis.from);
  std::vector<Nodes> result;
  for (const double below : {2.0, 0.0, 4.0}) {
    const double first = std::clamp(value - below * step, axis.from, axis.to - 4 * step);
    Nodes& at = result.emplace_back();
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = first + static_cast<double>(i) * step;
  }
  return result;
}

}  // namespace

DesignNeighbours::DesignNeighbours(const DesignSpace& space, const project::Case& variant,
                                   const Eigen::VectorXd& values)
    : along_(space.size()) {
  for (std::size_t j = 0; j < space.size(); ++j) {
    const project::DesignAxis& axis = space.axes()[j];
    const double value = values(to_index(j));
    const auto choices = stencils(axis, value);
    for (std::size_t i = 0; i < choices.size(); ++i) {
      try {  // next to a design there may be no valid model
        add(space, variant, values, j, choices[i]);
        break;
      } catch (const foundation::NotComputable&) {
        if (i + 1 == choices.size()) throw;
      }
    }
  }
}

void DesignNeighbours::add(const DesignSpace& space, const project::Case& variant, const Eigen::VectorXd& values,
                           std::size_t parameter, const Nodes& at) {
  const Nodes weights = derivative_weights(at, values(to_index(parameter)));
  double largest = 0;
  for (const double weight : weights) largest = std::max(largest, std::abs(weight));
  constexpr double negligible = 1e-9;  // the middle of a symmetric formula
  along_[parameter].clear();
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (std::abs(weights[i]) <= negligible * largest) continue;
    Eigen::VectorXd moved = values;
    moved(to_index(parameter)) = at[i];
    Kept& kept = kept_.emplace_back();
    kept.system = std::make_unique<model::System>(space.system(variant, moved));
    kept.assembled = std::make_unique<assembly::Assembled>(assembly::assemble(*kept.system));
    along_[parameter].push_back({weights[i], kept.system.get(), kept.assembled.get()});
  }
}

}  // namespace trivet::study
