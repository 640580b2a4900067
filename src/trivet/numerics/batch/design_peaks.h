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
  proven,  ///< from poles and residues; bounds prove that no higher value and no further peak exists, and sums that no
           ///< digits were lost
  redone,  ///< the poles of the lanes were not good enough for that: the same bounds on poles of an eigensolver, or
           ///< Taylor series on discs free of poles, complete to their truncation
  undecided,  ///< neither was possible: the values are what was seen, and may be too small
  impossible  ///< A is not positive definite, or a matrix or the load is not finite; no values
};

struct DesignPeakOptions {
  double from = 0;                                      ///< ω of the band [rad/s]
  double to = std::numeric_limits<double>::infinity();  ///< [rad/s], may be infinite
  bool count_peaks = true;
  double min_prominence = 1e-6;  ///< of a peak, as a share of its curve's highest value
  Eigen::ArrayXXd
      rows;  ///< channels × n: y = s^derivative (rows + s rows_on_velocity) q, s = iω; empty: all coordinates
  Eigen::ArrayXXd rows_on_velocity;  ///< channels × n, or empty
  std::vector<int> derivative;       ///< of each channel, 0 … 2; empty: 0
  int threads = 0;                   ///< 0: as many as the machine has
  foundation::Progress progress;
};

/// All designs × channels; zero where the status is `impossible`.
struct DesignPeaks {
  Eigen::ArrayXXd
      highest;  ///< supremum of |y| on the band, its ends included; infinite at an undamped natural frequency. A system
                ///< that is free to move is searched from far below its lowest nonzero |λ| on (axis_panels.h)
  Eigen::ArrayXXd highest_at;    ///< [rad/s]; infinity if only approached there
  Eigen::ArrayXXi peaks;         ///< resonance peaks inside the band; empty if not asked for
  Eigen::ArrayXXd largest_rise;  ///< of these peaks over their base, the higher of those two minima: height / base − 1,
                                 ///< known to 1e-6; infinite over a base that round-off hides (1e-8 of what is about
                                 ///< it); 0 without peaks, empty if not asked for
  std::vector<DesignStatus> status;
};

/// Highest amplitudes and resonance peaks of every design under its real load, by poles and residues: no grid, whatever
/// the damping. A resonance peak is a strict local maximum of |y| inside the band whose height above the higher of the
/// two minima that part it from higher ground (or from an end of the band) exceeds the stated share of the highest
/// value on the band. Heights keep nine digits, near a resonance ε/ζ. A channel that stays below 1e-12 of what its
/// coordinates could make of it (all weighed by their masses) is taken for zero: it has no height and no peaks. Real
/// loads only: a load whose components differ in phase, or that grows with ω, is not of this form.
/// @throws foundation::InvalidInput for shapes that do not fit, a band that is empty or negative, derivatives other
/// than 0, 1, 2
[[nodiscard]] DesignPeaks design_peaks(const Designs& designs, const DesignPeakOptions& options = {});

}  // namespace trivet::numerics
