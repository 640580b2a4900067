// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/contact_frame.h"

namespace trivet::nonlinear {

FrameRates rates_of(const ContactFrame& frame, const Eigen::Vector3d& slope) {
  FrameRates found;
  found.along = frame.normal.dot(slope);
  found.across = frame.on_wall * slope;
  if (frame.curvature == 0) return found;
  const double turns = frame.curvature * frame.tangents.row(0).dot(slope), widens = frame.curvature * found.along;
  found.normal = turns * frame.tangents.row(0);
  found.on_wall.row(0) = -frame.hoop * (widens * frame.tangents.row(0) + turns * frame.normal);
  return found;
}

}  // namespace trivet::nonlinear
