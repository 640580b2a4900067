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
  [[nodiscard]] std::vector<OperatingValue> largest(const assembly::Band& speed) const;

 private:
  struct Place;
  [[nodiscard]] std::vector<Place> places(const std::vector<assembly::Channel>& channels, std::size_t channel,
                                          const std::vector<double>& speeds) const;
  [[nodiscard]] OperatingValue largest_of(std::size_t channel, const assembly::Band& speed) const;
  [[nodiscard]] std::vector<double> turning_speeds(std::size_t channel, const assembly::Band& speed,
                                                   std::vector<double>& unbounded) const;
  [[nodiscard]] OperatingValue value_at(std::size_t channel, const Place& place) const;

  const CaseContext& c_;
  std::vector<assembly::Channel> channels_;
  const std::vector<response::OrderLoading>& loads_;
  std::vector<response::Peaks> peaks_;  ///< by order, for ranges
};

}  // namespace trivet::study
