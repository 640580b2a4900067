// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::numerics {

/// How the highest amplitude and the peaks of one design were found.
enum class DesignStatus : unsigned char {
  proven,    ///< from poles and residues; bounds prove that there is no higher value and no further peak, and sums that
             ///< no digits were lost
  fallback,  ///< recomputed because the poles of the lanes were not good enough: the same bounds with poles of an
             ///< eigensolver, or Taylor series on discs free of poles, complete to their truncation
  undecided,  ///< neither was possible: the values are the largest ones found and may be too small
  impossible  ///< A is not positive definite, or a matrix or the load is not finite; no values
};

struct DesignPeakOptions {
  double from = 0;                                      ///< lower end of the band [rad/s]
  double to = std::numeric_limits<double>::infinity();  ///< upper end [rad/s], may be infinite
  bool count_peaks = true;
  double min_prominence = 1e-6;  ///< required prominence of a peak, as a share of its curve's highest value
  Eigen::ArrayXXd
      rows;  ///< channels × n: y = s^derivative (rows + s rows_on_velocity) q, s = iω; empty: all coordinates
  Eigen::ArrayXXd rows_on_velocity;  ///< channels × n, or empty
  std::vector<int> derivative;       ///< of each channel, 0 … 2; empty: 0
  int threads = 0;                   ///< 0: as many as the machine has
  foundation::Progress progress;
};

/// All designs × channels; zero if the status is `impossible`.
struct DesignPeaks {
  Eigen::ArrayXXd
      highest;  ///< supremum of |y| on the band, its ends included; infinite at an undamped natural frequency. The
                ///< search of a system with rigid-body modes starts far below its lowest nonzero |λ| (axis_panels.h)
  Eigen::ArrayXXd highest_at;    ///< [rad/s]; infinite if only approached for ω → ∞
  Eigen::ArrayXXi peaks;         ///< resonance peaks inside the band; empty if not requested
  Eigen::ArrayXXd largest_rise;  ///< largest height / base − 1 of these peaks, the base being the higher of the two
                                 ///< minima; known to 1e-6; infinite if round-off hides the base (1e-8 of the values
                                 ///< around it); 0 without peaks, empty if not requested
  std::vector<DesignStatus> status;
};

/// Highest amplitudes and resonance peaks of every design under its real load, from poles and residues without a
/// frequency grid, at any damping. A resonance peak is a strict local maximum of |y| inside the band: its height above
/// the higher of the two minima that separate it from higher points (or from an end of the band) exceeds the stated
/// share of the highest value on the band. Heights are accurate to nine digits, near a resonance to ε/ζ. A channel
/// below 1e-12 of its possible amplitude (all coordinates weighted by their masses) counts as zero: it has no height
/// and no peaks. Real loads only: all components in phase and constant over ω.
/// @throws foundation::InvalidInput for sizes that do not match, a band that is empty or negative, derivatives other
/// than 0, 1, 2
[[nodiscard]] DesignPeaks design_peaks(const Designs& designs, const DesignPeakOptions& options = {});

}  // namespace trivet::numerics
