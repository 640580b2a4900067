// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/numerics/sampling/exact_statistics.h"

namespace trivet::study {

/// 5, 50 and 95 % of a number over the judged designs, and its extremes.
struct Spread {
  double low = 0, median = 0, high = 0;
  numerics::Extremes extremes;
};

/// A limit of a requirement on the amplitude of the same result under the same excitations.
struct BandLimit {
  assembly::Band band;
  double amplitude = 0;
};

/// The amplitudes of one result over all judged designs, at each frequency for itself.
struct SampledBand {
  std::string name, unit;                 ///< SI
  std::vector<double> angular_frequency;  ///< [rad/s], ascending
  std::vector<double> given;              ///< of the design of the file; infinite at an undamped resonance
  std::vector<Spread> spread;
  std::vector<BandLimit> limits;
  std::uint64_t without = 0;    ///< designs that were judged, but have no amplitudes
  bool is_logarithmic = false;  ///< the frequencies are those of a logarithmic spacing
  std::string no_kernels;       ///< why the amplitudes are those of assembled models; empty: kernels computed them

  /// Where 95 % of the designs have the highest bound.
  [[nodiscard]] std::size_t worst() const;
};

}  // namespace trivet::study
