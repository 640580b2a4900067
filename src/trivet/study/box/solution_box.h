// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/study/requirements/verdict.h"
#include "trivet/study/sample/sample.h"

/// In which ranges may the numbers of the tolerances be so that every requirement is met? Definitions: docs/box.md.
namespace trivet::study {

/// By how much margins exceed 1 at the ends of a box: more than round-off, so that its designs are on the safe side.
inline constexpr double box_reserve = 1e-9;
/// The step by which an end is tried further outward, a share of the range of the tolerance (or of the range found, if
/// that is wider).
inline constexpr double box_step = 1e-6;

/// Ends without a model beyond keep this share of the distance from the number in the file. There, matrices have no
/// entries near 0 that kernels would not reproduce.
inline constexpr double box_distance_kept = 0.01;

/// What stops an end of a range.
enum class BoxStop {
  requirement,    ///< a design just beyond violates it, or only just meets it where its margin hardly changes
  no_model,       ///< designs beyond cannot be built or judged
  most,           ///< nothing up to the largest range that is tried
  not_determined  ///< the search was given up: every range further out that was tried has violations
};
[[nodiscard]] const char* name(BoxStop stop);

/// One number of the model.
struct BoxNumber {
  std::string path;
  std::string si;  ///< its SI unit, "1" for pure numbers
  FileUnit unit;
  double given = 0, from = 0, to = 0;  ///< SI
};

/// One end of the range of a tolerance.
struct BoxEnd {
  double draw = 0;   ///< ratio to the number in the file, or deviation from it in SI
  double times = 0;  ///< distance from the number in the file over that of the same end of the tolerance
  BoxStop stop = BoxStop::most;
  std::size_t in_case = 0, requirement = 0;  ///< of BoxStop::requirement
  std::string reason;                        ///< of BoxStop::no_model
  std::vector<NamedNumber> beyond;           ///< a design that stops it: with this end one step further
  bool is_corner = false;                    ///< that design has all numbers at ends
};

/// The range of the numbers of one tolerance.
struct BoxRange {
  std::string name;
  bool relative = false;  ///< draws are ratios
  std::size_t draws = 1;  ///< numbers that vary independently in this range
  BoxEnd lower, upper;
  std::vector<BoxNumber> numbers;
  /// The whole range of the tolerance is within it; of an unbounded one that of the worst case (docs/sample.md).
  [[nodiscard]] bool has_tolerance() const { return lower.times >= 1 && upper.times >= 1; }
};

/// A requirement of one case in the designs that were judged afterwards.
struct BoxRequirement {
  RequirementResult given;  ///< of the design of the file
  double least_margin = 0;  ///< of all these designs; infinite if nothing limits it
  bool at_corner = false;   ///< in which it occurs
};

struct BoxCase {
  std::string case_name;
  project::DisplayUnits display;
  std::vector<BoxRequirement> requirements;
  std::uint64_t in_kernels = 0, one_by_one = 0;  ///< designs judged
  std::string no_kernels;                        ///< why none were judged by kernels
};

/// The designs that were judged after the ranges were found.
struct BoxCheck {
  bool all_corners = false;
  std::uint64_t corners = 0, inside = 0;
  std::uint64_t models = 0;      ///< of these, also judged by assembled models
  std::uint64_t violations = 0;  ///< designs that violate a requirement or cannot be judged
  int repeats = 0;               ///< how often violations were found, and the ranges were determined again without them
};

struct SolutionBox {
  project::BoxRequest request;
  std::vector<BoxRange> ranges;
  std::vector<BoxCase> cases;
  BoxCheck check;
  std::uint64_t searched = 0;  ///< designs judged by the search
  std::size_t draws = 0;       ///< numbers of a design that vary
  /// As many times as wide as in the file all tolerances may be together.
  double all_times = 0;
  bool correlated = false;  ///< the tolerances have correlations, which do not restrict a box
};

/// Ranges around the numbers of the file in which every requirement of the cases in which the design has to hold is
/// met: all ends move outward together, in proportion to the tolerances, until one is stopped; the others go on. So the
/// least of the ranges is as wide as it can be, then the next one, and so on; and no end can be moved further alone.
/// @throws foundation::InvalidInput without tolerances or requirements, NotComputable if the design of the file
/// violates a requirement or cannot be judged
[[nodiscard]] SolutionBox solution_box(const project::Project& project, const foundation::Progress& progress = {});

}  // namespace trivet::study
