// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/study/optimize/design_objective.h"
#include "trivet/study/sample/sample_run.h"

/// The margins that the machines built after a design keep. Mathematics: docs/robust.md.
namespace trivet::study {

inline constexpr std::size_t searched_machines = 16384;  ///< judged for a design

/// What the machines within the tolerances have of a design.
struct Kept {
  using Margins = std::vector<std::vector<double>>;  ///< per case and requirement
  Margins nominal, kept;
  Margins alone;  ///< that the wanted share keeps in each requirement alone, or the worst ones have
  /// Margin that the wanted share keeps in all requirements, or the worst ones have.
  double least = foundation::infinity;
  std::uint64_t failed = 0;  ///< designs looked at for the worst ones: without a model, or they cannot be judged
  std::string first_failure;
};

/// Which machines of a search are above the bounds of all requirements at once.
struct Aim {
  double searched = 1;      ///< share of the machines; more than wanted if the sample has less than the search
  double wanted = 1;        ///< share of the machines
  bool minimizes = false;   ///< they only have to meet the requirements; false: a margin as large as possible counts
  double share = 1;         ///< above the bounds; less than wanted where most requirements have room to spare
  bool is_adapted = false;  ///< to the design before
};

/// What the wanted share of the machines keeps. Changes the share above the bounds if the aim is adapted: by how many
/// machines are below what counts, of a design that has the reserves of these bounds.
[[nodiscard]] Kept kept_by_share(const SampleRun& run, Aim& aim, const foundation::Progress& progress);

/// The margin that a share of the machines keeps in all requirements; 0 if it is not above `least`, which is known
/// once enough machines are below.
[[nodiscard]] double kept_least(const SampleRun& run, double wanted, double least,
                                const foundation::Progress& progress);

/// The machines of any design within the ranges, as one family over the numbers of the design and those that are drawn
/// for a machine: for a search that judges the machines of many designs.
class MachineFamily {
 public:
  /// @param run  of a design within the ranges; both are used by the family
  MachineFamily(const SampleRun& run, const DesignSpace& space);

  /// As kept_least: machines that the family does not prove are assembled. None if there is no family, or these are
  /// many.
  [[nodiscard]] std::optional<double> kept_least(const Eigen::VectorXd& shares, double wanted, double least,
                                                 const foundation::Progress& progress) const;

 private:
  const SampleRun& run_;
  const DesignSpace& space_;
  std::vector<DesignBatch> batches_;  ///< per case; empty: there is no family
};

/// What the worst machines found have.
[[nodiscard]] Kept kept_by_worst(const SampleRun& run, const foundation::Progress& progress);

/// False for a margin that is no number, or falls to nothing: it has no distance that could be kept.
[[nodiscard]] bool has_reserve(double nominal, double kept);

/// Rounds that need the same reserves within this have settled, ln(margin).
inline constexpr double same_reserves = 1e-3;
/// Reserves with which the margins of a design are what its machines keep. They are larger by `same_reserves`, so that
/// the last optimum has what it needs.
[[nodiscard]] DesignObjective::Reserves reserves_for(const Kept& at);
/// Of ln(margin); ∞ if there are none of one.
[[nodiscard]] double largest_difference(const DesignObjective::Reserves& a, const DesignObjective::Reserves& b);

}  // namespace trivet::study
