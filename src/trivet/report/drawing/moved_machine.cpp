// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/moved_machine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/assembly/layout.h"
#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/machine_view.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::report {
namespace {

constexpr double least_size = 1e-3;  // of a model whose places all coincide [m]

/// Motion of a place that moves with a body.
Eigen::Vector3d motion_at(const spatial::Vector6& of_pole, const Eigen::Vector3d& from_pole) {
  return of_pole.head<3>() + of_pole.tail<3>().cross(from_pole);
}

/// Where a place of a rigid body gets to.
Eigen::Vector3d turned_place(const Eigen::Vector3d& pole, const spatial::Vector6& motion, const Eigen::Vector3d& at) {
  const Eigen::Vector3d rotation = motion.tail<3>();
  const double angle = rotation.norm();
  const Eigen::Vector3d from_pole = at - pole;
  return pole + motion.head<3>() +
      (angle > 0 ? Eigen::Vector3d(spatial::rotation_about(rotation, angle) * from_pole) : from_pole);
}

/// Calls `use(place, motion)` for all places of a machine.
template <typename Use>
void for_places(const DrawnMachine& machine, const MachineMotion& motion, const Use& use) {
  const auto of_body = [&](std::size_t b, const Eigen::Vector3d& at) {
    use(at, motion_at(motion.bodies[b], at - machine.bodies[b].pose.position));
  };
  for (std::size_t b = 0; b < machine.bodies.size(); ++b) of_body(b, machine.bodies[b].centre);
  for (const DrawnMachine::Solid& solid : machine.solids)
    for (const Eigen::Vector3d& v : solid.surface.vertices) of_body(solid.body, v);
  for (const DrawnMachine::Point& point : machine.points) of_body(point.body, point.at);
  for (std::size_t e = 0; e < machine.elements.size(); ++e) {
    const DrawnMachine::Element& element = machine.elements[e];
    if (element.k_body) of_body(*element.k_body, element.k);
    use(element.n, motion.feet[e]);
  }
}

}  // namespace

MachineMotion motion_of(const modal::Mode& mode, const model::System& system) {
  MachineMotion motion;
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const spatial::Vector6 of_pole = mode.shape.segment<6>(static_cast<Eigen::Index>(6 * b));
    motion.bodies.emplace_back(spatial::both_blocks(system.bodies()[b].pose.rotation) * of_pole);
  }
  const assembly::Layout layout(system.description());
  for (const model::Element& element : system.elements()) {
    if (element.is_foundation) continue;
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();
    if (element.n.body) {
      const Eigen::Vector3d at = model::end_in_ground(system.bodies(), element.n).position;
      foot = motion_at(motion.bodies[*element.n.body], at - system.bodies()[*element.n.body].pose.position);
    } else if (element.n.foundation) {
      const model::OnFoundation& on = *element.n.foundation;
      foot = (on.shape * mode.coordinates.segment(layout.foundation_row(on.foundation), on.shape.cols())).head<3>();
    }
    motion.feet.push_back(foot);
  }
  return motion;
}

MachineMotion motion_of(const response::DeflectionShape& shape, const model::System& system, double phase) {
  const std::complex<double> turn = std::polar(1.0, phase);
  MachineMotion motion;
  for (const response::MovingPlace& body : shape.bodies) motion.bodies.emplace_back((body.motion * turn).real());
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    if (!system.elements()[e].is_foundation) motion.feet.emplace_back((shape.feet[e].motion.head<3>() * turn).real());
  return motion;
}

std::size_t DrawnExcursion::best_view() const {
  constexpr double clearly = 1.001;  // equal but for round-off: the first one
  std::size_t best = 0;
  for (std::size_t view = 1; view < in_plane.size(); ++view)
    if (in_plane[view] > clearly * in_plane[best]) best = view;
  return best;
}

DrawnExcursion drawn_excursion(const DrawnMachine& machine, const MachineMotion& motion) {
  DrawnExcursion found;
  for_places(machine, motion, [&](const Eigen::Vector3d&, const Eigen::Vector3d& u) {
    found.largest = std::max(found.largest, u.norm());
    for (std::size_t view = 0; view < found.in_plane.size(); ++view) {
      const double across = four_views()[view].towards().dot(u);
      found.in_plane[view] += u.squaredNorm() - across * across;
    }
  });
  return found;
}

DrawnMachine moved(DrawnMachine machine, const MachineMotion& motion, double scale, double size) {
  const std::vector<DrawnMachine::Body> rest = machine.bodies;
  const auto with_body = [&](std::size_t b, const Eigen::Vector3d& at) {
    return turned_place(rest[b].pose.position, scale * motion.bodies[b], at);
  };
  for (DrawnMachine::Solid& solid : machine.solids)
    for (Eigen::Vector3d& v : solid.surface.vertices) v = with_body(solid.body, v);
  for (DrawnMachine::Point& point : machine.points) point.at = with_body(point.body, point.at);
  for (std::size_t e = 0; e < machine.elements.size(); ++e) {
    DrawnMachine::Element& element = machine.elements[e];
    const SpringLine line = spring_line(element, size);
    element.n = element.n_body ? with_body(*element.n_body, line.n) : Eigen::Vector3d(line.n + scale * motion.feet[e]);
    element.k = element.k_body ? with_body(*element.k_body, line.k) : line.k;
  }
  for (std::size_t b = 0; b < machine.bodies.size(); ++b) {
    DrawnMachine::Body& body = machine.bodies[b];
    body.centre = with_body(b, body.centre);
    const Eigen::Vector3d rotation = scale * motion.bodies[b].tail<3>();
    if (rotation.norm() > 0)
      body.pose.rotation = spatial::rotation_about(rotation, rotation.norm()) * body.pose.rotation;
    body.pose.position += scale * motion.bodies[b].head<3>();
  }
  machine.excitations.clear();
  return machine;
}

MovedPicture::MovedPicture(const project::Case& variant)
    : rest_(results::drawn_machine(variant)), bounds_(rest_.bounds()), size_(std::max(bounds_.size(), least_size)) {
  rest_.excitations.clear();
  for (const DrawnMachine::Element& element : rest_.elements) {
    const SpringLine line = spring_line(element, size_);
    bounds_.include(line.n);
    bounds_.include(line.k);
  }
  const Eigen::Vector3d room = Eigen::Vector3d::Constant(drawn_motion * size_);
  bounds_.low -= room;
  bounds_.high += room;
}

double MovedPicture::scale(double width, double height, std::size_t view) const {
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < four_views().size(); ++v) {
    if (v > 2 && v != view) continue;
    const PixelPoint extent = extent_in(v);
    most = std::min({most, width / extent.x, height / extent.y});
  }
  return most;
}

double MovedPicture::height(double width, double most) const {
  double extent = 0;
  for (std::size_t v = 0; v < 3; ++v) extent = std::max(extent, extent_in(v).y);
  return std::min(most, scale(width, most, 0) * extent);
}

PixelPoint MovedPicture::extent_in(std::size_t view) const {
  const Eigen::Vector3d extent = bounds_.high - bounds_.low;
  return {four_views()[view].right.cwiseAbs().dot(extent), four_views()[view].up.cwiseAbs().dot(extent)};
}

void MovedPicture::draw(SvgCanvas& canvas, const Box& area, std::size_t view, const MachineMotion& motion,
                        double enlarged, const std::vector<response::MovingPlace>& paths) const {
  const Projection projection{four_views()[view],
                              scale(area.right - area.left, area.bottom - area.top, view),
                              bounds_.centre(),
                              {(area.left + area.right) / 2, (area.top + area.bottom) / 2}};
  draw_faint_machine(canvas, rest_, projection, size_);
  for (const response::MovingPlace& place : paths) {
    constexpr int steps = 48;
    std::vector<PixelPoint> path;
    for (int i = 0; i <= steps; ++i)
      path.push_back(projection.at(response::displaced(place, foundation::two_pi * i / steps, enlarged)));
    canvas.polyline(path, "stroke=\"" + std::string(series_colour(1)) + "\" stroke-width=\"1\"");
  }
  draw_moved_machine(canvas, moved(rest_, motion, enlarged, size_), projection);
}

}  // namespace trivet::report
