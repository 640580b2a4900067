// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/analyses/operation_types.h"

namespace trivet::study {

/// Results under all orders together: half the sum of the squares of their amplitudes is the square of the rms, because
/// the orders differ in frequency.
class SummedOrders {
 public:
  /// @param fastest  upper end of the fastest range of speeds [rad/s], over which peaks are searched; 0: single speeds
  SummedOrders(const CaseContext& context, std::vector<assembly::Channel> channels,
               const std::vector<response::OrderLoading>& loads, double fastest);

  /// The largest value of every channel over a range; equal ends: the values at this speed. With one order it is exact:
  /// at an end or at a peak. With several, every |y_k| is monotonic between its extrema, which bounds the sum between
  /// two speeds; speeds are added until no bound exceeds the largest value by more than 5e-5, and the place is refined.
  /// Of a range from 0 the limit towards rest counts, which may be infinite.
  [[nodiscard]] std::vector<OperatingValue> largest(const assembly::Band& speed) const;

  /// The speed from which the values of a range are computed: above its begin if an element is not defined below.
  [[nodiscard]] double begin(const assembly::Band& speed) const {
    return speed.from < speed.to ? begin(speed, all()) : speed.from;
  }

  /// The bands that an order reaches at this speed, or over this range of speeds, ascending.
  [[nodiscard]] std::vector<excitation::FrequencyBand> reached(excitation::BandWidth width,
                                                               const assembly::Band& speed) const;

  /// The same value of every channel under the orders alone whose frequencies are in the band. A range is divided where
  /// an order enters or leaves the band, so that the value has the accuracy of `largest`. The order of a value is 0 if
  /// an element is not defined at any speed at which an order is in the band.
  [[nodiscard]] std::vector<OperatingValue> largest_in(const excitation::FrequencyBand& band,
                                                       const assembly::Band& speed) const;

 private:
  /// |y_k|² of the orders at one speed; 0 of those that do not count.
  struct Place {
    double speed = 0;
    Eigen::VectorXd squares;
    std::string reason = {};  ///< why they are infinite
    /// @param square  not a number at an undamped resonance
    void set(Eigen::Index order, double square);
    [[nodiscard]] double sum() const { return squares.sum(); }
  };
  using Counted = std::vector<std::size_t>;  ///< places in the list of loads
  /// A speed at which an order meets an undamped resonance.
  struct Resonance {
    double speed = 0;
    std::size_t order = 0;  ///< its place in the list of loads
  };

  [[nodiscard]] Counted all() const;
  [[nodiscard]] Counted in_band(const excitation::FrequencyBand& band, double speed) const;
  [[nodiscard]] std::vector<Place> places(const std::vector<assembly::Channel>& channels, std::size_t channel,
                                          const std::vector<double>& speeds, const Counted& orders) const;
  /// The limit towards standstill. @param near  a speed close to it [rad/s]
  [[nodiscard]] Place at_rest(std::size_t channel, double near, const Counted& orders) const;
  /// Below this size a value at ω is what is left of motions that cancel.
  [[nodiscard]] double round_off(std::size_t channel, std::size_t load, double omega) const;
  /// The speed from which peaks of these orders were searched.
  [[nodiscard]] double searched_from(const Counted& orders) const;
  /// The speed from which the values of a range are computed: above 0 if something is not defined below.
  [[nodiscard]] double begin(const assembly::Band& speed, const Counted& orders) const;
  [[nodiscard]] std::vector<OperatingValue> at_speed(double speed, const Counted& orders) const;
  [[nodiscard]] OperatingValue largest_of(std::size_t channel, const assembly::Band& speed,
                                          const Counted& orders) const;
  [[nodiscard]] std::vector<double> turning_speeds(std::size_t channel, const assembly::Band& speed,
                                                   const Counted& orders, std::vector<Resonance>& unbounded) const;
  [[nodiscard]] OperatingValue value_at(std::size_t channel, const Place& place, const Counted& orders) const;

  const CaseContext& c_;
  std::vector<assembly::Channel> channels_;
  const std::vector<response::OrderLoading>& loads_;
  std::vector<response::Peaks> peaks_;  ///< by order, for ranges
};

}  // namespace trivet::study
