// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/analysis_results.h"

#include <algorithm>
#include <array>
#include <map>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/study/analyses/analysis_run.h"

namespace trivet::study {
namespace {

/// 0 … 5 for a motion along x … about z, none for a force or a relative motion.
std::optional<std::size_t> axis_of(const assembly::Channel& channel) {
  if (!channel.unit.starts_with("m") && !channel.unit.starts_with("rad")) return std::nullopt;
  const std::string component = channel.name.substr(channel.name.rfind('.') + 1);
  const auto at = std::ranges::find(model::coordinate_names, component);
  if (at == model::coordinate_names.end()) return std::nullopt;
  return to_size(at - model::coordinate_names.begin());
}

/// Total values of every body or point with all three translations requested, with the requested rotations; none if one
/// of these has no value.
std::vector<TotalValue> total_values(const std::vector<assembly::Channel>& channels,
                                     const response::RandomResponse& response,
                                     const std::array<excitation::WeightedAxis, 6>& axes) {
  struct Felt {
    std::vector<double> accelerations, factors;
    std::vector<std::string> axes;
    std::size_t translations = 0;
    bool complete = true;
  };
  std::map<std::string, Felt> groups;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto axis = axis_of(channels[i]);
    const response::RandomChannel& channel = response.channels[i];
    if (!axis || axes[*axis].k == 0) continue;
    Felt& felt = groups[channels[i].name.substr(0, channels[i].name.rfind('.'))];
    felt.complete = felt.complete && (channel.weighted_rms || channel.vanishes);
    felt.accelerations.push_back(channel.weighted_rms.value_or(0));
    felt.factors.push_back(axes[*axis].k);
    felt.axes.emplace_back(model::coordinate_names[*axis]);
    felt.translations += *axis < 3;
  }
  std::vector<TotalValue> totals;
  for (const auto& [name, felt] : groups)
    if (felt.translations == 3 && felt.complete)
      totals.push_back({name, excitation::vibration_total_value(felt.accelerations, felt.factors), felt.axes});
  return totals;
}

RandomResult random_result(const CaseContext& c, const project::RandomAnalysis& request, foundation::Problems&) {
  const std::vector<assembly::Channel> channels = channels_of(c, request.selection);
  const response::RandomLoading loading =
      response::random_loading(c.system, c.assembled, request.selection.excitations);
  if (loading.inputs.empty()) throw without_excitation("random");
  response::RandomOptions options;
  const auto axes =
      request.contact ? excitation::comfort_axes(*request.contact) : std::array<excitation::WeightedAxis, 6>{};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto axis = axis_of(channels[i]);
    if (request.contact && axis) options.weighted.push_back({i, axes[*axis].weighting});
    else if (request.weighting && !request.contact && !channels[i].unit.starts_with("N"))
      options.weighted.push_back({i, *request.weighting});
  }
  RandomResult result;
  result.quantity = request.selection.quantity;
  for (const response::RandomInput& input : loading.inputs) result.inputs.push_back(input.name);
  result.response = response::random_response(c.assembled, channels, loading, options, c.progress);
  if (request.contact) result.total_values = total_values(channels, result.response, axes);
  result.curves = response::random_curves(c.assembled, channels, loading, {}, c.progress);
  if (request.bands) {
    const auto bands = excitation::bands_between(*request.bands, result.response.from, result.response.to);
    result.bands = response::random_bands(c.assembled, channels, loading, bands, {}, c.progress);
  }
  return result;
}

}  // namespace

const AnalysisRun random_run =
    computed_by<&project::Analyses::random, &CaseResults::random, random_result>("RMS values under random excitation");

}  // namespace trivet::study
