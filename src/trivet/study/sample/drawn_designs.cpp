// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/drawn_designs.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/sampling/counter_numbers.h"

namespace trivet::study {
namespace {

numerics::GaussianCopula copula_of(const std::vector<project::Tolerance>& tolerances,
                                   const std::vector<std::size_t>& first, std::size_t draws) {
  std::vector<numerics::GaussianCopula::Correlation> correlations;
  for (std::size_t t = 0; t < tolerances.size(); ++t)
    for (const project::Tolerance::Correlation& one : tolerances[t].correlations) {
      const auto other = std::ranges::find(tolerances, one.with, &project::Tolerance::name) - tolerances.begin();
      correlations.push_back({first[t], first[to_size(other)], one.value});
    }
  return {draws, correlations};
}

std::vector<std::size_t> first_draws(const std::vector<project::Tolerance>& tolerances) {
  std::vector<std::size_t> first = {0};
  for (const project::Tolerance& one : tolerances) first.push_back(first.back() + one.draws());
  return first;
}

}  // namespace

DrawnDesigns::DrawnDesigns(const std::vector<project::Tolerance>& tolerances, const project::SampleRequest& request)
    : tolerances_(tolerances),
      seed_(request.seed),
      first_(first_draws(tolerances)),
      copula_(copula_of(tolerances, first_, first_.back())) {
  for (std::size_t t = 0; t < tolerances.size(); ++t) of_.insert(of_.end(), tolerances[t].draws(), t);
  if (of_.size() > numerics::SobolNumbers::most_dimensions)
    throw foundation::InvalidInput(fmt::format("tolerances: {} numbers vary from design to design; at most {}",
                                               of_.size(), numerics::SobolNumbers::most_dimensions));
  for (std::size_t r = 0; request.sobol && r < project::sample_replicates; ++r)
    sobol_.emplace_back(of_.size(), seed_, r);
}

DrawnName DrawnDesigns::name(std::size_t draw) const {
  const project::Tolerance& tolerance = tolerances_[of_[draw]];
  return {tolerance.name, tolerance.draws() == 1 ? "" : "at " + tolerance.places[draw - first_[of_[draw]]].path};
}

Eigen::MatrixXd DrawnDesigns::draw(std::uint64_t first, std::size_t count) const {
  Eigen::MatrixXd designs(to_index(count), to_index(draws()));
  Eigen::VectorXd shares(to_index(draws()));
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t design = first + i;
    if (sobol_.empty())
      for (std::size_t d = 0; d < draws(); ++d)
        shares(to_index(d)) = numerics::random_number(seed_, design, static_cast<std::uint32_t>(d));
    else sobol_[replicate(design)].set_point(design / replicates(), {shares.data(), draws()});
    copula_.correlate(shares);
    for (std::size_t d = 0; d < draws(); ++d)
      designs(to_index(i), to_index(d)) = numerics::quantile(distribution(d), shares(to_index(d)));
  }
  return designs;
}

}  // namespace trivet::study
