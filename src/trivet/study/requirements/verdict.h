// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/study/analyses/load_case.h"
#include "trivet/study/analyses/operation_types.h"
#include "trivet/study/explain/stated_words.h"
#include "trivet/study/requirements/requirement_kind.h"

/// Does a machine meet its requirements, which one governs, and by what margin? Formulas: docs/design.md.
namespace trivet::study {

/// A requirement in words, in SI.
struct RequirementWords {
  std::string judged;  ///< "largest machine.seat.z"; everything if there is no bound
  std::string bound;   ///< "≤ 0.5 mm", "within \"severity\"", or empty
  std::string scope;   ///< where it holds: " in 5 … 12 Hz"

  RequirementWords(std::string all = {}) : judged(std::move(all)) {}  // NOLINT: words without a bound are words
  RequirementWords(const char* all) : judged(all) {}                  // NOLINT
  RequirementWords(std::string of, std::string limit, std::string where = {})
      : judged(std::move(of)), bound(std::move(limit)), scope(std::move(where)) {}

  /// "largest machine.seat.z ≤ 0.5 mm in 5 … 12 Hz"
  [[nodiscard]] std::string text() const { return judged + (bound.empty() ? "" : " " + bound) + scope; }
  bool operator==(const RequirementWords&) const = default;
};

/// One requirement with its value in one case.
struct RequirementResult {
  RequirementKind kind = RequirementKind::amplitude;
  std::string subject;  ///< the result, body or element that is judged; empty: the whole system
  RequirementWords words;
  std::string line = {};  ///< name of the limit line
  /// The line where it is nearest. `value` is the share of it.
  struct OnLine {
    double limit = 0;  ///< [unit]
    std::string unit;  ///< SI
    bool rms = true;   ///< root mean square; otherwise zero-to-peak
    bool operator==(const OnLine&) const = default;
  };
  std::optional<OnLine> on_line = {};
  std::string unit;                         ///< SI, of `allowed` and `value`
  double allowed = 0;                       ///< bound: largest, or smallest where more is better
  std::optional<double> value;              ///< none: not judged, see `reason`; infinite if unbounded
  std::optional<double> angular_frequency;  ///< at which the value occurs [rad/s]
  std::optional<double> time;               ///< at which it occurs [s]
  double margin = 0;          ///< 1 on the limit, more if the requirement is met, infinite if nothing limits it
  int direction = 2;          ///< of a mount's load: 0 … 2 for x, y, z of the mount
  std::string detail;         ///< "mode 3 and 4", "across its axis: not judged"
  std::string reason;         ///< why it is not judged
  bool misses_speed = false;  ///< no limit holds at a speed of the machine: part of a verdict, not of a search
  std::vector<std::string>
      place;  ///< of a limit: keys that lead to its number in the file, see project::AmplitudeLimit
  std::optional<assembly::Band> speed;  ///< of the machine at which it holds [rad/s]; from = to: a single speed
  /// Of a limit, as the file gives it. Of `operation`: which number of all orders is judged.
  std::optional<project::Level> level_of_limit = {};

  /// A place that may decide the margin: a maximum of the curve or an end of its band, a mode, two neighbouring modes.
  struct Candidate {
    double margin = 0;
    double angular_frequency = 0;  ///< [rad/s]
    double minimum_at = 0;         ///< of a forbidden peak: its higher adjacent minimum, or near 0 [rad/s]
    int mode = 0;  ///< its number; the lower one of two; of a damping ratio that of the root in modal::Roots::list
    bool below = false;  ///< of avoided frequencies: the mode is below the window, or nearer to its lower end
  };
  std::vector<Candidate> candidates;  ///< for a search; empty where a single value decides
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;  ///< of curves and rms
  std::vector<std::string> excitations;                                        ///< of these; empty: all
  assembly::Band band;                                                         ///< of curves; from = to: one frequency
  /// The curve of an isolation: of a force, or of a motion of the ground.
  struct Transmitted {
    std::string force;          ///< empty: of `of` over a motion of the ground
    std::string of;             ///< body or point
    model::Direction base;      ///< of the motion of the ground
    std::size_t direction = 0;  ///< of a rotating force: along which axis of its ellipse
    bool operator==(const Transmitted&) const = default;
  };
  double order = 0;                        ///< of a shaft, which drives the curve; 0: harmonic excitations do
  std::optional<Transmitted> transmitted;  ///< none: the curve is that of `subject` under `excitations`

  [[nodiscard]] bool met() const { return value && margin >= 1; }
  /// `allowed` of an amplitude, zero-to-peak; of an rms √2 times it, to compare with √Σ|y_k|² of several orders.
  /// @pre `operation`: it has a level
  [[nodiscard]] double allowed_amplitude() const {
    assert(kind != RequirementKind::operation || level_of_limit);
    return kind == RequirementKind::operation ? allowed / project::level_factor(*level_of_limit) : allowed;
  }
  /// Level of `allowed` and `value`: "0-p" of harmonic amplitudes, "rms" of root mean squares, that of the file of
  /// limits at a speed; else empty.
  [[nodiscard]] const char* level() const;
  /// Its bound is the text of `allowed`, not another number or a name.
  [[nodiscard]] bool has_bound_in_units() const;
  /// The words in SI with the level of the bound as data have it: "machine.seat.z ≤ 3.96 mm/s 0-p".
  [[nodiscard]] std::string words_at_level() const;
  /// Level that people read of an amplitude: that of [display] or of the file, else the usual one; none of all others.
  [[nodiscard]] std::optional<project::Level> level_for_people(const project::DisplayUnits& display) const;
  /// The words with the bound at this level: "machine.seat.z ≤ 2.8 mm/s rms".
  [[nodiscard]] std::string words_for_people(const project::DisplayUnits& display) const;
};

/// The requirement that governs an element.
struct ElementVerdict {
  std::string element;
  std::size_t governing = 0;  ///< of the results of the case
  double share = 0;           ///< of the limit that the element takes, 1/margin: infinite with no margin left at all
};

/// All requirements of one case.
struct CaseVerdict {
  std::string case_name;
  project::DisplayUnits display;  ///< of its tables
  bool decides = true;            ///< the design has to hold in this case
  std::vector<RequirementResult> results;
  std::optional<assembly::Band> common_band;  ///< of limits and limit lines without one of their own [rad/s]
  std::optional<std::size_t> governing;       ///< of the judged ones, that with the least margin
  std::vector<ElementVerdict> elements;       ///< those with requirements of their own
  StatedWords cause;                          ///< of a governing amplitude or peak: mode, element and what changes it
  foundation::Problems warnings;
  LoadCase load_case;                        ///< what it contributes to the envelope
  std::optional<OperationResult> operation;  ///< at the speeds of the machine, if the file has them

  [[nodiscard]] std::size_t not_judged() const;
  [[nodiscard]] bool met() const;  ///< every requirement is judged and met
};

struct Verdict {
  std::vector<CaseVerdict> cases;  ///< base model first
  Envelope envelope;               ///< of the static results over all cases

  /// Every requirement is met in every case in which the design has to hold.
  [[nodiscard]] bool met() const;
  /// The case with the least margin among those; none if nothing was judged.
  [[nodiscard]] std::optional<std::size_t> governing_case() const;
};

/// True if `run` gives the case a verdict: it has requirements, clearances or limits at the speeds of the machine.
[[nodiscard]] bool is_judged_in_a_run(const project::Case& variant);

/// True if the case has requirements, clearances or limits of any kind, of its own or from the base model.
[[nodiscard]] bool has_something_to_judge(const project::Case& variant);

/// Names of the cases in which the design has to hold: those of `hold_in`, as each case has it. If the base model has
/// no requirements, it and every case with something to judge, of its own or from the base model.
[[nodiscard]] std::vector<std::string> cases_to_hold(const project::Project& project);

/// Judges one case. @param hold_in  names of the cases in which the design has to hold
[[nodiscard]] CaseVerdict case_verdict(const project::Case& variant, const std::vector<std::string>& hold_in,
                                       const foundation::Progress& progress = {});

/// Judges the base model and all cases. Requirements that cannot be judged have the reason.
/// @throws foundation::InvalidInput if the file has neither requirements nor limits nor clearances
[[nodiscard]] Verdict verdict(const project::Project& project, const foundation::Progress& progress = {});

}  // namespace trivet::study
