// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/assembly/channels.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/analyses/design_axis.h"
#include "trivet/project/analyses/limit_line_request.h"
#include "trivet/project/analyses/requirements.h"
#include "trivet/project/analyses/tolerances.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/units.h"

namespace trivet::project {

// Measured curves and mode shapes, expressed in results and places of the model.

/// A measured function that belongs to one result. Values are in the quantity of the response, multiplied by the force
/// of the excitation if the function is measured per force.
struct MeasuredCurve {
  std::string result;                     ///< "machine.seat.z"
  std::string source;                     ///< in its file: "3:+z", or the name of its columns
  std::vector<double> angular_frequency;  ///< [rad/s], ascending, > 0
  Eigen::VectorXcd value;                 ///< SI
  Eigen::VectorXd coherence;              ///< 0 … 1; empty if it is not measured
};

/// One measured component of a shape: a translation of a place along an axis of the ground.
struct ShapeComponent {
  std::size_t body = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< of the place, body frame [m]
  int axis = 0;                                  ///< 0, 1, 2: x, y, z of the ground
};

struct MeasuredMode {
  int number = 0;  ///< as in the file
  double angular_frequency = 0;
  double damping_ratio = 0;
  Eigen::VectorXcd shape;  ///< one value per component
};

/// True for a frequency inside a band, ends included.
[[nodiscard]] inline bool covers(const assembly::Band& band, double omega) {
  constexpr double rounding = 1e-9;
  return omega >= band.from * (1 - rounding) && omega <= band.to * (1 + rounding);
}

/// A table of [measurements].
struct Measurement {
  std::string name;
  std::string file;        ///< as the project file names it
  std::string excitation;  ///< the only one that acts; empty: those of the response
  std::vector<MeasuredCurve> curves;
  std::vector<ShapeComponent> components;  ///< of all shapes
  std::vector<MeasuredMode> modes;
};

/// What of the results of `minimize` is made small: the largest amplitude over the band, the root mean square under the
/// random excitations, or the magnitude under gravity and constant forces. Or, instead of results, the price of the
/// chosen mounts, or the largest transmissibility of the required isolations as a share of the allowed one.
enum class Minimized { amplitude, rms, at_rest, price, isolation };

inline constexpr int usual_starts = 32;

/// The search for the best design: [analyses.optimize].
struct OptimizeRequest {
  std::vector<std::string> parameters;  ///< names in [parameters], of numbers and choices; empty: all
  std::vector<std::string> minimize;    ///< results with the amplitude to minimise over the band of the requirements;
                                        ///< empty: the largest least margin of the requirements
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;  ///< of these
  Minimized minimized = Minimized::amplitude;
  std::vector<double> weights;     ///< of these, for a sum of amplitudes; empty: the largest counts
  std::vector<std::string> front;  ///< two or three results between whose amplitudes the front is searched
  int points = 11;                 ///< of a front of two
  std::optional<int> starts;       ///< climbs; none: `usual_starts`, or fewer of designs that take long
  int combinations = 1000;         ///< most combinations of mounts whose numbers are optimised
  std::optional<double> yield;     ///< share of the machines within the tolerances that has to meet every requirement
  bool worst_case = false;         ///< the worst designs found within the tolerances have to meet them too

  /// True if the tolerances count.
  [[nodiscard]] bool is_robust() const { return yield || worst_case; }

  /// True if a parameter of this name is varied.
  [[nodiscard]] bool varies(const std::string& parameter) const {
    return parameters.empty() || std::ranges::find(parameters, parameter) != parameters.end();
  }
};

/// Which mounts may be used at some places, the same at all of them: [parameters.NAME] with `choices` or `catalogue`.
struct MountChoice {
  std::string name;
  std::vector<std::string> paths;     ///< elements.NAME.type or element_types.NAME.type
  std::vector<std::string> elements;  ///< names of the elements there
  std::vector<std::string> mounts;    ///< names in the catalogue
  std::optional<Node> catalogue;      ///< file of these, as written; none: that of the places, or the generic one
};

/// True if a table of [parameters] is a choice of mounts, not a range of numbers.
[[nodiscard]] inline bool is_mount_choice(const Node& parameter) {
  return parameter.find("choices") || parameter.find("catalogue");
}

/// The change that puts one of the mounts at all places.
[[nodiscard]] Node change_of(const MountChoice& choice, std::size_t mount);

/// Of the frequencies of a response.
enum class Spacing { automatic, linear, logarithmic };

struct ResponseRequest {
  ChannelSelection selection;
  std::optional<assembly::Band> band;  ///< none: from 0 to 1.3 times the highest natural frequency
  Spacing spacing = Spacing::automatic;
  int points = 1001;       ///< of a linear or logarithmic grid
  std::vector<double> at;  ///< single ω instead of a band [rad/s]
  bool continuous_phase = false;
};

struct PeaksRequest {
  ChannelSelection selection;
  double min_prominence = 1e-6;
  double peak_tolerance = 0.01;  ///< prominence over the adjacent minimum from which the design rule counts a peak
};

/// Largest allowed amplitude of one channel, SI.
struct Limit {
  std::string name;
  double amplitude = 0;
};

/// Most designs of one map.
inline constexpr double most_designs = 1e7;

/// Two numbers of the project and the rules that a design meets or violates.
struct MapRequest {
  DesignAxis x, y;
  std::vector<std::pair<DesignAxis, DesignAxis>> pairs;  ///< a map for each of them, instead of x and y
  std::optional<assembly::Band> band;                    ///< of the amplitudes; none: 0 ≤ ω < ∞
  std::vector<AmplitudeLimit> limits;
  bool limits_of_file = true;        ///< the map has none: take those of the file
  std::vector<std::string> no_peak;  ///< channels that must have no resonance peak at any frequency
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;  ///< of these
  double min_prominence = 1e-6, peak_tolerance = 0.01;                         ///< as of `peaks`
  std::vector<std::string> excitations;                                        ///< empty: all
  std::optional<std::vector<std::string>> cases;  ///< marked on the map; none: all that have both numbers
  bool own_band = false, own_excitations = false, own_peak_shares = false;  ///< the table of the map has these keys
  bool own_no_peak = false;
  std::optional<Requirements> requirements;  ///< what is left of [requirements], see use_requirements
  std::vector<std::string> hold_in;          ///< further cases in which a design has to meet their rules

  /// The request with one of the pairs as x and y.
  [[nodiscard]] MapRequest of_pair(std::size_t pair) const;
  bool operator==(const MapRequest&) const = default;
};

struct Analyses {
  bool modes = false;
  int lowest_modes = 0;  ///< only so many are reported; 0: all
  bool roots = false;
  std::optional<ResponseRequest> response;
  std::optional<PeaksRequest> peaks;
  std::optional<std::vector<std::string>> static_of;
  bool all_rest_states = false;
  bool load_sharing = false;
  std::optional<MapRequest> map;
  std::vector<LimitLineRequest> limit_lines;
  std::vector<std::shared_ptr<const Measurement>> measurements;
  std::vector<Limit> limits;
  std::optional<Requirements> requirements;
  std::vector<DesignAxis> parameters;  ///< [parameters.NAME]
  std::vector<MountChoice> choices;    ///< those that choose mounts
  std::optional<OptimizeRequest> optimize;
  std::vector<Tolerance> tolerances;  ///< [tolerances.NAME]
  std::optional<SampleRequest> sample;
  std::optional<BoxRequest> box;
  // The independent ones: analysis_table.h
  std::optional<OperationAnalysis> operation;
  std::optional<RandomAnalysis> random;
  std::optional<TransientAnalysis> transient;
  std::optional<OrdersAnalysis> orders;
  std::optional<TransmissibilityAnalysis> transmissibility;
  std::optional<PowerAnalysis> power;
  std::optional<ShapesAnalysis> shapes;
  std::optional<SteadyAnalysis> steady;
  std::optional<BackboneAnalysis> backbone;
  std::optional<ShockSpectrumAnalysis> shock_spectrum;
  std::optional<EarthquakeAnalysis> earthquake;
};

/// The independent analyses that are requested, with their names, in the order of their table.
[[nodiscard]] std::vector<std::pair<std::string, const Analysis&>> independent_analyses(const Analyses& request);

}  // namespace trivet::project
