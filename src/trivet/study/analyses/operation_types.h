// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/assembly/channels.h"
#include "trivet/assembly/limit_line.h"
#include "trivet/excitation/frequency_bands.h"
#include "trivet/project/text/level.h"
#include "trivet/response/machinery/deflection_shape.h"

/// What happens at the speeds at which a machine runs. All excitations run with it: its orders, and at order 1
/// unbalances and harmonic forces. Formulas: docs/analyses.md.
namespace trivet::study {

/// Largest value of one result at a speed, or over a range of speeds.
struct OperatingValue {
  std::string name, unit;  ///< SI
  double rms = 0;          ///< √(Σ |y_k|² / 2) over the orders k; infinite at an undamped resonance
  double bound = 0;        ///< Σ |y_k| there: all orders in phase
  double at = 0;           ///< Ω [rad/s]
  double order = 0;        ///< that with the largest part
  std::string reason;      ///< why it is infinite
  double peak = 0;         ///< there, largest |y(t)| of all orders with their phases
  double span = 0;         ///< there, largest minus least y(t)
  bool is_bound = false;   ///< peak and span are upper bounds: not all orders have a common period

  /// Of one order its amplitude, of several √2 times their root mean square, which is not their peak.
  [[nodiscard]] double amplitude() const { return std::numbers::sqrt2 * rms; }
  /// Several orders take part, so that its levels are not shares of one another.
  [[nodiscard]] bool has_several_orders() const { return bound > (1 + 1e-9) * amplitude(); }
  /// The root mean square, the peak or the span.
  [[nodiscard]] double at_level(project::Level level) const {
    return level == project::Level::rms ? rms : level == project::Level::amplitude ? peak : span;
  }
};

/// A limit on a result at a speed, or over a range of speeds.
struct OperatingLimit {
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  project::Level level = project::Level::amplitude;  ///< of the file: what is judged
  double allowed = 0;                                ///< at this level
  OperatingValue value;                              ///< where its number at this level is largest
  std::string refusal = {};                          ///< why it is not judged; then `value` has no numbers

  [[nodiscard]] double judged() const;  ///< not a number if it is not judged
  [[nodiscard]] double share() const { return judged() / allowed; }
  [[nodiscard]] bool met() const;
  /// Why it is not judged, why it is infinite, or that it is an upper bound; otherwise empty.
  [[nodiscard]] std::string remark() const;
};

/// A motion as displacement [m] or [rad] and as velocity [m/s] or [rad/s].
struct OperatingMotion {
  OperatingValue displacement, velocity;
};

/// Force on the ground over one exciting force in one order, where it is largest.
struct OperatingIsolation {
  std::string excitation;
  double order = 0;
  std::string direction;  ///< "along z", "about x"
  std::string reason;     ///< why there is none; then the numbers have no meaning
  double transmissibility = 0;
  double at = 0;        ///< Ω [rad/s]
  double exciting = 0;  ///< there [N] or [N m]
  std::string unit = "N";

  [[nodiscard]] double transmitted() const { return transmissibility * exciting; }
};

/// How far the excitation of one order is from a natural frequency.
struct OperatingMode {
  int mode = 0;                  ///< number, from 1
  double angular_frequency = 0;  ///< undamped natural frequency [rad/s]
  double order = 0;
  double ratio = 0;                         ///< order · Ω / natural frequency, at the speed where it is nearest to 1
  double at = 0;                            ///< Ω [rad/s]
  bool passes = false;                      ///< a range of speeds passes through the resonance
  std::optional<double> modal_force_share;  ///< as in the Campbell diagram; none: no force acts
  bool excited = true;                      ///< false: the order does not excite the mode

  [[nodiscard]] double distance() const { return ratio - 1; }
  [[nodiscard]] bool is_near() const;
};

/// An excitation at 80 … 120 % of a natural frequency is near to resonance: a lightly damped vibration is more than
/// twice as large there as at rest.
inline constexpr double near_resonance = 0.2;

/// Orders modes by what matters at a speed: those that are excited first, then those nearer to their resonance.
[[nodiscard]] inline bool is_nearer(const OperatingMode& a, const OperatingMode& b) {
  if (a.excited != b.excited) return a.excited;
  return std::abs(a.distance()) < std::abs(b.distance());
}

inline bool OperatingMode::is_near() const { return std::abs(distance()) <= near_resonance * (1 + 1e-9); }

/// Motion of the machine in one order of its speed. Orders are shown one by one, as they are measured: their sum has no
/// single frequency.
struct OperatingShape {
  double order = 0;
  response::DeflectionShape shape;
};

struct OperatingSpeed {
  assembly::Band speed;  ///< Ω [rad/s]; from = to: one speed
  std::vector<OperatingMotion> motions;
  std::vector<OperatingValue> forces;  ///< total on the ground, then of each mount; then other requested ones
  std::vector<OperatingIsolation> isolation;
  std::vector<OperatingLimit> limits;  ///< of [operation.limits]
  std::vector<OperatingMode> modes;    ///< by order, then ascending
  std::vector<OperatingShape> shapes;  ///< ascending order; without those of an undamped resonance; none of a range

  [[nodiscard]] bool is_range() const { return speed.from < speed.to; }
};

/// Level of a result in one frequency band, at a speed or the largest over a range of speeds.
struct OperatingLevel {
  assembly::Band speed;  ///< Ω [rad/s]; from = to: one speed
  std::string quantity;  ///< "velocity", "force" …
  excitation::FrequencyBand band;
  OperatingValue value;   ///< under the orders whose frequencies are in the band; of these `rms` is the level
  std::string line = {};  ///< of several limit lines that judge this band, the lowest there; empty: none
  double limit = 0;       ///< of the line, root mean square [unit]
  double random = 0;      ///< rms of the random vibration in a band with a line, which acts besides [unit]

  /// Tones and random vibration are not correlated.
  [[nodiscard]] double with_random() const { return std::hypot(value.rms, random); }
  [[nodiscard]] double share() const { return with_random() / limit; }  ///< of the line
  [[nodiscard]] bool met() const;
};

/// A limit line over bands at a speed, or over a range of speeds.
struct OperatingLine {
  assembly::Band speed;  ///< Ω [rad/s]; from = to: one speed
  std::string of;
  assembly::LimitLine line;
  std::optional<OperatingLevel> nearest = {};  ///< with the largest share of this line; none: no order in its bands
  std::size_t bands = 0, outside = 0;          ///< with orders, and those of them where the line has no limit

  [[nodiscard]] double share() const { return nearest ? nearest->share() : 0; }
  [[nodiscard]] double margin() const;  ///< infinite if the level is 0
  [[nodiscard]] bool met() const { return !nearest || nearest->met(); }
  /// What its verdict leaves out, and what acts besides the orders; empty if nothing.
  [[nodiscard]] std::string remark() const;
};

struct OperationResult {
  std::vector<std::string> excitations;  ///< that run
  std::vector<double> orders;            ///< ascending
  std::vector<OperatingSpeed> speeds;    ///< as in the file
  std::vector<OperatingLevel> levels;    ///< by speed, result and band, if bands are requested
  std::vector<OperatingLine> lines;      ///< over these bands: by speed, then as in the file
};

/// "980 rpm", "600 … 900 rpm"
[[nodiscard]] std::string speed_words(const assembly::Band& speed);

}  // namespace trivet::study
