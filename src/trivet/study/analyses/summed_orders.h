// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

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

 private:
  struct Place;
  [[nodiscard]] std::vector<Place> places(const std::vector<assembly::Channel>& channels, std::size_t channel,
                                          const std::vector<double>& speeds) const;
  /// The limit towards standstill. @param near  a speed close to it [rad/s]
  [[nodiscard]] Place at_rest(std::size_t channel, double near) const;
  /// Below this size a value at ω is what is left of motions that cancel.
  [[nodiscard]] double round_off(std::size_t channel, std::size_t load, double omega) const;
  /// The speed from which the values of a range are computed: above 0 if something is not defined below.
  [[nodiscard]] double begin(const assembly::Band& speed) const;
  [[nodiscard]] OperatingValue largest_of(std::size_t channel, const assembly::Band& speed) const;
  [[nodiscard]] std::vector<double> turning_speeds(std::size_t channel, const assembly::Band& speed,
                                                   std::vector<double>& unbounded) const;
  [[nodiscard]] OperatingValue value_at(std::size_t channel, const Place& place) const;

  const CaseContext& c_;
  std::vector<assembly::Channel> channels_;
  const std::vector<response::OrderLoading>& loads_;
  std::vector<response::Peaks> peaks_;  ///< by order, for ranges
  double searched_from_ = 0;            ///< the speed above which they are all known [rad/s]
};

}  // namespace trivet::study
