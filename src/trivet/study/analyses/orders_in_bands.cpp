// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "trivet/study/analyses/summed_orders.h"

/// Which orders of a shaft are in a frequency band at a speed.
namespace trivet::study {
namespace {

using excitation::FrequencyBand;

/// The ends of a range of speeds and the speeds in it at which an order enters or leaves the band, ascending.
std::vector<double> divided(const assembly::Band& speed, const FrequencyBand& band,
                            const std::vector<response::OrderLoading>& loads) {
  constexpr double rounding = 1e-9;
  std::vector<double> ends = {speed.from};
  for (const response::OrderLoading& load : loads)
    for (const double edge : {band.from(), band.to()}) {
      const double at = edge / load.order;
      if (at > speed.from && at < speed.to) ends.push_back(at);
    }
  std::ranges::sort(ends);
  const auto repeated = std::ranges::unique(ends, [](double a, double b) { return b <= a * (1 + rounding); });
  ends.erase(repeated.begin(), repeated.end());
  if (ends.size() > 1 && speed.to <= ends.back() * (1 + rounding)) ends.pop_back();
  ends.push_back(speed.to);
  return ends;
}

}  // namespace

SummedOrders::Counted SummedOrders::in_band(const FrequencyBand& band, double speed) const {
  Counted orders;
  for (std::size_t k = 0; k < loads_.size(); ++k)
    if (excitation::band_of_tone(band.width, loads_[k].order * speed) == band) orders.push_back(k);
  return orders;
}

std::vector<FrequencyBand> SummedOrders::reached(excitation::BandWidth width, const assembly::Band& speed) const {
  std::vector<FrequencyBand> bands;
  for (const response::OrderLoading& load : loads_) {
    std::vector<FrequencyBand> of_order =
        excitation::bands_between(width, load.order * speed.from, load.order * speed.to);
    of_order.push_back(
        excitation::band_of_tone(width, load.order * speed.to));  // of a range: one that begins at its end
    for (const FrequencyBand& band : of_order)
      if (std::ranges::find(bands, band) == bands.end()) bands.push_back(band);
  }
  std::ranges::sort(bands, {}, &FrequencyBand::index);
  return bands;
}

std::vector<OperatingValue> SummedOrders::largest_in(const FrequencyBand& band, const assembly::Band& speed) const {
  if (!(speed.from < speed.to)) return at_speed(speed.from, in_band(band, speed.from));
  std::vector<OperatingValue> result;
  for (const assembly::Channel& channel : channels_)
    result.push_back({.name = channel.name, .unit = channel.unit, .at = speed.from});
  const std::vector<double> ends = divided(speed, band, loads_);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Counted orders = in_band(band, 0.5 * (ends[i - 1] + ends[i]));
    if (orders.empty() || begin({ends[i - 1], ends[i]}, orders) >= ends[i]) continue;
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      const OperatingValue found = largest_of(c, {ends[i - 1], ends[i]}, orders);
      if (found.rms > result[c].rms || result[c].order == 0) result[c] = found;
    }
  }
  const Counted at_end = in_band(band, speed.to);
  if (at_end.empty() || at_end == in_band(band, 0.5 * (ends[ends.size() - 2] + ends.back()))) return result;
  const std::vector<OperatingValue> last = at_speed(speed.to, at_end);  // an order on an edge enters there
  for (std::size_t c = 0; c < channels_.size(); ++c)
    if (last[c].rms > result[c].rms || result[c].order == 0) result[c] = last[c];
  return result;
}

}  // namespace trivet::study
