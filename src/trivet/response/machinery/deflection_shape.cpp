// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/deflection_shape.h"

#include <algorithm>
#include <cmath>

#include "trivet/spatial/rigid_motion.h"

namespace trivet::response {
namespace {

using Vector6c = Eigen::Matrix<std::complex<double>, 6, 1>;

/// The motion in ground axes.
Vector6c turned(const Eigen::Matrix3d& rotation, const Vector6c& motion) {
  return spatial::both_blocks(rotation).cast<std::complex<double>>() * motion;
}

MovingPlace end_place(const model::System& system, const std::string& name, const model::End& end,
                      const Vector6c& motion) {
  const spatial::Pose pose = model::end_in_ground(system.bodies(), end);
  return {name, pose.position, turned(pose.rotation, motion), end.body};
}

}  // namespace

DeflectionShape deflection_shape(const model::System& system, const assembly::Assembled& assembled,
                                 const assembly::Loading& loading, double angular_frequency) {
  return deflection_shape(system, assembled, steady_motions(assembled, loading, {angular_frequency}).front());
}

DeflectionShape deflection_shape(const model::System& system, const assembly::Assembled& assembled,
                                 const SteadyMotion& motion) {
  DeflectionShape shape;
  shape.angular_frequency = motion.angular_frequency;
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const model::Body& body = system.bodies()[b];
    const Vector6c q = assembled.layout.of_body(b, motion.free);
    shape.bodies.push_back({body.name, body.pose.position, turned(body.pose.rotation, q), b});
    for (const model::Point& point : body.points)
      shape.points.push_back(
          {body.name + "." + point.name, body.pose.position + body.pose.rotation * point.at,
           turned(body.pose.rotation, spatial::rigid_motion(point.at).cast<std::complex<double>>() * q), b});
  }
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const Eigen::VectorXcd d = element_motion(assembled.elements[e], motion);
    shape.feet.push_back(end_place(system, element.name + ".foot", element.n, d.head<6>()));
    shape.heads.push_back(end_place(system, element.name + ".head", element.k, d.segment<6>(6)));
  }
  for (const auto* places : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
    for (const MovingPlace& place : *places)
      shape.largest_excursion = std::max(shape.largest_excursion, excursion(place.motion.head<3>()));
  return shape;
}

double excursion(const Eigen::Vector3cd& translation) {
  const std::complex<double> square = translation.cwiseProduct(translation).sum();
  return std::sqrt(0.5 * (translation.squaredNorm() + std::abs(square)));
}

Eigen::Vector3d displaced(const MovingPlace& place, double phase, double scale) {
  const Eigen::Vector3cd now = place.motion.head<3>() * std::polar(scale, phase);
  return place.position + now.real();
}

}  // namespace trivet::response
