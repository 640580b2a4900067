// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_list.h"

#include <fmt/format.h>

#include <iterator>
#include <numeric>

#include "trivet/foundation/invalid_input.h"
#include "trivet/study/explain/explanation.h"

namespace trivet::study {

RequirementResult& RequirementList::add(RequirementKind kind, const std::string& subject, std::string words,
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
    add(kind, limit.name, fmt::format("{}{} ≤ {}", of, limit.name, value_words(limit.amplitude, in)), in,
        limit.amplitude);
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
