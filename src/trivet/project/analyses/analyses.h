// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/assembly/limit_line.h"
#include "trivet/project/analyses/design_axis.h"
#include "trivet/project/analyses/measurement.h"
#include "trivet/project/analyses/mount_choice.h"
#include "trivet/project/analyses/optimize_request.h"
#include "trivet/project/analyses/question.h"
#include "trivet/project/analyses/requirements.h"

namespace trivet::project {

/// Of the frequencies of a response.
enum class Spacing { automatic, linear, logarithmic };

struct ResponseRequest {
  AnswerSelection selection;
  std::optional<assembly::Band> band;  ///< none: from 0 to 1.3 times the highest natural frequency
  Spacing spacing = Spacing::automatic;
  int points = 1001;       ///< of a linear or logarithmic grid
  std::vector<double> at;  ///< single ω instead of a band [rad/s]
  bool continuous_phase = false;
};

struct PeaksRequest {
  AnswerSelection selection;
  double min_prominence = 1e-6;
  double peak_tolerance = 0.01;  ///< prominence over the adjacent minimum from which the design rule counts a peak
};

/// Largest allowed amplitude of one answer, SI.
struct Limit {
  std::string name;
  double amplitude = 0;
};

/// An answer of the response with a user's limit line.
struct LimitLineRequest {
  std::string of;
  assembly::LimitLine line;
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
  std::vector<std::string> no_peak;  ///< answers that must have no resonance peak at any frequency
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
  std::map<std::string, std::shared_ptr<const Question>> questions;  ///< those of question_table.h, by name

  /// A question by its name and type; none if it is not asked.
  template <typename Asked>
  [[nodiscard]] const Asked* find(const std::string& name) const {
    const auto found = questions.find(name);
    return found == questions.end() ? nullptr : dynamic_cast<const Asked*>(found->second.get());
  }
};

}  // namespace trivet::project
