// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/excitation/modal_combination.h"
#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Largest answers to an earthquake by its response spectrum.
struct EarthquakeQuestion : Question {
  excitation::ResponseSpectrum spectrum;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
};

}  // namespace trivet::project
