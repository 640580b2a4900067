// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/uncounted_excitations.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "trivet/foundation/plain_text.h"
#include "trivet/model/operating_excitation.h"
#include "trivet/project/analyses/analysis_types.h"

namespace trivet::judging {
namespace {

using project::AmplitudeLimit;

/// Names in their order, each once.
class Names {
 public:
  void add(const std::string& name) {
    if (std::ranges::find(list_, name) == list_.end()) list_.push_back(name);
  }
  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }

 private:
  std::vector<std::string> list_;
};

/// Results whose amplitudes are limited under all harmonic excitations together.
std::vector<std::string> limited_results(const project::Analyses& request) {
  Names names;
  if (request.requirements)
    for (const AmplitudeLimit& limit : request.requirements->limits)
      if (!limit.speed && !limit.excitations) names.add(limit.name);
  for (const project::Limit& limit : request.limits) names.add(limit.name);
  return names.list();
}

/// Is this result judged under an excitation of the shaft, or a random one, by another requirement?
bool is_judged(const std::string& result, const model::Excitation& excitation, const project::Analyses& request) {
  if (!request.requirements) return false;
  if (std::holds_alternative<model::Random>(excitation.course))
    return std::ranges::find(request.requirements->rms, result, &AmplitudeLimit::name) !=
        request.requirements->rms.end() &&
        (!request.random || model::is_selected(excitation, request.random->selection.excitations));
  return std::ranges::any_of(request.requirements->limits, [&](const AmplitudeLimit& limit) {
    return limit.name == result && limit.speed &&
        model::is_selected(excitation, limit.excitations.value_or(std::vector<std::string>()));
  });
}

/// The warning of one course of excitations.
template <typename Course>
void warn_of_course(const model::System& system, const project::Analyses& request, const char* words,
                    const char* remedy, foundation::Problems& problems) {
  Names excitations, results;
  for (const std::string& result : limited_results(request))
    for (const model::Excitation& one : system.description().excitations)
      if (std::holds_alternative<Course>(one.course) && !is_judged(result, one, request)) {
        excitations.add(foundation::quoted(one.name));
        results.add(result);
      }
  if (results.list().empty()) return;
  const bool required = request.requirements && !request.requirements->limits.empty();
  problems.warning(required ? "requirements.limits" : "limits",
                   fmt::format("{} ({}) not counted for {}", words, foundation::comma_separated(excitations.list()),
                               foundation::comma_separated(results.list())),
                   "limits on amplitudes count harmonic excitations only", remedy);
}

/// An isolation that names no force counts the harmonic ones only.
void warn_of_isolation(const model::System& system, const project::Analyses& request, foundation::Problems& problems) {
  if (!request.requirements) return;
  const auto of_all_forces = [](const project::Isolation& one) { return !one.is_of_base() && one.forces.empty(); };
  if (std::ranges::none_of(request.requirements->isolation, of_all_forces)) return;
  Names orders, counted;
  for (const model::Excitation& one : system.description().excitations) {
    if (std::holds_alternative<model::Orders>(one.course)) orders.add(foundation::quoted(one.name));
    else if (model::runs_with_machine(one)) counted.add(foundation::quoted(one.name));
  }
  if (orders.list().empty() || counted.list().empty()) return;  // without counted forces it is an error
  problems.warning(
      "requirements.isolation",
      fmt::format("engine orders ({}) not counted", foundation::comma_separated(orders.list())),
      "isolation is required of harmonic forces only; the command operation lists that of each order",
      fmt::format("to judge the orders add a limit on \"ground.force.z\" to [operation.limits]; to require "
                  "isolation of harmonic forces alone write force = [{}]",
                  foundation::comma_separated(counted.list())));
}

}  // namespace

void warn_of_uncounted_excitations(const model::System& system, const project::Analyses& request,
                                   foundation::Problems& problems) {
  warn_of_course<model::Orders>(system, request, "engine orders",
                                "to judge the orders add a limit with speed for the same result", problems);
  warn_of_course<model::Random>(system, request, "random motion",
                                "to judge it add the rms of the same result to [requirements]", problems);
  warn_of_isolation(system, request, problems);
}

}  // namespace trivet::judging
