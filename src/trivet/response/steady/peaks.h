// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/interruption.h"
#include "trivet/modal/roots.h"
#include "trivet/numerics/peaks/extremum.h"

namespace trivet::response {

using numerics::Extremum;

/// A resonance peak: a strict local maximum of |y(ω)| at ω > 0.
struct Peak {
  std::size_t curve = 0;
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude = 0;          ///< infinite at an undamped natural frequency
  double prominence = 0;         ///< height above the higher of the two minima that separate it from higher values
  std::optional<double> ratio_to_static;  ///< amplitude / |y(0)|; empty if that is 0 or undefined
  std::optional<int> nearest_mode;        ///< see set_nearest_modes; empty until then
  double frequency_uncertainty = 0;       ///< [rad/s], see RefinedPeak
  double amplitude_uncertainty = 0;
  bool refined = true;  ///< false: Newton did not converge (a very flat maximum); values are those of the series
};

/// Prominence / higher neighbouring minimum (infinite if that is 0 or round-off): the measure of the design rule.
[[nodiscard]] double relative_prominence(const Peak& peak);

/// Summary of a whole curve on 0 ≤ ω < ∞.
struct CurveSummary {
  std::string name;
  std::string unit;
  std::optional<double> static_amplitude;  ///< |y(0)|; empty for a system with rigid-body modes
  double highest = 0;                      ///< supremum of |y|, infinite with an undamped peak
  double highest_at = 0;                   ///< [rad/s]; infinity if only approached there
  bool vanishes = false;                   ///< below round-off of its load everywhere
  int peaks = 0;
};

struct Peaks {
  std::vector<Peak> list;  ///< by curve, then ascending
  std::vector<CurveSummary> curves;
  std::vector<std::vector<Extremum>> turnings;  ///< per curve: all extrema
  double searched_from = 0;                     ///< [rad/s]
  double searched_to =
      std::numeric_limits<double>::infinity();  ///< [rad/s]; finite with frequency-dependent elements or delayed loads
  bool from_circles = false;                    ///< with frequency-dependent elements
  int panels = 0;                               ///< pieces of the axis that were searched
};

/// How a peak was located: "newton" (steps in extended precision), "circles" (series from samples around it), or
/// "series" (Newton did not converge).
[[nodiscard]] inline const char* method(const Peaks& peaks, const Peak& peak) {
  return !peak.refined ? "series" : peaks.from_circles ? "circles" : "newton";
}

struct PeakOptions {
  double min_prominence = 1e-6;  ///< of the curve's largest finite amplitude
  double search_to = 0;  ///< [rad/s] least end of the search with frequency-dependent elements or delays; twice the
                         ///< highest natural frequency if that is more
  bool refine = true;    ///< by Newton steps; false: heights of the series, accurate to about 1e-10, for many curves
};

/// All peaks of all channels on the whole axis. The axis is covered by discs without poles; on each, |y|² is a Taylor
/// series, and bisection with bounds searches its derivative for sign changes, so that none above round-off is missed;
/// the last disc is centred at ω = ∞. Each maximum is then refined in extended precision. Complex loads, loss factors,
/// coincident and defective roots are allowed. Frequency-dependent elements (exact springs, tables, fractional laws)
/// have no finite set of poles: up to `search_to`, the series come from samples on circles that shrink until they show
/// no pole inside.
[[nodiscard]] Peaks peaks(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                          const assembly::Loading& loading, const modal::Modes& modes, const modal::Roots& roots,
                          const PeakOptions& options = {}, const foundation::Progress& progress = {});

}  // namespace trivet::response
