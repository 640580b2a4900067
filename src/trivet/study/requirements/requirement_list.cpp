// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_list.h"

#include <fmt/format.h>

#include <iterator>
#include <numeric>
#include <utility>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/study/explain/explanation.h"

namespace trivet::study {

RequirementCurve requirement_curve(const model::System& system, const assembly::Assembled& assembled,
                                   const RequirementResult& result) {
  if (result.order > 0) {
    for (const response::OrderLoading& one : response::order_loadings(system, assembled, result.excitations))
      if (one.order == result.order)
        return {assembly::channels(system, assembled, {result.subject}, result.quantity).front(), one.loading};
    throw foundation::NotComputable(fmt::format(
        "no excitation of this model{} acts in order {:.6g} of the shaft",
        result.excitations.empty() ? "" : " among " + foundation::comma_separated(result.excitations), result.order));
  }
  if (!result.transmitted)
    return {assembly::channels(system, assembled, {result.subject}, result.quantity).front(),
            assembly::harmonic_loading(system, assembled, result.excitations)};
  const RequirementResult::Transmitted& of = *result.transmitted;
  if (of.force.empty()) {
    response::Transmission moved = response::displacement_transmission(system, assembled, {of.of}, of.base);
    return {std::move(moved.channels.front()), std::move(moved.loading)};
  }
  response::ExcitationTransmission forced = response::excitation_transmission(system, assembled, of.force);
  return {std::move(forced.channels.at(of.direction)), std::move(forced.loading)};
}

bool have_same_drive(const RequirementResult& a, const RequirementResult& b) {
  if (a.band != b.band || a.order != b.order || a.transmitted.has_value() != b.transmitted.has_value()) return false;
  if (!a.transmitted) return a.excitations == b.excitations;
  return a.transmitted->force == b.transmitted->force && a.transmitted->base == b.transmitted->base;
}

RequirementResult& RequirementList::add(RequirementKind kind, const std::string& subject, RequirementWords words,
                                        const std::string& unit, double allowed) {
  RequirementResult& result = results_.emplace_back();
  result.kind = kind;
  result.subject = subject;
  result.words = std::move(words);
  result.unit = unit;
  result.allowed = allowed;
  return result;
}

void RequirementList::add_bounds(const CaseContext& context, RequirementKind kind,
                                 const std::vector<project::AmplitudeLimit>& limits, const std::string& of) {
  for (const project::AmplitudeLimit& limit : limits) {
    const std::string in =
        assembly::channels(context.system, context.assembled, {limit.name}, limit.quantity).front().unit;
    RequirementResult& result =
        add(kind, limit.name, {of + limit.name, "≤ " + value_words(limit.amplitude, in)}, in, limit.amplitude);
    result.place = limit.place;
    result.level_of_limit = limit.level;
  }
}

void RequirementList::append(std::vector<RequirementResult> judged) {
  results_.insert(results_.end(), std::make_move_iterator(judged.begin()), std::make_move_iterator(judged.end()));
}

void RequirementList::attempt(std::size_t first, const std::function<void()>& compute) {
  std::vector<std::size_t> places(results_.size() - first);
  std::iota(places.begin(), places.end(), first);
  attempt(places, compute);
}

void RequirementList::attempt(const std::vector<std::size_t>& places, const std::function<void()>& compute) {
  std::string reason;
  try {
    compute();
    return;
  } catch (const foundation::NotComputable& refused) {
    reason = refused.what();
  } catch (const foundation::InvalidInput& refused) {
    reason = refused.what();
  }
  for (const std::size_t i : places) {
    results_[i].value.reset();
    results_[i].margin = 0;
    results_[i].reason = reason;
  }
}

}  // namespace trivet::study
