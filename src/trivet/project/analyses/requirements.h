// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/model/harmonic_force.h"
#include "trivet/model/system.h"
#include "trivet/project/analyses/analysis.h"
#include "trivet/project/text/level.h"

namespace trivet::project {

/// Largest allowed amplitude of one result, SI.
struct AmplitudeLimit {
  std::string name;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  double amplitude = 0;
  std::optional<assembly::Band> band;                   ///< of its own, if it has one
  std::optional<std::vector<std::string>> excitations;  ///< of its own, if it has them
  std::optional<assembly::Band> speed;                  ///< of a shaft, whose orders then drive it one by one
  /// Keys that lead to its number in the file; an item of a list by its place from 0: {"limits", "machine.z"}.
  std::vector<std::string> place = {};
  /// At which the file gives it; `amplitude` is that of one harmonic at this level. None: zero-to-peak, without a word.
  std::optional<Level> level = {};

  /// True if it is judged in the band and under the excitations of all limits.
  [[nodiscard]] bool has_common_scope() const { return !band && !excitations && !speed; }
  bool operator==(const AmplitudeLimit&) const = default;
};

[[nodiscard]] inline Level level_of(const AmplitudeLimit& limit) { return limit.level.value_or(Level::amplitude); }

/// How little of a force reaches the ground, or of a motion of the ground a place: an entry of `isolation`.
struct Isolation {
  std::vector<std::string> forces;  ///< harmonic ones on bodies; empty without `of`: all
  std::vector<std::string> of;      ///< bodies and points that a motion of the ground reaches; empty: forces
  model::Direction base;            ///< of that motion
  std::vector<assembly::Band> at;   ///< [rad/s]; from = to: one frequency; empty: see isolated_at
  double transmitted = 1;           ///< largest allowed transmissibility, > 0
  bool in_decibels = false;         ///< it was given as a level

  [[nodiscard]] bool is_of_base() const { return !of.empty(); }
  bool operator==(const Isolation&) const = default;
};

/// What a design has to meet: the table [requirements]. Formulas: docs/design.md.
struct Requirements {
  std::optional<assembly::Band>
      band;  ///< of the amplitudes and limit lines; none: that of the response, else 0 ≤ ω < ∞
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;  ///< of `no_peak`
  std::vector<std::string> excitations;                                        ///< harmonic ones; empty: all
  std::vector<AmplitudeLimit> limits;                                          ///< of amplitudes in the band
  std::vector<std::string> no_peak;                     ///< results that must have no resonance peak at any frequency
  double min_prominence = 1e-6, peak_tolerance = 0.01;  ///< as of `peaks`
  std::vector<std::string> limit_lines;                 ///< names in [limit_lines]
  std::vector<assembly::Band> avoided;                  ///< without natural frequencies [rad/s]
  double separation = 0;     ///< least ratio of neighbouring natural frequencies, ≥ 1; 0: not required
  double damping_ratio = 0;  ///< least one of every oscillating root, < 1; 0: not required
  struct Decoupling {
    std::string body;
    double least = 0;  ///< 0 … 1
    bool operator==(const Decoupling&) const = default;
  };
  std::vector<Decoupling> decoupling;
  std::vector<AmplitudeLimit> rms;      ///< under the random excitations
  std::vector<AmplitudeLimit> largest;  ///< magnitude over the transient
  std::vector<AmplitudeLimit> statics;  ///< magnitude under gravity and the constant forces
  bool no_jump = false;                 ///< one stable steady motion at every frequency of the band
  /// Not of the file: a search first judges steady motions without seeking those that are not connected, which takes
  /// most of the time of `no_jump` and can only lower its margins.
  bool connected_only = false;
  bool no_contact = false;                  ///< no steady motion closes a gap
  std::vector<AmplitudeLimit> steady;       ///< magnitude over all stable steady motions
  std::vector<Isolation> isolation;         ///< of forces from the ground, or of places from its motion
  bool mount_load = false;                  ///< every catalogue mount within its load and deflection
  std::optional<model::Price> price;        ///< largest sum over the catalogue mounts
  double mass = 0;                          ///< largest sum over them [kg]; 0: not required
  std::vector<std::string> hold_in = {""};  ///< cases in which a design has to hold; "" is the base model

  [[nodiscard]] bool is_about_steady_motion() const { return no_jump || no_contact || !steady.empty(); }

  /// True if nothing is required.
  [[nodiscard]] bool is_empty() const {
    return limits.empty() && no_peak.empty() && limit_lines.empty() && avoided.empty() && separation == 0 &&
        damping_ratio == 0 && decoupling.empty() && rms.empty() && largest.empty() && statics.empty() &&
        isolation.empty() && !mount_load && !price && mass == 0 && !is_about_steady_motion();
  }
  bool operator==(const Requirements&) const = default;
};

}  // namespace trivet::project
