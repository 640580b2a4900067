// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/operating_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/response/random/random_bands.h"
#include "trivet/study/analyses/band_lines.h"
#include "trivet/study/analyses/operating_limits.h"
#include "trivet/study/analyses/summed_orders.h"

namespace trivet::study {
namespace {

/// A result with the lines over the requested bands that bound it.
struct LevelledResult {
  assembly::Channel channel;
  std::string quantity;
  std::vector<const project::LimitLineRequest*> lines = {};
};

std::string quantity_word(const assembly::LimitLine& line) {
  if (line.unit.starts_with("N")) return "force";
  return assembly::motion_name(quantity_of(line));
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
    found->lines.push_back(&line);
  }
  return results;
}

double limit_in(const assembly::LimitLine& line, const excitation::FrequencyBand& band) {
  return response::zero_to_peak_limit(line, read_at(band, line)) / std::numbers::sqrt2;
}

/// Adds the lowest of the lines in the band.
void judge(const std::vector<const project::LimitLineRequest*>& lines, double random, OperatingLevel& level) {
  for (const project::LimitLineRequest* request : lines) {
    const assembly::LimitLine& line = request->line;
    if (!covers(line, level.band)) continue;
    const double limit = limit_in(line, level.band);
    if (!level.line.empty() && limit >= level.limit) continue;
    level.line = line.name;
    level.limit = limit;
    level.random = random;
  }
}

/// Root mean squares of the random vibration in the bands; 0 without a line, which alone it is compared with.
std::vector<double> random_levels(const CaseContext& c, const LevelledResult& one,
                                  const std::vector<excitation::FrequencyBand>& bands) {
  std::vector<double> levels(bands.size(), 0);
  if (one.lines.empty()) return levels;
  const response::RandomLoading loading =
      response::random_loading(c.system, c.assembled, one.lines.front()->excitations);  // all lines have the same
  if (loading.inputs.empty()) return levels;
  levels = response::random_bands(c.assembled, {one.channel}, loading, bands, {}, c.progress).rms.front();
  for (std::size_t b = 0; b < bands.size(); ++b)
    if (std::isnan(levels[b]))
      throw foundation::NotComputable(
          fmt::format("limit line \"{}\": {} has no root mean square of the random "
                      "vibration in the band of {:.4g} Hz",
                      one.lines.front()->line.name, one.channel.name, bands[b].nominal_hz()));
  return levels;
}

}  // namespace

bool OperatingLevel::met() const { return line.empty() || design::meets_limit(with_random(), limit); }

double OperatingLine::margin() const { return share() > 0 ? 1 / share() : foundation::infinity; }

std::string OperatingLine::remark() const {
  std::string words;
  if (nearest && nearest->random > 0) words = "with the random vibration";
  if (nearest && outside > 0)
    words +=
        (words.empty() ? "" : ", ") + fmt::format("{} of {} bands with orders are outside the line", outside, bands);
  return words;
}

std::vector<OperatingLevel> operating_levels(const CaseContext& c, const project::OperationAnalysis& request,
                                             const std::vector<response::OrderLoading>& loads,
                                             std::vector<assembly::Channel> channels) {
  const std::vector<LevelledResult> results = levelled_results(c, request, std::move(channels));
  std::vector<assembly::Channel> all;
  for (const LevelledResult& one : results) all.push_back(one.channel);
  const SummedOrders summed(c, std::move(all), loads, fastest_range(request.speeds));
  std::vector<excitation::FrequencyBand> reached;
  for (const assembly::Band& speed : request.speeds)
    for (const excitation::FrequencyBand& band : summed.reached(*request.bands, speed))
      if (std::ranges::find(reached, band) == reached.end()) reached.push_back(band);
  std::vector<std::vector<double>> random;
  for (const LevelledResult& one : results) random.push_back(random_levels(c, one, reached));
  std::vector<OperatingLevel> levels;
  for (const assembly::Band& speed : request.speeds) {
    const std::vector<excitation::FrequencyBand> bands = summed.reached(*request.bands, speed);
    std::vector<std::vector<OperatingValue>> values;
    for (const excitation::FrequencyBand& band : bands) values.push_back(summed.largest_in(band, speed));
    for (std::size_t i = 0; i < results.size(); ++i)
      for (std::size_t b = 0; b < bands.size(); ++b) {
        if (values[b][i].order == 0) continue;  // it begins below the data of an element
        levels.push_back({speed, results[i].quantity, bands[b], std::move(values[b][i])});
        const auto place = static_cast<std::size_t>(std::ranges::find(reached, bands[b]) - reached.begin());
        judge(results[i].lines, random[i][place], levels.back());
      }
  }
  return levels;
}

std::vector<OperatingLine> operating_lines(const project::OperationAnalysis& request,
                                           const std::vector<OperatingLevel>& levels) {
  std::vector<OperatingLine> lines;
  for (const assembly::Band& speed : request.speeds)
    for (const project::LimitLineRequest& one : request.lines) {
      if (one.bands != request.bands) continue;
      OperatingLine& judged = lines.emplace_back(speed, one.of, one.line);
      for (const OperatingLevel& level : levels) {
        if (level.speed != speed || level.value.name != one.of || level.quantity != quantity_word(one.line)) continue;
        ++judged.bands;
        if (!covers(one.line, level.band)) {
          ++judged.outside;
          continue;
        }
        OperatingLevel under = level;  // which may have another, lower line
        under.line = one.line.name;
        under.limit = limit_in(one.line, level.band);
        if (!judged.nearest || under.share() > judged.share()) judged.nearest = std::move(under);
      }
    }
  return lines;
}

}  // namespace trivet::study
