// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/summed_orders.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/search/zeros_and_minima.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::study {

/// |y_k|² of the orders at one speed.
struct SummedOrders::Place {
  double speed = 0;
  Eigen::VectorXd squares;
  [[nodiscard]] double sum() const { return squares.sum(); }
};

SummedOrders::SummedOrders(const CaseContext& context, std::vector<assembly::Channel> channels,
                           const std::vector<response::OrderLoading>& loads, double fastest)
    : c_(context), channels_(std::move(channels)), loads_(loads) {
  if (!(fastest > 0) || channels_.empty()) return;
  for (const response::OrderLoading& load : loads_)
    peaks_.push_back(response::peaks(c_.assembled, channels_, load.loading, c_.modes, c_.roots(),
                                     {.search_to = load.order * fastest}, c_.progress));
}

std::vector<SummedOrders::Place> SummedOrders::places(const std::vector<assembly::Channel>& channels,
                                                      std::size_t channel, const std::vector<double>& speeds) const {
  std::vector<Place> result;
  for (const double speed : speeds) result.push_back({speed, Eigen::VectorXd::Zero(to_index(loads_.size()))});
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    std::vector<double> omega;
    for (const double speed : speeds) omega.push_back(loads_[k].order * speed);
    const response::FrequencyResponse found =
        response::frequency_response(c_.assembled, channels, loads_[k].loading, omega);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const double square = std::norm(found.curves[channel].value(to_index(i)));
      result[i].squares(to_index(k)) = std::isnan(square) ? foundation::infinity : square;
    }
  }
  return result;
}

OperatingValue SummedOrders::value_at(std::size_t channel, const Place& place) const {
  Eigen::Index most = 0;
  place.squares.maxCoeff(&most);
  return {channels_[channel].name,
          channels_[channel].unit,
          std::sqrt(0.5 * place.sum()),
          place.squares.cwiseSqrt().sum(),
          place.speed,
          loads_[to_size(most)].order};
}

std::vector<OperatingValue> SummedOrders::largest(const assembly::Band& speed) const {
  std::vector<OperatingValue> result;
  if (speed.from < speed.to) {
    for (std::size_t c = 0; c < channels_.size(); ++c) result.push_back(largest_of(c, speed));
    return result;
  }
  std::vector<Place> at(channels_.size(), {speed.from, Eigen::VectorXd::Zero(to_index(loads_.size()))});
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    const response::FrequencyResponse found =
        response::frequency_response(c_.assembled, channels_, loads_[k].loading, {loads_[k].order * speed.from});
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      const double square = std::norm(found.curves[c].value(0));
      at[c].squares(to_index(k)) = std::isnan(square) ? foundation::infinity : square;
    }
  }
  for (std::size_t c = 0; c < channels_.size(); ++c) result.push_back(value_at(c, at[c]));
  return result;
}

std::vector<double> SummedOrders::turning_speeds(std::size_t channel, const assembly::Band& speed,
                                                 std::vector<double>& unbounded) const {
  double from = speed.from;
  for (std::size_t k = 0; k < loads_.size(); ++k) from = std::max(from, peaks_[k].searched_from / loads_[k].order);
  std::vector<double> speeds = {std::min(from, speed.to), speed.to};
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    const auto add = [&](double omega, double amplitude) {
      const double at = omega / loads_[k].order;
      if (!(at >= from && at <= speed.to)) return;
      (std::isfinite(amplitude) ? speeds : unbounded).push_back(at);
    };
    for (const response::Extremum& turning : peaks_[k].turnings[channel])
      add(turning.angular_frequency, turning.amplitude);
    for (const response::Peak& peak : peaks_[k].list)
      if (peak.curve == channel) add(peak.angular_frequency, peak.amplitude);
  }
  std::ranges::sort(speeds);
  const auto repeated = std::ranges::unique(speeds);
  speeds.erase(repeated.begin(), repeated.end());
  return speeds;
}

OperatingValue SummedOrders::largest_of(std::size_t channel, const assembly::Band& speed) const {
  constexpr double proven = 1e-4;  // of the square
  constexpr std::size_t most_places = 20'000;
  const std::vector<assembly::Channel> alone = {channels_[channel]};
  std::vector<double> unbounded;
  const std::vector<double> turning = turning_speeds(channel, speed, unbounded);
  if (!unbounded.empty()) {
    Place at = places(alone, 0, {unbounded.front()}).front();
    at.squares.array() += foundation::infinity;
    return value_at(channel, at);
  }
  const auto lower = [](const Place& a, const Place& b) { return a.sum() < b.sum(); };
  std::vector<Place> known = places(alone, 0, turning);
  while (loads_.size() > 1 && known.size() < most_places) {
    const double enough = (1 + proven) * std::ranges::max_element(known, lower)->sum();
    std::vector<double> between;
    for (std::size_t i = 1; i < known.size(); ++i)
      if (known[i].squares.cwiseMax(known[i - 1].squares).sum() > enough)
        between.push_back(0.5 * (known[i - 1].speed + known[i].speed));
    if (between.empty() || !std::isfinite(enough)) break;
    std::ranges::move(places(alone, 0, between), std::back_inserter(known));
    std::ranges::sort(known, {}, &Place::speed);
  }
  auto best = std::ranges::max_element(known, lower);
  if (loads_.size() > 1 && best != known.begin() && std::next(best) != known.end() && std::isfinite(best->sum())) {
    const auto minus_sum = [&](double at) { return -places(alone, 0, {at}).front().sum(); };
    const numerics::Minimum refined =
        numerics::minimum_between(std::prev(best)->speed, std::next(best)->speed, minus_sum);
    if (-refined.value > best->sum()) return value_at(channel, places(alone, 0, {refined.at}).front());
  }
  return value_at(channel, *best);
}

}  // namespace trivet::study
