// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "trivet/numerics/sampling/distributions.h"
#include "trivet/project/analyses/design_axis.h"

namespace trivet::project {

/// Numbers of the model that differ from machine to machine: [tolerances.NAME].
struct Tolerance {
  std::string name;
  std::vector<ParameterPlace> places;  ///< the number at each deviates by the deviation times the factor of the place
  bool together = false;               ///< one draw for all places; otherwise each draws for itself
  bool relative = false;               ///< the deviation is a share of the number in the file or the case
  /// Of the deviation in SI; if it is relative, of the ratio to the number.
  numerics::Distribution distribution;
  struct Correlation {
    std::string with;  ///< name of another tolerance
    double value = 0;
  };
  std::vector<Correlation> correlations;

  /// Numbers that are drawn for each design.
  [[nodiscard]] std::size_t draws() const { return together ? 1 : places.size(); }
  /// The number at a place with a draw. @param given  the number in the file or the case
  [[nodiscard]] double number(std::size_t place, double given, double draw) const {
    const double factor = places[place].factor;
    return relative ? given * (1 + factor * (draw - 1)) : given + factor * draw;
  }
};

/// The least yield that can be wanted: whoever accepts more bad machines than good ones has another question.
inline constexpr double least_wanted_yield = 0.5;

/// The study of designs within the tolerances: [analyses.sample].
struct SampleRequest {
  std::size_t designs = 100'000;
  bool sobol = true;  ///< scrambled Sobol numbers in independent replicates; otherwise random numbers
  std::uint64_t seed = 1;
  bool worst_case = false;      ///< also search the worst design of each requirement
  std::optional<double> yield;  ///< share of the designs that has to meet every requirement, below 1
  /// Results whose amplitudes over the frequencies of [analyses.response] are counted; names as in its `of`.
  std::vector<std::string> bands;
  int band_points = 200;  ///< frequencies of the bands, beside the peaks of the given design
};

inline constexpr int fewest_band_points = 10, most_band_points = 2000;
/// Most numbers, results × frequencies, whose distributions one case counts: each has about 6 kB in each thread.
inline constexpr double most_band_values = 5000;
/// The ranges around the numbers of the file in which every requirement is met: [analyses.box].
struct BoxRequest {
  std::optional<std::size_t> points;  ///< designs inside that are judged afterwards; none: by what it takes
  double most = 10;                   ///< largest range that is tried, over that of the tolerance
  std::uint64_t seed = 1;
};
inline constexpr double fewest_box_points = 100, most_box_points = 1e9, most_box_times = 1000;

/// Independent replicates of scrambled Sobol numbers, whose differences give the confidence interval.
inline constexpr std::size_t sample_replicates = 16;
inline constexpr double fewest_sampled = 100, most_sampled = 1e9;

}  // namespace trivet::project
