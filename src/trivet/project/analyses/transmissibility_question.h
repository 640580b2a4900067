// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/harmonic_force.h"
#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Force on the ground over one force excitation, or motion of the wanted bodies and points over a unit motion of the
/// whole ground.
struct TransmissibilityQuestion : BandQuestion {
  std::string force;           ///< the excitation; empty: a motion of the ground
  model::Direction direction;  ///< of a motion
};

}  // namespace trivet::project
