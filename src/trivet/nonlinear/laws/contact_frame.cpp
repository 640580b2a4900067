// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/contact_frame.h"

#include <cassert>

namespace trivet::nonlinear {

FrameRates rates_of(const ContactFrame& frame, const Eigen::Vector3d& slope) {
  FrameRates found;
  found.along = frame.normal.dot(slope);
  found.across = frame.on_wall * slope;
  if (frame.curvature == 0) return found;
  // n' = κ (t · δ') t and t' = −κ (t · δ') n around the ring; the row R/ρ t of the travel also shrinks by κ ρ'.
  assert(frame.hoop > 0);
  const double turns = frame.curvature * frame.tangents.row(0).dot(slope), widens = frame.curvature * found.along;
  found.normal = turns * frame.tangents.row(0);
  found.on_wall.row(0) = -frame.hoop * (widens * frame.tangents.row(0) + turns * frame.normal);
  return found;
}

}  // namespace trivet::nonlinear
