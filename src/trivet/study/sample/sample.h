// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/sampling/exact_statistics.h"
#include "trivet/numerics/sampling/intervals.h"
#include "trivet/numerics/sampling/variance_shares.h"
#include "trivet/project/project.h"
#include "trivet/study/requirements/verdict.h"
#include "trivet/study/sample/drawn_name.h"
#include "trivet/study/sample/file_unit.h"
#include "trivet/study/sample/kept_designs.h"
#include "trivet/study/sample/sampled_band.h"

/// How many of the machines built within the tolerances meet the requirements? Definitions: docs/sample.md.
namespace trivet::study {

inline constexpr double sample_confidence = 0.95;

enum class YieldVerdict {
  met,        ///< with the confidence of the sample the yield is the wanted one or more
  violated,   ///< it is less
  undecided,  ///< the interval contains the wanted one: more designs decide
};

/// Share of the designs that meet something.
struct Yield {
  std::uint64_t met = 0, designs = 0;
  numerics::ConfidenceInterval interval;
  /// From the differences of the replicates; otherwise Clopper and Pearson's, as of random designs.
  bool of_replicates = false;

  /// With the confidence of a sample: the end of the interval; without violations the bound of this side alone.
  [[nodiscard]] double at_least() const { return met == designs ? bound_of_all_met() : interval.from; }
  /// What as many designs show that all meet it. One minus it is what they show if none does.
  [[nodiscard]] double bound_of_all_met() const { return numerics::share_without_failures(designs, sample_confidence); }
  /// How many designs end beside a wanted yield that the interval contains: without violations all of them have to meet
  /// it, otherwise if the share stays. Rounded up to two digits in the latter case; none: more than a sample can have.
  [[nodiscard]] std::optional<double> deciding(double wanted) const;
  [[nodiscard]] YieldVerdict against(double wanted) const {
    if (at_least() >= wanted) return YieldVerdict::met;
    return interval.to < wanted ? YieldVerdict::violated : YieldVerdict::undecided;
  }
};

/// Share of the numbers of an unbounded draw beyond both ends of the range in which the worst design is searched.
inline constexpr double beyond_worst_range = 1e-3;

/// A number of a design.
struct NamedNumber {
  std::string path;
  double value = 0;  ///< as a bare number of the file: SI
  FileUnit unit;
};

/// The worst design of a requirement that a search found, see WorstFound.
struct WorstDesign {
  double margin = 0;
  std::vector<NamedNumber> numbers;  ///< in the base model
  bool is_corner = false, ended = true;
  std::size_t at_ends = 0;      ///< drawn numbers
  std::uint64_t looked_at = 0;  ///< designs
};

/// How it was searched.
struct WorstCaseSearch {
  bool all_corners = false;
  std::uint64_t corners = 0, inside = 0, failed = 0;
  std::string first_failure;
};

/// One requirement in one case, over all designs.
struct SampledRequirement {
  RequirementResult given;  ///< of the design of the file
  Yield yield;              ///< of this requirement alone
  std::uint64_t first = 0;  ///< designs without all requirements met in which it has the least margin
  Spread margin;
  /// Where the margin is limit over value or value over limit, in all designs; SI.
  std::optional<Spread> value;
  std::optional<double> mean, deviation;  ///< of the value; none if it is unbounded in a design
  std::optional<WorstDesign> worst;       ///< if it is requested

  /// A drawn design is worse than the worst one that was searched.
  [[nodiscard]] bool drawn_is_worst() const {
    return worst && margin.extremes.any && margin.extremes.least < worst->margin;
  }
  /// Of the worst design that was searched or drawn; none if none was searched.
  [[nodiscard]] std::optional<double> worst_margin() const {
    if (!worst) return std::nullopt;
    return drawn_is_worst() ? margin.extremes.least : worst->margin;
  }
};

struct SampledCaseResult {
  std::string case_name;
  project::DisplayUnits display;
  std::vector<SampledRequirement> requirements;
  std::vector<SampledBand> bands;                ///< if they are requested
  std::uint64_t in_kernels = 0, one_by_one = 0;  ///< designs judged
  std::string no_kernels;                        ///< why none were judged by kernels
  std::string family;                            ///< how the matrices of these were computed
};

/// A design by its number, and what was drawn for it.
struct NamedDesign {
  std::uint64_t number = 0;
  std::vector<NamedNumber> numbers;
};

/// Drawn numbers that do not depend on the others: a single one, all of a tolerance that draws for each place, or those
/// of tolerances that are correlated with each other.
struct DrawnSet {
  DrawnName name;
  std::vector<std::size_t> draws;
};

/// Shares of the variance of the value of one requirement.
struct RequirementShares {
  std::size_t in_case = 0, requirement = 0;   ///< among those of the sample
  std::vector<numerics::VarianceShare> sets;  ///< per set of drawn numbers; empty: there are none
  std::string reason;                         ///< why there are none
};

/// Which tolerance scatters which value.
struct SampledShares {
  std::vector<DrawnSet> sets;
  std::uint64_t pairs = 0;              ///< of designs, each with one more design for each set
  std::uint64_t left_out = 0;           ///< of these: a design could not be judged, or its value is unbounded
  std::string reason;                   ///< why there are none; empty if there are
  std::vector<RequirementShares> list;  ///< of all requirements
};

/// What a study folder has, after this process has worked on it.
struct StudyProgress {
  std::filesystem::path folder;
  std::uint64_t part = 1, of = 1;
  std::uint64_t designs = 0;              ///< of the whole study
  std::uint64_t chunks = 0, done = 0;     ///< of the whole study; in the folder
  std::uint64_t found = 0, computed = 0;  ///< chunks that were there already, and of this process
  std::vector<std::string> damaged;       ///< files that could not be read: their chunks are computed again
  std::vector<std::string> overlapping;   ///< files with chunks of other files, which are not counted
  bool is_locked = true;                  ///< false: the file system has no locks
  bool ended_early = false;               ///< this process leaves chunks of its part

  [[nodiscard]] bool is_complete() const { return done == chunks; }
};

struct Sample {
  /// Of a study that is not complete: with the number of designs that are there.
  project::SampleRequest request;
  std::vector<project::Tolerance> tolerances;
  std::size_t draws = 0;  ///< numbers drawn for each design
  std::size_t replicates = 1;
  Yield yield;  ///< of all requirements in all cases in which the design has to hold
  std::vector<SampledCaseResult> cases;
  std::uint64_t failed = 0;  ///< designs that have no model or cannot be judged in some case; they do not meet anything
  std::optional<NamedDesign> first_failed;
  std::string first_failure;         ///< its reason
  std::optional<NamedDesign> worst;  ///< the design with the least margin of all
  double worst_margin = 0;
  std::string worst_case;  ///< that has it, with the same deviations from its own numbers; empty: the base model
  KeptDesigns kept;
  std::optional<SampledShares> shares;               ///< if they are requested
  std::optional<WorstCaseSearch> worst_case_search;  ///< the same
  std::optional<StudyProgress> study;                ///< if it is one in a folder
  std::optional<std::size_t> first_of;               ///< designs of [analyses.sample], if only the first are judged
  bool worst_is_left_out = false;                    ///< requested, but models are assembled, see SampleOptions

  /// A design, drawn or searched, violates a requirement or cannot be judged.
  [[nodiscard]] bool any_violates() const;
  /// Of the wanted yield; none: none is wanted.
  [[nodiscard]] std::optional<YieldVerdict> yield_verdict() const {
    return request.yield ? std::optional(yield.against(*request.yield)) : std::nullopt;
  }
};

struct SampleOptions {
  bool shares = false;  ///< also those of the variance, from at most as many designs again
  /// Judge at most so many designs, the first of [analyses.sample], if kernels judge them, or else by assembled models.
  std::size_t most_by_kernels = most_of_all, most_assembled = most_of_all;
  bool worst_of_assembled = true;  ///< search the worst designs, if they are requested, also by assembled models

  static constexpr std::size_t most_of_all = std::numeric_limits<std::size_t>::max();
};

/// Judges the requirements of the cases in which the design has to hold for the designs of [analyses.sample], by
/// default 100,000. All cases have the same designs. The same for any number of threads.
/// @throws foundation::InvalidInput without tolerances or requirements, NotComputable if a requirement cannot be judged
/// in the design of the file
[[nodiscard]] Sample sample(const project::Project& project, const foundation::Progress& progress = {},
                            const SampleOptions& options = {});

}  // namespace trivet::study
