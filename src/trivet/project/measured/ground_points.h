// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "trivet/project/measured/ground_mobility.h"

namespace trivet::project {

/// Ground points under the elements on one foundation, each compliant in its own directions.
struct GroundPoints {
  std::vector<int> directions;  ///< of an impedance; the same at every point
  spatial::Vector6 mass = spatial::Vector6::Zero();
  model::Element impedance;                        ///< from the rigid ground to a point
  std::shared_ptr<const GroundMobility> mobility;  ///< then it takes the place of the impedance
  std::map<std::string, std::size_t>
      points;  ///< element and its point of the mobility; empty: all elements have the first
  struct Placed {
    std::size_t point = 0;
    model::End end;
    std::string name;
  };
  std::vector<Placed> placed;  ///< points that elements are on
};

/// Puts end N of an element on a ground point of its own, and adds the element that joins the point to the ground.
void add_ground_point(GroundPoints& ground, const std::string& element, model::Description& description);

/// Adds the couplings between the points of a mobility that elements are on.
void add_couplings(const GroundPoints& ground, model::Description& description);

}  // namespace trivet::project
