// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/contact_friction.h"

#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"

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

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

ContactFriction::ContactFriction(elements::RubbingFriction law, const std::vector<elements::ElasticForce>& contact,
                                 double at_rest)
    : law_(law), at_rest_(at_rest), pressed_(false) {
  for (const elements::ElasticForce& one : contact) contact_.add(one);
  assert(law.stiffness > 0 && law.coefficient >= 0 && "travels are forces over the stiffness");
  pressed_ = limit(0, 0).value > 0;
}

ContactFriction::ContactFriction(elements::RubbingFriction law, const elements::DistanceForce& ring,
                                 const Vector3d& at_rest)
    : ContactFriction(law, elements::only<elements::ElasticForce>(ring.laws), ring.distance(at_rest) - ring.length) {
  const double touches = elements::kink_distances(ring).front();
  ring_ = Ring{(ring.offset + at_rest).head<2>(), pressed_ ? ring.distance(at_rest) : touches};
}

ContactFrame ContactFriction::frame(const Vector3d& deviations) const {
  ContactFrame found;
  if (!ring_) {
    found.along = deviations.x();
    found.across = deviations.tail<2>();
    return found;
  }
  const Vector2d place = ring_->at_rest + deviations.head<2>();
  const double distance = place.norm();
  found.along = distance - ring_->at_rest.norm();
  found.across = {0, deviations.z()};
  if (!(distance > 0)) return found;  // no direction; a ring is open there
  // Place p = p₀ + δ from the axis, ρ = |p|: along = ρ − ρ₀, across = (R atan2 p, z), hoop = R/ρ, curvature = 1/ρ;
  // the normal is p/ρ, the tangents are square to it and along the axis.
  const Vector2d outwards = place / distance;
  found.across.x() = ring_->radius * std::atan2(outwards.y(), outwards.x());
  found.hoop = ring_->radius / distance;
  assert(found.hoop > 0 && "a ring that rubs has a radius");
  found.curvature = 1 / distance;
  found.normal << outwards.transpose(), 0;
  found.tangents << -outwards.y(), outwards.x(), 0, 0, 0, 1;
  found.on_wall = found.tangents;
  found.on_wall.row(0) *= found.hoop;
  return found;
}

Vector2d ContactFriction::travel(const Vector2d& from, const Vector2d& to) const {
  Vector2d found = to - from;
  if (ring_) found.x() = std::remainder(found.x(), foundation::two_pi * ring_->radius);
  return found;
}

ContactFriction::Limit ContactFriction::limit(double deviation, double rate) const {
  const DeviationLaw::Force pressing = contact_.at(at_rest_ + deviation, rate);
  const double share = pressing.force < 0 ? -law_.coefficient : law_.coefficient;
  // L = μ |P| of the force P along the contact, and its derivatives by the deviation and the rate along it.
  assert(!(share * pressing.force < 0));
  return {share * pressing.force, share * pressing.by_deviation, share * pressing.by_rate};
}

Matrix3d ContactFriction::own_stiffness() const {
  if (!pressed_) return Matrix3d::Zero();
  const ContactFrame::Rows rows = frame(Vector3d::Zero()).on_wall;
  return law_.stiffness * rows.transpose() * rows;
}

}  // namespace trivet::nonlinear
