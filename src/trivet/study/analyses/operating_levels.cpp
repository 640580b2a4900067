// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/operating_levels.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "trivet/response/machinery/limit_line.h"
#include "trivet/study/analyses/band_lines.h"
#include "trivet/study/analyses/summed_orders.h"

namespace trivet::study {
namespace {

/// A result with the lines over the requested bands that bound it.
struct LevelledResult {
  assembly::Channel channel;
  std::string quantity;
  std::vector<const assembly::LimitLine*> lines = {};
};

std::string quantity_word(const assembly::LimitLine& line) {
  if (line.unit.starts_with("N")) return "force";
  const assembly::MotionQuantity quantity = quantity_of(line);
  return quantity == assembly::MotionQuantity::displacement ? "displacement"
      : quantity == assembly::MotionQuantity::velocity      ? "velocity"
                                                            : "acceleration";
}

std::vector<LevelledResult> levelled_results(const CaseContext& c, const project::OperationAnalysis& request,
                                             std::vector<assembly::Channel> channels) {
  std::vector<LevelledResult> results;
  for (assembly::Channel& channel : channels) {
    const char* quantity = channel.unit.starts_with("N") ? "force" : "velocity";
    results.push_back({std::move(channel), quantity});
  }
  for (const project::LimitLineRequest& line : request.lines) {
    if (line.bands != request.bands) continue;
    const std::string quantity = quantity_word(line.line);
    auto found = std::ranges::find_if(
        results, [&](const LevelledResult& one) { return one.channel.name == line.of && one.quantity == quantity; });
    if (found == results.end())
      found = results.insert(
          results.end(),
          {assembly::channels(c.system, c.assembled, {line.of}, quantity_of(line.line)).front(), quantity});
    found->lines.push_back(&line.line);
  }
  return results;
}

/// Adds the lowest of the lines in the band.
void judge(const std::vector<const assembly::LimitLine*>& lines, OperatingLevel& level) {
  for (const assembly::LimitLine* line : lines) {
    if (!covers(*line, level.band)) continue;
    const double limit = response::zero_to_peak_limit(*line, read_at(level.band, *line)) / std::numbers::sqrt2;
    if (!level.line.empty() && limit >= level.limit) continue;
    level.line = line->name;
    level.limit = limit;
  }
}

}  // namespace

std::vector<OperatingLevel> operating_levels(const CaseContext& c, const project::OperationAnalysis& request,
                                             const std::vector<response::OrderLoading>& loads,
                                             std::vector<assembly::Channel> channels) {
  const std::vector<LevelledResult> results = levelled_results(c, request, std::move(channels));
  double fastest = 0;
  for (const assembly::Band& speed : request.speeds)
    if (speed.from < speed.to) fastest = std::max(fastest, speed.to);
  std::vector<assembly::Channel> all;
  for (const LevelledResult& one : results) all.push_back(one.channel);
  const SummedOrders summed(c, std::move(all), loads, fastest);
  std::vector<OperatingLevel> levels;
  for (const assembly::Band& speed : request.speeds) {
    const std::vector<excitation::FrequencyBand> bands = summed.reached(*request.bands, speed);
    std::vector<std::vector<OperatingValue>> values;
    for (const excitation::FrequencyBand& band : bands) values.push_back(summed.largest_in(band, speed));
    for (std::size_t i = 0; i < results.size(); ++i)
      for (std::size_t b = 0; b < bands.size(); ++b) {
        levels.push_back({speed, results[i].quantity, bands[b], std::move(values[b][i])});
        judge(results[i].lines, levels.back());
      }
  }
  return levels;
}

}  // namespace trivet::study
