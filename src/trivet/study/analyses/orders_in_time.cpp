// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/search/zeros_and_minima.h"
#include "trivet/study/analyses/summed_orders.h"

/// Where several orders with their phases make the largest vibration over a range of speeds.
namespace trivet::study {
namespace {

constexpr double proven = 5e-5;  // of the largest height

}  // namespace

struct SummedOrders::Piece {
  Place from, to;
  double at_from = 0, at_to = 0;  ///< heights
  /// By how much the responses are bent: Σ of the largest |y_k − chord|. The height of responses that are straight over
  /// the speed is convex, because it is the largest of straight lines, and so largest at an end.
  double bend = 0;

  Piece(Place first, Place second, double first_height, double second_height)
      : from(std::move(first)), to(std::move(second)), at_from(first_height), at_to(second_height) {
    bend = in_phase();
  }
  /// Every |y_k| is monotonic between its extrema.
  [[nodiscard]] double in_phase() const { return from.amplitudes().cwiseMax(to.amplitudes()).sum(); }
  [[nodiscard]] double bound() const { return std::min(in_phase(), std::max(at_from, at_to) + bend); }
};

double SummedOrders::height(const Place& place, project::Level level) const {
  const response::RangeInTime range = in_time_.range(place.values);
  return level == project::Level::peak_to_peak ? range.span() / 2 : range.peak();
}

std::vector<SummedOrders::Place> SummedOrders::with_poles(std::size_t channel, std::vector<Place> known,
                                                          double above) const {
  constexpr double undamped = 1e-9;  // there is no response on such a pole; one that the orders excite is unbounded
  std::vector<double> speeds;
  for (const response::OrderLoading& load : loads_)
    for (const std::complex<double>& pole : c_.roots().poles)
      for (const double widths : {-2.0, -1.0, 0.0, 1.0, 2.0})
        if (std::abs(pole.real()) > undamped * pole.imag() && pole.imag() > 0)
          speeds.push_back((pole.imag() + widths * std::abs(pole.real())) / load.order);
  std::ranges::sort(speeds);
  std::vector<double> inside;
  for (std::size_t i = 1; i < known.size(); ++i) {
    if (known[i].amplitudes().cwiseMax(known[i - 1].amplitudes()).sum() <= above) continue;
    const auto first = std::ranges::upper_bound(speeds, known[i - 1].speed);
    std::copy(first, std::ranges::lower_bound(first, speeds.end(), known[i].speed), std::back_inserter(inside));
  }
  const auto repeated = std::ranges::unique(inside);
  inside.erase(repeated.begin(), repeated.end());
  std::ranges::move(places(channel, inside, all()), std::back_inserter(known));
  std::ranges::sort(known, {}, &Place::speed);
  return known;
}

OperatingValue SummedOrders::largest_in_time(std::size_t channel, const assembly::Band& speed,
                                             project::Level level) const {
  constexpr double share_of_bend = 0.125;  // of the whole: what two halves show may be small by chance
  std::vector<Place> known = turning_places(channel, speed, all());
  if (std::isinf(known.front().sum())) return value_at(channel, known.front(), all());
  const auto height_at = [&](const Place& place) { return height(place, level); };
  Place best = *std::ranges::max_element(known, {}, height_at);
  known = with_poles(channel, std::move(known), (1 + proven) * height_at(best));
  std::vector<double> tried, heights;
  for (const Place& one : known) {
    tried.push_back(one.speed);
    heights.push_back(height_at(one));
  }
  double highest = height_at(best);
  const auto raise = [&](const Place& place, double at) {
    if (!(at > highest)) return;
    best = place;
    highest = at;
  };
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < known.size(); ++i) {
    raise(known[i], heights[i]);
    if (i > 0) pieces.emplace_back(known[i - 1], known[i], heights[i - 1], heights[i]);
  }
  while (true) {
    std::erase_if(pieces, [&](const Piece& one) { return one.bound() <= (1 + proven) * highest; });
    if (pieces.empty() || !std::isfinite(highest)) break;
    if (tried.size() + pieces.size() > most_places)
      throw foundation::NotComputable(
          fmt::format("{}: the largest value of all orders together over {} needs more than {} speeds; "
                      "give a narrower range",
                      channels_[channel].name, speed_words(speed), most_places));
    report(tried.size());
    std::vector<double> middles;
    for (const Piece& one : pieces) middles.push_back(0.5 * (one.from.speed + one.to.speed));
    const std::vector<Place> found = places(channel, middles, all());
    std::vector<Piece> halves;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& whole = pieces[i];
      const Place& middle = found[i];
      const double at = height_at(middle);
      const double bend = (middle.values - 0.5 * (whole.from.values + whole.to.values)).cwiseAbs().sum();
      raise(middle, at);
      halves.emplace_back(whole.from, middle, whole.at_from, at);
      halves.emplace_back(middle, whole.to, at, whole.at_to);
      // Of a parabola a half bends a quarter of the whole: four times that is allowed for.
      halves.end()[-1].bend = halves.end()[-2].bend = std::max(bend, share_of_bend * whole.bend);
    }
    tried.insert(tried.end(), middles.begin(), middles.end());
    pieces = std::move(halves);
  }
  return value_at(channel, refined(channel, best, std::move(tried), level), all());
}

SummedOrders::Place SummedOrders::refined(std::size_t channel, const Place& best, std::vector<double> tried,
                                          project::Level level) const {
  std::ranges::sort(tried);
  const auto below = std::ranges::lower_bound(tried, best.speed), above = std::ranges::upper_bound(tried, best.speed);
  if (!std::isfinite(best.sum()) || below == tried.begin() || above == tried.end()) return best;
  const auto at = [&](double speed) { return places(channel, {speed}, all()).front(); };
  const numerics::Minimum found =
      numerics::minimum_between(*std::prev(below), *above, [&](double speed) { return -height(at(speed), level); });
  return -found.value > height(best, level) ? at(found.at) : best;
}

}  // namespace trivet::study
