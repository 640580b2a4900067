// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/spatial/rigid_motion.h"

#ifdef WRONG
using Argument = trivet::spatial::Wrench;
#else
using Argument = trivet::spatial::Displacement;
#endif

trivet::spatial::Screw screw_of(const Argument& argument) {
  return trivet::spatial::screw(argument, 1, Eigen::Vector3d::Zero());
}
