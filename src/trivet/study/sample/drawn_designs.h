// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "trivet/numerics/sampling/distributions.h"
#include "trivet/numerics/sampling/sobol_numbers.h"
#include "trivet/project/analyses/tolerances.h"
#include "trivet/study/sample/drawn_name.h"

namespace trivet::study {

/// The designs of a sample by their numbers: what each tolerance draws for them. A design depends on the seed and its
/// number alone.
class DrawnDesigns {
 public:
  /// @throws foundation::InvalidInput for more draws than Sobol's numbers have dimensions
  DrawnDesigns(const std::vector<project::Tolerance>& tolerances, const project::SampleRequest& request);

  [[nodiscard]] std::size_t draws() const { return of_.size(); }
  /// Independent replicates; random numbers are one. Design i belongs to replicate i modulo their number.
  [[nodiscard]] std::size_t replicates() const { return sobol_.empty() ? 1 : sobol_.size(); }
  [[nodiscard]] std::size_t replicate(std::uint64_t design) const { return design % replicates(); }

  [[nodiscard]] const numerics::Distribution& distribution(std::size_t draw) const {
    return tolerances_[of_[draw]].distribution;
  }
  [[nodiscard]] DrawnName name(std::size_t draw) const;
  /// The draw that a place of a tolerance takes.
  [[nodiscard]] std::size_t draw_of(std::size_t tolerance, std::size_t place) const {
    return first_[tolerance] + (tolerances_[tolerance].together ? 0 : place);
  }

  /// Designs × draws: ratios or deviations, see project::Tolerance.
  [[nodiscard]] Eigen::MatrixXd draw(std::uint64_t first, std::size_t count) const;

 private:
  const std::vector<project::Tolerance>& tolerances_;
  std::uint64_t seed_;
  std::vector<std::size_t> of_;     ///< tolerance of each draw
  std::vector<std::size_t> first_;  ///< first draw of each tolerance
  numerics::GaussianCopula copula_;
  std::vector<numerics::SobolNumbers> sobol_;  ///< of the replicates; empty: random numbers
};

}  // namespace trivet::study
