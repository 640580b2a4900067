// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "trivet/response/steady/model_rates.h"
#include "trivet/study/family/design_space.h"

namespace trivet::study {

/// Models next to a design, assembled and not solved, for derivatives with respect to the parameters.
///
/// Five-point formulas inside the range: exact for polynomials of the fourth degree, which factors, masses and places
/// are.
class DesignNeighbours {
 public:
  /// @param values  of the design
  /// @throws foundation::NotComputable if there is no valid model on any side of it
  DesignNeighbours(const DesignSpace& space, const project::Case& variant, const Eigen::VectorXd& values);

  [[nodiscard]] std::size_t parameters() const { return along_.size(); }
  /// Those along one parameter; weights per unit of its axis.
  [[nodiscard]] const response::WeightedModels& along(std::size_t parameter) const { return along_[parameter]; }

  /// Values of a parameter, equally spaced.
  using Nodes = std::array<double, 5>;

 private:
  struct Kept {
    std::unique_ptr<model::System> system;
    std::unique_ptr<assembly::Assembled> assembled;
  };
  void add(const DesignSpace& space, const project::Case& variant, const Eigen::VectorXd& values, std::size_t parameter,
           const Nodes& at);

  std::vector<Kept> kept_;
  std::vector<response::WeightedModels> along_;
};

}  // namespace trivet::study
