// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/summed_orders.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/search/zeros_and_minima.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::study {
namespace {

constexpr const char* undamped = "an undamped resonance";

std::vector<double> orders_of(const std::vector<response::OrderLoading>& loads) {
  std::vector<double> orders;
  for (const response::OrderLoading& load : loads) orders.push_back(load.order);
  return orders;
}

}  // namespace

void SummedOrders::Place::set(Eigen::Index order, const std::optional<std::complex<double>>& value) {
  values(order) = value.value_or(foundation::infinity);
  if (!value) reason = undamped;
}

void SummedOrders::report(std::size_t places) const {
  foundation::report_progress(c_.progress, "operation",
                              std::min(1.0, static_cast<double>(places) / static_cast<double>(most_places)));
}

SummedOrders::Place SummedOrders::nothing_at(double speed) const {
  return {speed, Eigen::VectorXcd::Zero(to_index(loads_.size()))};
}

SummedOrders::SummedOrders(const CaseContext& context, std::vector<assembly::Channel> channels,
                           const std::vector<response::OrderLoading>& loads, double fastest)
    : c_(context), channels_(std::move(channels)), loads_(loads), in_time_(orders_of(loads)) {
  if (!(fastest > 0) || channels_.empty()) return;
  for (const response::OrderLoading& load : loads_)
    peaks_.push_back(response::peaks(c_.assembled, channels_, load.loading, c_.modes, c_.roots(),
                                     {.search_to = load.order * fastest}, c_.progress));
}

SummedOrders::Counted SummedOrders::all() const {
  Counted orders(loads_.size());
  std::iota(orders.begin(), orders.end(), std::size_t{0});
  return orders;
}

std::optional<std::complex<double>> SummedOrders::value_or_limit(std::size_t channel, std::size_t load, double omega,
                                                                 std::complex<double> value) const {
  // A response with Q = 1000 changes by 1e-3 over 5e-7 of ω at most; one ∝ 1/(ω − ω₀) by three quarters.
  constexpr double beside = 1e-7, same = 1e-3;
  if (!std::isnan(std::norm(value))) return value;
  const std::vector<double> near = {omega * (1 - beside), omega * (1 + beside), omega * (1 + 4 * beside)};
  const Eigen::VectorXcd limit =
      response::frequency_response(c_.assembled, {channels_[channel]}, loads_[load].loading, near).curves[0].value;
  // Near a pole that the load excites, values differ in sign or by their distance to it.
  const double apart = (limit.array() - limit(0)).abs().maxCoeff();
  const double size = limit.cwiseAbs().maxCoeff();
  const bool finite = apart <= same * size || size <= round_off(channel, load, near[0]);
  return finite ? std::optional(0.5 * (limit(0) + limit(1))) : std::nullopt;
}

std::vector<SummedOrders::Place> SummedOrders::places(std::size_t channel, const std::vector<double>& speeds,
                                                      const Counted& orders) const {
  std::vector<Place> result;
  for (const double speed : speeds) result.push_back(nothing_at(speed));
  for (const std::size_t k : orders) {
    std::vector<double> omega;
    for (const double speed : speeds) omega.push_back(loads_[k].order * speed);
    const response::FrequencyResponse found =
        response::frequency_response(c_.assembled, {channels_[channel]}, loads_[k].loading, omega);
    for (std::size_t i = 0; i < speeds.size(); ++i)
      result[i].set(to_index(k), value_or_limit(channel, k, omega[i], found.curves[0].value(to_index(i))));
  }
  return result;
}

double SummedOrders::round_off(std::size_t channel, std::size_t load, double omega) const {
  constexpr double share = 1e-10;
  const std::vector<assembly::Channel> coordinates =
      assembly::channels(c_.system, c_.assembled, {"coordinates"}, assembly::MotionQuantity::displacement);
  double largest = 0;
  for (const response::Curve& curve :
       response::frequency_response(c_.assembled, coordinates, loads_[load].loading, {omega}).curves)
    largest = std::max(largest, std::abs(curve.value(0)));
  const bool is_force = channels_[channel].unit.starts_with('N');
  const double factor = is_force ? c_.assembled.matrices.K.cwiseAbs().maxCoeff() : 1;
  return share * factor * largest;
}

SummedOrders::Place SummedOrders::at_rest(std::size_t channel, double near, const Counted& orders) const {
  constexpr double nearer = 0.25, growth = 1.5;  // a curve ∝ ω⁻¹ grows by 4
  Place place = nothing_at(0);
  for (const std::size_t k : orders) {
    const double omega = loads_[k].order * near;
    const response::FrequencyResponse found =
        response::frequency_response(c_.assembled, {channels_[channel]}, loads_[k].loading, {0, nearer * omega, omega});
    const Eigen::VectorXd size = found.curves[0].value.cwiseAbs();
    const std::complex<double> limit = found.curves[0].value(std::isfinite(size(0)) ? 0 : 1);
    const bool grows = !std::isfinite(std::abs(limit)) ||
        (!std::isfinite(size(0)) && size(1) > growth * size(2) && size(1) > round_off(channel, k, nearer * omega));
    place.values(to_index(k)) = grows ? foundation::infinity : limit;
    if (!grows || !place.reason.empty()) continue;
    place.reason = loads_[k].loading.lowest_power() < 0
        ? "towards rest the ground, whose velocity or acceleration is given, moves without bound"
        : "towards rest the machine, which nothing holds, moves without bound";
  }
  return place;
}

double SummedOrders::searched_from(const Counted& orders) const {
  double from = 0;
  for (const std::size_t k : orders) from = std::max(from, peaks_[k].searched_from / loads_[k].order);
  return from;
}

double SummedOrders::begin(const assembly::Band& speed, const Counted& orders) const {
  const bool from_tables =
      std::ranges::any_of(c_.assembled.elements, [](const auto& map) { return map.defined_from > 0; });
  return from_tables ? std::min(std::max(speed.from, searched_from(orders)), speed.to) : speed.from;
}

OperatingValue SummedOrders::value_at(std::size_t channel, const Place& place, const Counted& orders) const {
  const Eigen::VectorXd amplitudes = place.amplitudes();
  const response::RangeInTime in_time = in_time_.range(place.values);
  const auto most = std::ranges::max_element(orders, {}, [&](std::size_t k) { return amplitudes(to_index(k)); });
  return {channels_[channel].name,
          channels_[channel].unit,
          std::sqrt(0.5 * place.sum()),
          amplitudes.sum(),
          place.speed,
          most == orders.end() ? 0 : loads_[*most].order,
          place.reason,
          in_time.peak(),
          in_time.span(),
          in_time.is_bound};
}

std::vector<OperatingValue> SummedOrders::largest(const assembly::Band& speed) const {
  if (!(speed.from < speed.to)) return at_speed(speed.from, all());
  std::vector<OperatingValue> result;
  for (std::size_t c = 0; c < channels_.size(); ++c) result.push_back(largest_of(c, speed, all()));
  return result;
}

OperatingValue SummedOrders::largest(std::size_t channel, const assembly::Band& speed, project::Level level) const {
  if (!(speed.from < speed.to)) return value_at(channel, places(channel, {speed.from}, all()).front(), all());
  const bool in_time = level != project::Level::rms && loads_.size() > 1;  // of one order all levels are shares
  return in_time ? largest_in_time(channel, speed, level) : largest_of(channel, speed, all());
}

std::vector<OperatingValue> SummedOrders::at_speed(double speed, const Counted& orders) const {
  std::vector<OperatingValue> result;
  std::vector<Place> at(channels_.size(), nothing_at(speed));
  for (const std::size_t k : orders) {
    const response::FrequencyResponse found =
        response::frequency_response(c_.assembled, channels_, loads_[k].loading, {loads_[k].order * speed});
    for (std::size_t c = 0; c < channels_.size(); ++c)
      at[c].set(to_index(k), value_or_limit(c, k, loads_[k].order * speed, found.curves[c].value(0)));
  }
  for (std::size_t c = 0; c < channels_.size(); ++c) result.push_back(value_at(c, at[c], orders));
  return result;
}

std::vector<double> SummedOrders::turning_speeds(std::size_t channel, const assembly::Band& speed,
                                                 const Counted& orders, std::vector<Resonance>& unbounded) const {
  const double from = begin(speed, orders);
  std::vector<double> speeds = {speed.to};
  if (from > 0) speeds.push_back(from);
  for (const std::size_t k : orders) {
    const auto add = [&](double omega, double amplitude) {
      const double at = omega / loads_[k].order;
      if (!(at >= from && at <= speed.to)) return;
      if (std::isfinite(amplitude)) speeds.push_back(at);
      else unbounded.push_back({at, k});
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

std::vector<SummedOrders::Place> SummedOrders::turning_places(std::size_t channel, const assembly::Band& speed,
                                                              const Counted& orders) const {
  std::vector<Resonance> unbounded;
  const std::vector<double> turning = turning_speeds(channel, speed, orders, unbounded);
  if (!unbounded.empty()) {
    Place at = places(channel, {unbounded.front().speed}, orders).front();
    at.set(to_index(unbounded.front().order), std::nullopt);
    return {at};
  }
  std::vector<Place> known = places(channel, turning, orders);
  if (begin(speed, orders) > 0) return known;
  constexpr double close = 1e-6;  // of the range
  const double from = searched_from(orders);
  known.insert(known.begin(), at_rest(channel, from > 0 ? from : close * speed.to, orders));
  return known;
}

OperatingValue SummedOrders::largest_of(std::size_t channel, const assembly::Band& speed, const Counted& orders) const {
  constexpr double proven = 1e-4;  // of the square
  const auto lower = [](const Place& a, const Place& b) { return a.sum() < b.sum(); };
  std::vector<Place> known = turning_places(channel, speed, orders);
  if (std::isinf(known.front().sum())) return value_at(channel, known.front(), orders);
  while (orders.size() > 1 && known.size() < most_places) {
    report(known.size());
    const double enough = (1 + proven) * std::ranges::max_element(known, lower)->sum();
    std::vector<double> between;
    for (std::size_t i = 1; i < known.size(); ++i)
      if (known[i].squares().cwiseMax(known[i - 1].squares()).sum() > enough)
        between.push_back(0.5 * (known[i - 1].speed + known[i].speed));
    if (between.empty() || !std::isfinite(enough)) break;
    std::ranges::move(places(channel, between, orders), std::back_inserter(known));
    std::ranges::sort(known, {}, &Place::speed);
  }
  auto best = std::ranges::max_element(known, lower);
  if (orders.size() > 1 && best != known.begin() && std::next(best) != known.end() && std::isfinite(best->sum())) {
    const auto minus_sum = [&](double at) { return -places(channel, {at}, orders).front().sum(); };
    const numerics::Minimum refined =
        numerics::minimum_between(std::prev(best)->speed, std::next(best)->speed, minus_sum);
    if (-refined.value > best->sum()) return value_at(channel, places(channel, {refined.at}, orders).front(), orders);
  }
  return value_at(channel, *best, orders);
}

}  // namespace trivet::study
