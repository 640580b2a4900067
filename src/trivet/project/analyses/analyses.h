// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/excitation/human_weighting.h"
#include "trivet/excitation/modal_combination.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::project {

/// Which answers of which quantity under which excitations.
struct Wanted {
  std::vector<std::string> of = {"coordinates"};
  assembly::Quantity quantity = assembly::Quantity::displacement;
  std::vector<std::string> excitations;  ///< empty: all

  bool operator==(const Wanted&) const = default;
};

struct ResponseRequest {
  Wanted wanted;
  std::optional<response::Band> band;  ///< none: from 0 to 1.3 times the highest natural frequency
  response::Spacing spacing = response::Spacing::automatic;
  int points = 1001;                   ///< of a linear or logarithmic grid
  std::vector<double> at;              ///< single ω instead of a band [rad/s]
  bool continuous_phase = false;
};

struct PeaksRequest {
  Wanted wanted;
  double min_prominence = 1e-6;
  double peak_tolerance = 0.01;  ///< prominence over the minimum beside a peak from which the design rule counts it
};

/// Largest allowed amplitude of one answer, SI.
struct Limit {
  std::string name;
  double amplitude = 0;
};

/// Root mean squares and spectral densities under the random excitations.
struct RandomRequest {
  Wanted wanted;
  std::optional<excitation::Weighting> weighting;  ///< of the accelerations of all motions that are asked for
  std::optional<excitation::ContactPoint> contact; ///< instead: each axis as people feel it there, with the vibration total value
};

/// Time histories under the excitations of type time.
struct TransientRequest {
  Wanted wanted;
  double from = 0;             ///< [s]
  std::optional<double> to;    ///< [s]
  std::optional<double> step;  ///< [s]
  bool nearest_linear_system = false;
  std::vector<std::pair<std::string, double>> displacements, velocities;  ///< initial, by coordinate: "frame.z" [m, rad, m/s, rad/s]
};

/// Run-up: all orders over the speed of the shaft.
struct OrdersRequest {
  Wanted wanted;
  response::Band speed;  ///< [rad/s]
};

/// Force on the ground over a force excitation, or motion over a unit motion of the whole ground.
struct TransmissibilityRequest {
  std::string force;               ///< the excitation; empty: a motion of the ground
  std::vector<std::string> of;     ///< of a motion: bodies and points
  response::Direction direction;   ///< of a motion
  std::optional<response::Band> band;
};

/// Mean power into the ground at each mount over the band of the response, and shapes at single frequencies.
struct PowerRequest {
  std::vector<std::string> excitations;
  std::optional<response::Band> band;
};
struct ShapesRequest {
  std::vector<std::string> excitations;
  std::vector<double> at;   ///< [rad/s]
};

/// Shock response spectra of time excitations.
struct ShockSpectrumRequest {
  std::vector<std::string> excitations;
  double damping_ratio = 0.05;
  response::Band band;      ///< of natural frequencies [rad/s]
};

/// Largest answers to an earthquake by its response spectrum.
struct EarthquakeRequest {
  Wanted wanted;
  excitation::ResponseSpectrum spectrum;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
};

/// An answer of the response against a user's line.
struct LimitLineRequest {
  std::string of;
  response::LimitLine line;
};

/// Designs that one map may hold.
inline constexpr double most_designs = 1e7;

/// One axis of a map: a number of the project file that a design may choose.
struct MapAxis {
  std::string parameter;      ///< dotted path, as in --set
  std::string name;           ///< what tables and pictures call it; the path by default
  double from = 0, to = 1;    ///< in `unit`
  std::string unit;           ///< as written beside from and to; empty: the number as the file takes it, SI
  bool logarithmic = false;
  int points = 101;

  [[nodiscard]] double at(double share) const;          ///< the value at 0 … 1 of the axis, ends exact
  [[nodiscard]] double share(double value) const;       ///< its inverse, also beyond
  bool operator==(const MapAxis&) const = default;
};

/// Largest allowed amplitude of one answer, SI.
struct MapLimit {
  std::string name;
  assembly::Quantity quantity = assembly::Quantity::displacement;
  double amplitude = 0;
  bool operator==(const MapLimit&) const = default;
};

/// Two numbers of the project and the rules that a design keeps or breaks.
struct MapRequest {
  MapAxis x, y;
  std::optional<response::Band> band;         ///< of the amplitudes; none: 0 ≤ ω < ∞
  std::vector<MapLimit> limits;
  bool limits_of_file = true;                 ///< the map names none: those of the file
  std::vector<std::string> no_peak;           ///< answers that shall have no resonance peak, wherever it lies
  assembly::Quantity quantity = assembly::Quantity::displacement;  ///< of these
  double min_prominence = 1e-6, peak_tolerance = 0.01;             ///< as of `peaks`
  std::vector<std::string> excitations;       ///< empty: all
  std::optional<std::vector<std::string>> cases;  ///< marked on the map; none: all that have both numbers
  bool operator==(const MapRequest&) const = default;
};

struct Analyses {
  bool modes = false;
  bool roots = false;
  std::optional<ResponseRequest> response;
  std::optional<PeaksRequest> peaks;
  std::optional<std::vector<std::string>> static_of;
  bool load_sharing = false;
  std::optional<RandomRequest> random;
  std::optional<TransientRequest> transient;
  std::optional<OrdersRequest> orders;
  std::optional<TransmissibilityRequest> transmissibility;
  std::optional<PowerRequest> power;
  std::optional<ShapesRequest> shapes;
  std::optional<ShockSpectrumRequest> shock_spectrum;
  std::optional<EarthquakeRequest> earthquake;
  std::optional<MapRequest> map;
  std::vector<LimitLineRequest> limit_lines;
  std::vector<Limit> limits;
};

}  // namespace trivet::project
