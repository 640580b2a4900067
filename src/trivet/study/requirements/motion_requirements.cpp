// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "trivet/foundation/constants.h"
#include "trivet/nonlinear/machine/static_machine.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

using assembly::MotionQuantity;
using foundation::infinity;

class MotionRequirements {
 public:
  MotionRequirements(const CaseContext& context, const project::Analyses& analyses, foundation::Problems& warnings,
                     RequirementList& list)
      : c_(context), analyses_(analyses), warnings_(warnings), list_(list) {}

  void add_rms(const std::vector<project::AmplitudeLimit>& limits) {
    if (limits.empty()) return;
    const std::size_t first = list_.size();
    list_.add_bounds(c_, RequirementKind::rms, limits, "rms of ");
    list_.attempt(first, [&] {
      const auto& request = analyses_.random;
      const response::RandomLoading loading = response::random_loading(
          c_.system, c_.assembled, request ? request->selection.excitations : std::vector<std::string>());
      if (loading.inputs.empty()) throw without_excitation("random");
      std::vector<assembly::Channel> channels;
      for (const project::AmplitudeLimit& limit : limits)
        channels.push_back(assembly::channels(c_.system, c_.assembled, {limit.name}, limit.quantity).front());
      const response::RandomResponse found =
          response::random_response(c_.assembled, channels, loading, {}, c_.progress);
      for (std::size_t i = 0; i < limits.size(); ++i) {
        const response::RandomChannel& channel = found.channels[i];
        RequirementResult& result = list_[first + i];
        result.quantity = limits[i].quantity;
        if (request) result.excitations = request->selection.excitations;
        if (request && (request->weighting || request->contact)) result.detail = "unweighted";
        if (channel.rms || channel.vanishes || channel.infinite_rms) {
          result.value = channel.infinite_rms ? infinity : channel.rms.value_or(0);
          result.margin = margin_of(result.allowed, *result.value);
        } else {
          result.reason = channel.reason;
        }
      }
    });
  }

  void add_largest(const std::vector<project::AmplitudeLimit>& limits) {
    for (const MotionQuantity quantity : assembly::motion_quantities) {
      std::vector<project::AmplitudeLimit> same;
      std::ranges::copy_if(limits, std::back_inserter(same),
                           [&](const auto& limit) { return limit.quantity == quantity; });
      if (same.empty()) continue;
      const std::size_t first = list_.size();
      list_.add_bounds(c_, RequirementKind::largest, same, "largest ");
      list_.attempt(first, [&] { set_largest(first, same, quantity); });
    }
  }

  void set_largest(std::size_t first, const std::vector<project::AmplitudeLimit>& limits, MotionQuantity quantity) {
    project::TransientAnalysis request = analyses_.transient.value_or(project::TransientAnalysis());
    request.selection.quantity = quantity;
    request.selection.of.clear();
    for (const project::AmplitudeLimit& limit : limits) request.selection.of.push_back(limit.name);
    const TransientResult found = transient_result(c_, request, warnings_);
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const response::TimeCurve& curve = found.response.curves[i];
      const bool upwards = std::abs(curve.largest.value) >= std::abs(curve.smallest.value);
      const response::Extreme& extreme = upwards ? curve.largest : curve.smallest;
      RequirementResult& result = list_[first + i];
      result.value = std::abs(extreme.value);
      result.time = extreme.time;
      result.margin = margin_of(result.allowed, extreme.value);
    }
  }

  void add_static(const std::vector<project::AmplitudeLimit>& limits) {
    if (limits.empty()) return;
    const std::size_t first = list_.size();
    list_.add_bounds(c_, RequirementKind::static_value, limits, "at rest ");
    list_.attempt(first, [&] {
      const nonlinear::StaticMachine held = nonlinear::static_machine(c_.system, c_.assembled);
      std::vector<std::string> words;
      for (const project::AmplitudeLimit& limit : limits) words.push_back(limit.name);
      const response::StaticResponse rest = response::static_response(held.system, held.assembled, words);
      for (std::size_t i = 0; i < limits.size(); ++i) {
        const double creep = creep_in(c_.system, limits[i].name);
        RequirementResult& result = list_[first + i];
        // One value for both where a result has a limit and is minimised.
        const auto found = std::ranges::find(rest.values, limits[i].name, &response::StaticValue::name);
        result.value = creep * std::abs(found->value);
        result.margin = margin_of(result.allowed, *result.value);
        if (creep > 1) result.detail = fmt::format("with its creep factor {:.4g}", creep);
      }
    });
  }

 private:
  const CaseContext& c_;
  const project::Analyses& analyses_;
  foundation::Problems& warnings_;
  RequirementList& list_;
};

}  // namespace

double creep_in(const model::System& system, const std::string& name) {
  for (const model::Element& element : system.elements())
    if (element.creep > 1 && name.starts_with(element.name + ".deflection.")) return element.creep;
  return 1;
}

void set_largest(const CaseContext& context, const project::Analyses& analyses, foundation::Problems& warnings,
                 std::size_t first, const std::vector<project::AmplitudeLimit>& limits, RequirementList& list) {
  MotionRequirements(context, analyses, warnings, list).set_largest(first, limits, MotionQuantity::displacement);
}

void add_motion_requirements(const CaseContext& context, const project::Analyses& analyses,
                             foundation::Problems& warnings, RequirementList& list) {
  if (!analyses.requirements) return;
  MotionRequirements motions(context, analyses, warnings, list);
  motions.add_rms(analyses.requirements->rms);
  motions.add_largest(analyses.requirements->largest);
  motions.add_static(analyses.requirements->statics);
}

}  // namespace trivet::study
