// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/response/machinery/orders_in_time.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/analyses/operation_types.h"

namespace trivet::study {

/// Results under all orders together: half the sum of the squares of their amplitudes is the square of the rms, because
/// the orders differ in frequency. Their peak depends on their phases.
class SummedOrders {
 public:
  /// @param fastest  upper end of the fastest range of speeds [rad/s], over which peaks are searched; 0: single speeds
  SummedOrders(const CaseContext& context, std::vector<assembly::Channel> channels,
               const std::vector<response::OrderLoading>& loads, double fastest);

  /// The largest value of every channel over a range; equal ends: the values at this speed. With one order it is exact:
  /// at an end or at a peak. With several, every |y_k| is monotonic between its extrema, which bounds the sum between
  /// two speeds; speeds are added until no bound exceeds the largest value by more than 5e-5, at most 20,000, and the
  /// place is refined.
  /// Of a range from 0 the limit towards rest counts, which may be infinite.
  [[nodiscard]] std::vector<OperatingValue> largest(const assembly::Band& speed) const;
  /// The value of one channel where its number at the level is largest. Of several orders over a range the peak or the
  /// span is searched between their extrema, poles and added speeds until it varies too little between two speeds to
  /// exceed the largest one by more than 5e-5, as far as the bend of the responses over both halves of a piece shows.
  /// @throws foundation::NotComputable if that needs too many speeds
  [[nodiscard]] OperatingValue largest(std::size_t channel, const assembly::Band& speed, project::Level level) const;

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
  /// y_k of the orders at one speed; 0 of those that do not count.
  struct Place {
    double speed = 0;
    Eigen::VectorXcd values;
    std::string reason = {};  ///< why they are infinite
    /// @param value  none at an undamped resonance
    void set(Eigen::Index order, const std::optional<std::complex<double>>& value);
    [[nodiscard]] Eigen::VectorXd squares() const { return values.cwiseAbs2(); }
    [[nodiscard]] double sum() const { return values.squaredNorm(); }
    [[nodiscard]] Eigen::VectorXd amplitudes() const { return values.cwiseAbs(); }
  };
  /// Two speeds with the numbers there at a level, and by how much one between them may exceed the larger.
  struct Piece;
  using Counted = std::vector<std::size_t>;  ///< places in the list of loads
  static constexpr std::size_t most_places = 20'000;
  /// A speed at which an order meets an undamped resonance.
  struct Resonance {
    double speed = 0;
    std::size_t order = 0;  ///< its place in the list of loads
  };

  [[nodiscard]] Place nothing_at(double speed) const;
  [[nodiscard]] Counted all() const;
  [[nodiscard]] Counted in_band(const excitation::FrequencyBand& band, double speed) const;
  [[nodiscard]] std::vector<Place> places(std::size_t channel, const std::vector<double>& speeds,
                                          const Counted& orders) const;
  /// The value, or if it is no number its limit: at the frequency of an undamped mode there is no solution, but a
  /// channel that this mode does not reach has a limit. None if it has none.
  [[nodiscard]] std::optional<std::complex<double>> value_or_limit(std::size_t channel, std::size_t load, double omega,
                                                                   std::complex<double> value) const;
  /// Of a search that has looked at so many places.
  void report(std::size_t places) const;
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
  [[nodiscard]] OperatingValue largest_in_time(std::size_t channel, const assembly::Band& speed,
                                               project::Level level) const;
  /// The peak, or half the span.
  [[nodiscard]] double height(const Place& place, project::Level level) const;
  /// Places at the ends of the range, at rest if it begins there, and at all extrema of the |y_k|; or only one, at
  /// which the channel is unbounded.
  [[nodiscard]] std::vector<Place> turning_places(std::size_t channel, const assembly::Band& speed,
                                                  const Counted& orders) const;
  /// The same places and those at the poles between two of them that may exceed the height.
  [[nodiscard]] std::vector<Place> with_poles(std::size_t channel, std::vector<Place> known, double above) const;
  /// The place of the largest height between the neighbours of the best one among those that were tried.
  [[nodiscard]] Place refined(std::size_t channel, const Place& best, std::vector<double> tried,
                              project::Level level) const;
  [[nodiscard]] OperatingValue value_at(std::size_t channel, const Place& place, const Counted& orders) const;

  const CaseContext& c_;
  std::vector<assembly::Channel> channels_;
  const std::vector<response::OrderLoading>& loads_;
  response::OrdersInTime in_time_;
  std::vector<response::Peaks> peaks_;  ///< by order, for ranges
};

}  // namespace trivet::study
