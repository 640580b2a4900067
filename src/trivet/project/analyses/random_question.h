// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/excitation/human_weighting.h"
#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Root mean squares and spectral densities under the random excitations.
struct RandomQuestion : Question {
  std::optional<excitation::Weighting> weighting;  ///< of the accelerations of all requested motions
  std::optional<excitation::ContactPoint>
      contact;  ///< instead: each axis as people feel it there, with the vibration total value
};

}  // namespace trivet::project
