// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"

namespace trivet::study {

class MapJudge;

/// A case as a point on the map, judged from its own model.
struct MapMark {
  std::string name;            ///< empty: the base model
  std::optional<double> x, y;  ///< in the units of the axes; none: the number is not in the file
  bool of_this_model = true;   ///< false: it differs from the model of the map by more than the two numbers
  std::optional<design::JudgedDesign> judged;  ///< none if it could not be computed
  std::string failure;
  bool has_own_rules = false;  ///< its own map has other rules than the one on which it is shown

  [[nodiscard]] bool placed() const { return x && y; }
};

/// The cases that the request lists, or all cases with both numbers.
[[nodiscard]] std::vector<MapMark> map_marks(const project::Project& project, const project::MapRequest& request,
                                             const MapJudge& evaluation, int threads,
                                             const foundation::Progress& progress);

}  // namespace trivet::study
