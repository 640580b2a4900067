// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"

namespace trivet::model {

void check_body(const Body& body, foundation::Problems& problems);
/// Checks that the preloads of elements balance the weight of the bodies.
void check_preloads(const Description& description, foundation::Problems& problems);
/// Warns if the ground moves in directions in which constraints hold a body in space.
void check_guides(const Description& description, foundation::Problems& problems);

/// Warns of bodies on which no element ends, in a model that has elements.
void check_loose_bodies(const Description& description, foundation::Problems& problems);
/// Checks relative motions, sections and clearances, after directions of nodes are left out.
void check_observations(const Description& description, foundation::Problems& problems);
void check_element(const Description& description, const Element& element, foundation::Problems& problems);

}  // namespace trivet::model
