// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/objectives.h"

#include <algorithm>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::study {

Objectives::Objectives(const project::OptimizeRequest& request)
    : kind_(request.minimized),
      names_(request.front.empty() ? request.minimize : request.front),
      quantity_(request.quantity),
      weights_(request.weights),
      separate_(!request.front.empty() || !request.weights.empty()) {}

void Objectives::add_to(project::Analyses& analyses) {
  if (!any()) return;
  if (!analyses.requirements) {
    analyses.requirements.emplace();
    if (analyses.response) analyses.requirements->band = analyses.response->band;
  }
  project::Requirements& required = *analyses.requirements;
  if (kind_ == project::Minimized::isolation) {  // as requirements, and again as objectives
    const std::vector<project::Isolation> again = required.isolation;
    required.isolation.insert(required.isolation.end(), again.begin(), again.end());
    return;
  }
  const bool amplitudes = kind_ == project::Minimized::amplitude;
  std::vector<project::AmplitudeLimit>& list = amplitudes ? required.limits
      : kind_ == project::Minimized::rms                  ? required.rms
                                                          : required.statics;
  const bool same_quantity = !analyses.response || analyses.response->selection.quantity == quantity_;
  std::size_t& limited = limited_.emplace_back(0);
  for (const std::string& name : names_) {
    double allowed = 0;
    for (const project::AmplitudeLimit& limit : list)
      if (limit.name == name && limit.quantity == quantity_ && limit.has_common_scope()) allowed = limit.amplitude;
    for (const project::Limit& limit : analyses.limits)
      if (amplitudes && limit.name == name && same_quantity) allowed = limit.amplitude;
    if (allowed > 0 && !are_of_front()) ++limited;
    list.push_back({name, quantity_, allowed > 0 && !are_of_front() ? allowed : 1, {}, {}, {}});
  }
}

RequirementKind Objectives::requirement_kind() const {
  switch (kind_) {
    case project::Minimized::amplitude:
      return RequirementKind::amplitude;
    case project::Minimized::rms:
      return RequirementKind::rms;
    case project::Minimized::isolation:
      return RequirementKind::isolation;
    case project::Minimized::at_rest:
    case project::Minimized::price:  // no results
      break;
  }
  return RequirementKind::static_value;
}

void Objectives::find_in(const std::vector<RequirementResult>& given) {
  if (kind_ == project::Minimized::isolation) find_isolations_in(given);
  std::size_t end = 0;
  for (std::size_t r = 0; r < given.size(); ++r)
    if (given[r].kind == requirement_kind()) end = r + 1;
  first_.push_back(end - std::min(count(), end));
}

void Objectives::find_isolations_in(const std::vector<RequirementResult>& given) {
  std::vector<std::string> names;
  for (const RequirementResult& result : given)
    if (result.kind == RequirementKind::isolation) names.push_back(result.subject);
  names.resize(names.size() / 2);  // the other half are the same as requirements
  if (!first_.empty() && names != names_)
    throw foundation::InvalidInput(
        "optimize: a case requires other isolations than the first one; name the forces in isolation = {force = …}, "
        "or leave the case out of hold_in");
  names_ = std::move(names);
  limited_.push_back(count());
}

bool Objectives::contain(const ResultPlace& place) const {
  return place.result >= first_[place.result_case] && place.result - first_[place.result_case] < count();
}

void Objectives::refuse_unlike(const std::vector<RequirementResult>& given) const {
  const auto all_of_cases = [&](std::size_t limited) {
    return std::ranges::all_of(limited_, [&](std::size_t one) { return one == limited; });
  };
  if (!any() || are_of_front() || all_of_cases(count())) return;
  bool unlike = !all_of_cases(0);
  for (std::size_t i = 0; i < count(); ++i) unlike = unlike || given[result(0, i)].unit != given[result(0, 0)].unit;
  if (unlike)
    throw foundation::InvalidInput(
        "optimize: amplitudes of different units, or some with a limit and some without (also in a case), have no "
        "common measure; give each of minimize a limit in limits = {\"BODY.x\" = \"1 mm\"} of [requirements]: then the "
        "largest share of a limit is minimised");
}

std::optional<double> Objectives::weighted_sum(const std::vector<std::vector<RequirementResult>>& found) const {
  double sum = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    double least = foundation::infinity;
    for (std::size_t c = 0; c < found.size(); ++c) {
      const RequirementResult& one = found[c][result(c, i)];
      if (!one.value) return std::nullopt;
      least = std::min(least, one.margin);
    }
    sum += weights_[i] / least;
  }
  return sum;
}

double Objectives::largest(std::size_t number, const std::vector<std::vector<RequirementResult>>& found) const {
  double largest = 0;
  for (std::size_t c = 0; c < found.size(); ++c)
    largest = std::max(largest, found[c][result(c, number)].value.value_or(0));
  return largest;
}

std::string Objectives::words(const RequirementResult& result) const {
  if (kind_ == project::Minimized::isolation) return "the transmissibility of " + result.subject;
  if (kind_ == project::Minimized::at_rest) return result.subject + " at rest";
  return (kind_ == project::Minimized::rms ? "the rms of " : "the largest amplitude of ") + result.subject;
}

}  // namespace trivet::study
