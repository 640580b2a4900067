// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/mount_sums.h"

#include <fmt/format.h>

#include "trivet/project/text/price.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

RequirementResult limit_of_sum(RequirementKind kind, std::string words, std::string unit, double allowed,
                               const std::optional<double>& sum) {
  RequirementResult result;
  result.kind = kind;
  result.words = std::move(words);
  result.unit = std::move(unit);
  result.allowed = allowed;
  result.value = sum;
  if (sum) result.margin = margin_of(allowed, *sum);
  return result;
}

}  // namespace

MountSums sums_of_mounts(const model::System& system) {
  MountSums sums;
  bool first = true;
  for (const model::Element& element : system.elements()) {
    if (!element.rating) continue;
    const auto& mass = element.rating->mass;
    const auto& price = element.rating->price;
    if (first) {
      sums = {price, mass};
      first = false;
      continue;
    }
    if (sums.mass) sums.mass = mass ? std::optional(*sums.mass + *mass) : std::nullopt;
    if (!sums.price) continue;
    if (price && price->currency == sums.price->currency) sums.price->amount += price->amount;
    else sums.price.reset();
  }
  return sums;
}

std::vector<RequirementResult> mount_sums(const model::System& system, const project::Requirements& required) {
  std::vector<RequirementResult> results;
  const MountSums sums = sums_of_mounts(system);
  if (required.price) {
    const bool same = sums.price && sums.price->currency == required.price->currency;
    RequirementResult& result = results.emplace_back(limit_of_sum(
        RequirementKind::price, "mounts cost ≤ " + project::price_words(*required.price), required.price->currency,
        required.price->amount, same ? std::optional(sums.price->amount) : std::nullopt));
    if (!same) result.reason = "price: not every mount has one in " + required.price->currency;
  }
  if (required.mass > 0) {
    RequirementResult& result = results.emplace_back(
        limit_of_sum(RequirementKind::mount_mass, fmt::format("mounts weigh ≤ {:.5g} kg", required.mass), "kg",
                     required.mass, sums.mass));
    if (!sums.mass) result.reason = "mass: not every mount has one";
  }
  return results;
}

}  // namespace trivet::study
