// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/study/optimize/design_summary.h"
#include "trivet/study/requirements/verdict.h"
#include "trivet/study/sample/sample.h"

/// The best design over some parameters: `trivet optimize`. Mathematics: docs/design.md.
namespace trivet::study {

class SharedWork;

/// One parameter of the search.
struct OptimizedParameter {
  project::DesignAxis axis;
  std::optional<double> given;  ///< value of the file, in the unit of the axis; none if its places differ
  double best = 0;              ///< in the unit of the axis
  double least = 0, most = 0;   ///< over all starts that reached the same objective
  bool at_bound = false;
  /// The design with this parameter alone changed by 1 % of its range, or of its logarithm.
  struct Step {
    double value = 0;                 ///< in the unit of the axis
    std::optional<double> objective;  ///< as Optimization::objective_after; none if it cannot be computed
    bool met = false;                 ///< every requirement is met
  };
  std::optional<Step> below, above;  ///< none outside the range, or if nothing limits the optimum
  bool idle = false;                 ///< no margin and no objective near deciding depends on it there
};

/// A requirement, or an objective, that holds the optimum.
struct ActiveRequirement {
  std::size_t result_case = 0;   ///< index in Optimization::after
  std::string words;             ///< "machine.z ≤ 1 mm", or "the largest amplitude of machine.z"
  std::string words_for_people;  ///< the same with its bound at the level that people read
  bool minimized = false;        ///< a minimised amplitude, no requirement
  double multiplier = 0;         ///< the objective gains this many percent if the bound is relaxed by 1 %
};

/// A curve that is to have no peak, and how far the optimum is from having one.
struct GonePeak {
  std::size_t result_case = 0;  ///< index in Optimization::after
  std::string name;
  double measure = 0;            ///< (x + x₀) f′/f, below 0
  double angular_frequency = 0;  ///< where a peak would appear first [rad/s]
};

/// Another local optimum.
struct OtherOptimum {
  std::vector<double> values;  ///< of the parameters
  double objective = 0;
  int starts = 0;  ///< that ended there
};

/// A requirement of a set that cannot be met.
struct Conflict {
  std::size_t result_case = 0;  ///< index in Optimization::after
  std::string words, words_for_people;
  double factor = 0;   ///< by which its bound is missed at the design with the largest least margin
  double without = 0;  ///< largest least margin of the others without it; infinite if nothing limits it
};

/// A minimised amplitude.
struct MinimizedAmplitude {
  std::size_t result_case = 0;  ///< index in Optimization::after
  std::string name, unit;       ///< SI
  std::optional<double> limit;
  double before = 0, after = 0;
};

/// Mounts that were chosen together with the numbers.
struct OptimizedMounts {
  std::vector<project::MountChoice> choices;
  std::vector<std::size_t> chosen;               ///< number of the mount of each choice
  std::size_t combinations = 0, considered = 0;  ///< all; those with the numbers of the file judged completely
  std::size_t optimized = 0;                     ///< those whose numbers were optimised
  std::optional<model::Price> price;             ///< of all mounts, if it was minimised
  std::optional<model::Price> price_before;      ///< of the given ones; none if a mount has none in this currency
  bool some_met = false;  ///< if the price was minimised: a combination that was optimised meets every requirement
  /// One of the next best combinations.
  struct Other {
    std::vector<std::size_t> mounts;
    double objective = 0;  ///< as Optimization::objective_after, from the given numbers alone; or the price
  };
  std::vector<Other> others;
};

/// What the machines built within the tolerances have of a design.
struct SampledDesign {
  /// The least margin that the wanted share of the machines keeps, or the worst ones found have.
  double kept = 0;
  std::optional<Yield> yield;  ///< of all requirements in all cases that decide; none: the worst case is wanted
  std::uint64_t failed = 0;    ///< of the sampled, or looked at for the worst: without a model, or not judged
  std::string first_failure;
};

/// What a requirement keeps of its margin at the optimum.
struct KeptMargin {
  std::size_t result_case = 0;  ///< index in Optimization::after
  std::string words, words_for_people;
  double nominal = 0, kept = 0;  ///< of the design itself, of the machines
  bool has_reserve = true;       ///< false: the margin jumps, so the search cannot keep a reserve for it
};

/// A search within tolerances.
struct RobustOptimum {
  std::optional<double> wanted;  ///< yield; none: the worst case
  SampledDesign given, nominal;  ///< the design of the file; the optimum without tolerances
  SampledDesign found;
  std::vector<KeptMargin> margins;
  std::uint64_t designs = 0, seed = 0;  ///< sampled for each yield, with numbers that the search has not used
  int rounds = 0;                       ///< searches, each with the reserves that the last optimum needs
  std::size_t looked_at = 0;  ///< designs around the optimum whose machines were judged to raise the margin they keep
  bool is_raised = false;     ///< false: it was not tried
  bool settled = false;       ///< the last ones need the same reserves
  bool held = false;          ///< the interval of the yield is not below the wanted one; or no worst margin below 1
};

/// How a search went; within tolerances the first one, which ignores them and starts anywhere in the ranges.
struct SearchStatistics {
  int starts = 0, agreeing = 0;             ///< `agreeing` of the starts reached the same objective; 0 if cut short
  int finished = 0;                         ///< if cut short: so many of the starts came to their end
  int stuck = 0;                            ///< starts that found no usable design
  std::vector<OtherOptimum> others;         ///< the best three
  std::size_t evaluations = 0, failed = 0;  ///< designs computed, and those of them that have no valid model or values
  std::string first_failure;                ///< why, the first in the alphabet
  std::vector<std::string> differenced;     ///< kinds of requirements whose slopes are differences of values
  std::size_t differences = 0;              ///< models solved for these differences, besides `evaluations`
  std::size_t looked_at = 0;                ///< designs judged by kernels over designs before the search
};

struct Optimization {
  std::vector<OptimizedParameter> parameters;
  std::optional<RobustOptimum> robust;
  std::optional<OptimizedMounts> mounts;
  bool minimizes = false;  ///< amplitudes; false: the largest least margin
  /// Amplitudes were to be minimised, but no design met the requirements: it is that with their largest least margin.
  bool falls_short = false;
  std::vector<MinimizedAmplitude> minimized;
  project::Minimized minimized_kind = project::Minimized::amplitude;
  std::vector<double> weights;             ///< of these, if their sum was minimised
  std::string objective_unit;              ///< SI, of amplitudes without limits; otherwise shares of these
  std::optional<double> objective_before;  ///< least margin, or largest amplitude or share of a limit
  double objective_after = 0;
  bool feasible = false;                   ///< every requirement is met, within the tolerances too if they count
  std::vector<CaseVerdict> before, after;  ///< of the cases in which the design has to hold
  std::vector<DesignSummary> summaries_before, summaries_after;  ///< of these
  std::vector<ActiveRequirement> active;
  std::vector<GonePeak> gone_peaks;  ///< if nothing else limits the optimum
  double residual = 0;               ///< of the optimality conditions, as a share of the largest slope
  std::string no_slopes;             ///< why these conditions were not computed
  std::vector<Conflict> conflicts;   ///< if no design meets all requirements
  bool cut_short = false;            ///< ended by `enough`: the best design so far
  SearchStatistics search;
  foundation::Problems warnings;  ///< of the parameters and of what was found, besides those of the model
  /// How these were interpolated, and why cases were not: "a sum of 40 terms …", "case cold: loss factors …"
  std::vector<std::string> families, no_families;
};

/// Searches [analyses.optimize] of a project, or the largest least margin over all its parameters.
/// @param enough  true if the search is to end with the best design so far; called between designs, on any thread
/// @param shared  looks and climbs together with other processes; null: alone
/// @throws foundation::InvalidInput without parameters or requirements; NotComputable if no design can be judged, or if
/// all results that are required to be small are zero
[[nodiscard]] Optimization optimization(const project::Project& project, const foundation::Progress& progress = {},
                                        const std::function<bool()>& enough = {}, SharedWork* shared = nullptr);

/// The changes of the file that set the optimum.
[[nodiscard]] std::vector<project::Node> optimum_changes(const Optimization& found);

}  // namespace trivet::study
