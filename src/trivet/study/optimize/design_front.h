// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"

/// The designs between which only a choice is left: less of one amplitude is more of another. Mathematics:
/// docs/design.md.
namespace trivet::study {

struct FrontObjective {
  std::string name, unit;  ///< a largest amplitude over the band and all deciding cases, SI
  double given = 0;        ///< infinite if an undamped resonance lies in the band
  double least = 0;        ///< of the front
  double most = 0;
};

/// One design: no objective can be made smaller without making another larger, near it.
struct FrontPoint {
  std::vector<double> values;      ///< of the parameters, in their units
  std::vector<double> amplitudes;  ///< of the objectives, SI
  double residual = 0;             ///< of its optimality conditions, as a share of the largest slope
  /// 1 % more of the first objective brings so many percent less of the second; none with three, or at an end.
  std::optional<double> exchange;
};

struct DesignFront {
  std::vector<project::DesignAxis> parameters;
  std::vector<std::optional<double>> given;  ///< values of the file; none if their places differ
  std::vector<FrontObjective> objectives;
  std::vector<FrontPoint> points;   ///< with two objectives by ascending first one
  std::optional<std::size_t> knee;  ///< furthest beyond the line or plane through the ends, towards less of all
  double knee_distance = 0;         ///< of it, with every objective from 0 at its least to 1 at its most
  double unevenness = 1;            ///< longest over shortest distance of neighbours, in these
  std::size_t dominated = 0;        ///< points left out: another one is better in all
  std::size_t coinciding = 0;       ///< points left out: another one is the same
  std::size_t not_found = 0;        ///< points at which no design meets the requirements
  std::size_t evaluations = 0, failed = 0;
  std::string first_failure;
  std::vector<std::string> differenced;  ///< kinds of requirements whose slopes are differences of values
  std::size_t differences = 0;           ///< models solved for these differences, besides `evaluations`
  foundation::Problems warnings;         ///< of the parameters, besides those of the model
};

/// Searches `front` of [analyses.optimize].
/// @throws foundation::InvalidInput without parameters; NotComputable if no design meets the requirements
[[nodiscard]] DesignFront design_front(const project::Project& project, const foundation::Progress& progress = {});

/// The point that --write sets: the knee, or the one in the middle.
[[nodiscard]] std::size_t chosen_point(const DesignFront& front);

/// The changes of the file that set a point.
[[nodiscard]] std::vector<project::Node> front_changes(const DesignFront& front, std::size_t point);

}  // namespace trivet::study
