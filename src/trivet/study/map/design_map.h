// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/design/crossings.h"
#include "trivet/design/design_outcome.h"
#include "trivet/design/drawn_grid.h"
#include "trivet/design/margin_lines.h"
#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"

namespace trivet::study {

class MapJudge;
class SharedWork;

/// A case as a point on the map, judged from its own model.
struct MapMark {
  std::string name;            ///< empty: the base model
  std::optional<double> x, y;  ///< in the units of the axes; none: the number is not in the file
  bool of_this_model = true;   ///< false: it differs from the model of the map by more than the two numbers
  std::optional<design::JudgedDesign> judged;  ///< none if it could not be computed
  std::string failure;
  bool has_own_rules = false;  ///< its own map has other rules than the one on which it is shown
  bool decides = true;         ///< the design has to hold in this case; false: requirements are not binding in it

  [[nodiscard]] bool placed() const { return x && y; }
};

/// The cases that the request lists, or all cases with both numbers.
[[nodiscard]] std::vector<MapMark> map_marks(const project::Project& project, const project::MapRequest& request,
                                             const MapJudge& evaluation, int threads,
                                             const foundation::Progress& progress);

/// Numbers of designs that one rule governs.
struct RuleShare {
  std::size_t feasible = 0;    ///< feasible designs with the least margin from this rule
  std::size_t infeasible = 0;  ///< the same for infeasible designs
};

struct DesignMap {
  std::string case_name;          ///< case of the model
  bool in_hertz = false;          ///< the file gives the band of the amplitudes in Hz, as the words of its JSON do then
  project::DisplayUnits display;  ///< of its sentences for people
  project::MapRequest request;
  design::MapGrid grid;
  std::vector<design::MapRule> rules;
  std::vector<design::DesignOutcome> outcomes;    ///< at the nodes, row by row
  std::vector<RuleShare> shares;                  ///< per rule
  std::size_t feasible_designs = 0, unknown = 0;  ///< numbers of designs
  design::MapContours feasible;                   ///< margin ≥ 1, crossings searched on the exact peaks
  double boundary_tolerance = 0;                  ///< of the crossings, as a share of each axis
  design::DrawnGrid drawn;                        ///< the designs that pictures show
  std::vector<design::MarginLine> margin_lines;   ///< straight between drawn designs
  std::optional<std::size_t> best;                ///< see best_design
  std::size_t without_bound = 0;                  ///< number of designs that no rule limits
  std::size_t equals = 0;                         ///< number of designs as good as the best
  std::size_t steep = 0;                          ///< see steep_neighbours
  design::BandCrossings band_crossings;           ///< infeasible designs between feasible ones
  std::vector<MapMark> marks;
  design::EvaluationReport report;
  foundation::Problems warnings;  ///< see map_warnings

  [[nodiscard]] design::DesignPoint point(std::size_t design) const;
};

struct MapOptions {
  int nx = 0, ny = 0;  ///< instead of those of the request
  design::EvaluationOptions evaluation;
  SharedWork* shared = nullptr;  ///< with other processes; null: alone
};

/// Judges every design of the grid, refines the boundary of the feasible region between neighbours, and judges the
/// cases.
/// @throws foundation::NotComputable if no design at all has a model, with the reason
[[nodiscard]] DesignMap design_map(const project::Project& project, const project::Case& variant,
                                   const project::MapRequest& request, const MapOptions& options = {},
                                   const foundation::Progress& progress = {});

/// One map for each pair of the request.
[[nodiscard]] std::vector<DesignMap> design_maps(const project::Project& project, const project::Case& variant,
                                                 const project::MapRequest& request, const MapOptions& options = {},
                                                 const foundation::Progress& progress = {});

/// Does a run compute a map of this case? For the base model if its file requests one; for a case if its map differs
/// from that of the base model: other numbers, rules or frequencies. A case with only another model is at most a point
/// on the map of the base model.
[[nodiscard]] bool has_own_map(const project::Project& project, const project::Case& variant);

}  // namespace trivet::study
