// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample_tally.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"

namespace trivet::study {
namespace {

template <typename Number>
void add_all(std::vector<Number>& to, const std::vector<Number>& from) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
}

}  // namespace

std::optional<double> value_at_margin(const RequirementResult& requirement, double margin) {
  using enum RequirementKind;
  switch (requirement.kind) {
    case amplitude:
    case operation:
    case isolation:
    case steady:
    case rms:
    case largest:
    case static_value:
    case mount_deflection:
    case mount_dynamic_deflection:
    case mount_shock_deflection:
      return requirement.allowed / margin;
    case damping_ratio:
      if (margin == 0) return std::nullopt;
      [[fallthrough]];
    case separation:
    case decoupling:
      return requirement.allowed * margin;
    default:
      return std::nullopt;
  }
}

SampleTally::SampleTally(const std::vector<SampledCase>& cases, std::size_t replicates,
                         const SampleMagnitudes& magnitudes)
    : designs(replicates), met(replicates), in_kernels(cases.size()), one_by_one(cases.size()), cases_(cases) {
  for (std::size_t c = 0; c < cases.size(); ++c) {
    bands.emplace_back(cases[c].bands() ? cases[c].bands()->values() : 0);
    auto& tallies = of.emplace_back();
    for (std::size_t r = 0; r < cases[c].given().size(); ++r) {
      RequirementTally& one = tallies.emplace_back();
      one.met.resize(replicates);
      one.values = numerics::ExactSum(magnitudes[c][r].value);
      one.squares = numerics::ExactSum(magnitudes[c][r].square);
    }
  }
}

std::string SampleTally::failure(Eigen::Index row, const std::vector<SampledMargins>& margins) {
  for (const SampledMargins& one : margins)
    if (!one.failures[to_size(row)].empty()) return one.failures[to_size(row)];
  return "";
}

void SampleTally::add(const DrawnDesigns& drawn, std::uint64_t first, const std::vector<SampledMargins>& margins) {
  for (std::size_t c = 0; c < margins.size(); ++c) {
    in_kernels[c] += margins[c].in_kernels;
    one_by_one[c] += margins[c].one_by_one;
  }
  for (std::size_t i = 0; i < margins.front().failures.size(); ++i) {
    const std::uint64_t design = first + i;
    const std::size_t replicate = drawn.replicate(design);
    ++designs[replicate];
    if (const std::string why = failure(to_index(i), margins); why.empty()) {
      add_judged(replicate, design, to_index(i), margins);
    } else {
      if (kept.keeps(design, false)) kept.add(design, {});
      if (failed++ > 0 && design >= first_failed) continue;
      first_failed = design;
      first_failure = why;
    }
  }
}

void SampleTally::add_judged(std::size_t replicate, std::uint64_t design, Eigen::Index row,
                             const std::vector<SampledMargins>& margins) {
  double least_margin = std::numeric_limits<double>::infinity();
  RequirementTally* governing = nullptr;
  for (std::size_t c = 0; c < of.size(); ++c) {
    if (!bands[c].values().empty()) bands[c].add(margins[c].amplitudes.col(row), design);
    for (std::size_t r = 0; r < of[c].size(); ++r) {
      RequirementTally& one = of[c][r];
      const double margin = margins[c].margins(row, to_index(r));
      one.met[replicate] += margin >= 1;
      one.margins.add(margin);
      one.extremes.add(margin, design);
      if (!governing || margin < least_margin) governing = &one, least_margin = margin;
      if (const auto value = value_at_margin(cases_[c].given()[r], margin)) {
        one.values.add(*value);
        one.squares.add(*value * *value);
      }
    }
  }
  least.add(least_margin, design);
  if (kept.keeps(design, least_margin >= 1)) kept.add(design, margins_of_design(margins, row));
  if (least_margin >= 1) ++met[replicate];
  else if (governing) ++governing->first;
}

void SampleTally::merge(const SampleTally& other) {
  add_all(designs, other.designs);
  add_all(met, other.met);
  add_all(in_kernels, other.in_kernels);
  add_all(one_by_one, other.one_by_one);
  if (other.failed > 0 && (failed == 0 || other.first_failed < first_failed)) {
    first_failed = other.first_failed;
    first_failure = other.first_failure;
  }
  failed += other.failed;
  least.merge(other.least);
  kept.merge(other.kept);
  for (std::size_t c = 0; c < bands.size(); ++c) bands[c].merge(other.bands[c]);
  for (std::size_t c = 0; c < of.size(); ++c)
    for (std::size_t r = 0; r < of[c].size(); ++r) {
      RequirementTally& to = of[c][r];
      const RequirementTally& from = other.of[c][r];
      add_all(to.met, from.met);
      to.first += from.first;
      to.margins.merge(from.margins);
      to.extremes.merge(from.extremes);
      to.values.merge(from.values);
      to.squares.merge(from.squares);
    }
}

}  // namespace trivet::study
