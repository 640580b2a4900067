// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/plausibility/rules.h"
#include "trivet/response/machinery/load_sharing.h"
#include "trivet/response/steady/at_rest.h"

namespace trivet::plausibility {
namespace {

using foundation::standard_gravity;
/// Usual magnitudes of a gravity vector [m/s²], from a small moon to a centrifuge.
constexpr double least_gravity = 0.3, most_gravity = 150;
/// Share of its magnitude from which gravity counts as pointing along an axis.
constexpr double along_axis = 0.7;
/// Distance outside the polygon of mounts that counts, as a share of its size.
constexpr double outside_by = 0.02;
/// Tension of a mount that counts, as a share of the mean load.
constexpr double lifted = 0.02;
/// Larger systems are not solved for this check.
constexpr std::size_t most_bodies = 40;

Eigen::Vector3d in_ground(const model::Body& body, const Eigen::Vector3d& at) {
  return body.pose.position + body.pose.rotation * at;
}

struct GravityUnit {
  double length;
  double within;
  double factor;
  const char* words;
};
constexpr GravityUnit gravity_units[] = {
    {1, 0.05, standard_gravity, "the number was meant in g"},
    {9806.65, 0.03, 1e-3, "the number was meant in mm/s²"},
    {980.665, 0.03, 1e-2, "the number was meant in cm/s²"},
    {32.174, 0.01, 0.3048, "the number was meant in ft/s²"},
};

/// Mean depth of the mounts of a body below its centre of mass, along `down`, in sizes of the body; empty for fewer
/// than two mounts.
std::optional<double> depth_of_mounts(const model::System& system, const BodyPicture& picture,
                                      const Eigen::Vector3d& down) {
  const model::Body& body = system.bodies()[picture.body];
  double sum = 0;
  int mounts = 0;
  for (const Attachment& a : picture.attachments)
    if (a.elastic()) sum += (body.pose.rotation * (a.at - body.mass.centre)).dot(down), ++mounts;
  if (mounts < 2) return std::nullopt;
  return sum / mounts / mass_radius(body.mass);
}

/// Corners of the convex hull of points in a plane, counter-clockwise.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::ranges::sort(points,
                    [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  const auto turn = [](const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
  };
  std::vector<Eigen::Vector2d> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

/// Largest distance of a point outside an edge of a hull / size of the hull; ≤ 0 inside, empty if the hull is nearly a
/// line.
std::optional<double> outside_of(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& p) {
  constexpr double flat = 0.02;
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  if (hull.size() < 3) return std::nullopt;
  double size = 0, worst = -1e300, width = 1e300;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d& a = hull[i];
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - a;
    const Eigen::Vector2d out = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
    double across = 0;
    for (const Eigen::Vector2d& q : hull) {
      across = std::max(across, -(q - a).dot(out));
      size = std::max(size, (q - a).norm());
    }
    width = std::min(width, across);
    worst = std::max(worst, (p - a).dot(out));
  }
  if (!(width > flat * size)) return std::nullopt;
  return worst / size;
}

bool carries_weight(const model::Element& element) {
  return element.type != "link" && element.type != "stay" && element.type != "beam" && element.type != "damper";
}

/// Mounts on the ground of a machine that stands on them: all are below the common centre of mass. Otherwise empty.
std::vector<std::size_t> standing_on(const model::System& system, const Eigen::Vector3d& down,
                                     Eigen::Vector3d& centre) {
  double mass = 0;
  centre.setZero();
  for (const model::Body& body : system.bodies()) {
    mass += body.mass.mass;
    centre += body.mass.mass * in_ground(body, body.mass.centre);
  }
  centre /= mass;
  std::vector<std::size_t> mounts;
  for (const std::size_t e : response::mounts(system)) {
    const model::Element& element = system.elements()[e];
    if (!carries_weight(element) || !(elements::stiffness(element.law).block<3, 3>(6, 6).trace() > 0)) continue;
    const Eigen::Vector3d at = in_ground(system.bodies()[*element.k.body], element.k.at);
    if (!((at - centre).dot(down) > 0)) return {};
    mounts.push_back(e);
  }
  return mounts;
}

/// Beams, links and stays to the ground that also carry part of the weight.
std::vector<std::size_t> propped_by(const model::System& system, const Eigen::Vector3d& down) {
  constexpr double some = 0.01;  // of the stiffness along gravity
  const auto along = [&](std::size_t e) {
    const model::Element& element = system.elements()[e];
    const Eigen::Vector3d d =
        element.k.axes.transpose() * system.bodies()[*element.k.body].pose.rotation.transpose() * down;
    return d.dot(elements::stiffness(element.law).block<3, 3>(6, 6) * d);
  };
  double all = 0;
  for (const std::size_t e : response::mounts(system)) all += along(e);
  std::vector<std::size_t> found;
  for (const std::size_t e : response::mounts(system))
    if (!carries_weight(system.elements()[e]) && along(e) > some * all) found.push_back(e);
  return found;
}

/// Load of each mount; empty if the weight does not reach the ground, or if the system is too large.
std::optional<response::LoadSharing> sharing_of(const model::System& system, const assembly::AssembledOnce& assembled) {
  const auto& gravity = system.description().gravity;
  if (!gravity || gravity->isZero(0) || system.bodies().size() > most_bodies) return std::nullopt;
  try {
    return response::load_sharing(system, *assembled);
  } catch (
      const foundation::NotComputable&) {  // free in some direction, or attached to bodies only: no load is checked
    return std::nullopt;
  }
}

void find_tipping(const model::System& system, const assembly::AssembledOnce& assembled, Suspicions& found) {
  const Eigen::Vector3d down = system.description().gravity->normalized();
  Eigen::Vector3d centre;
  const std::vector<std::size_t> mounts = standing_on(system, down, centre);
  if (mounts.empty()) return;
  const Eigen::Vector3d e1 = down.unitOrthogonal(), e2 = down.cross(e1);
  const auto flat = [&](const Eigen::Vector3d& p) { return Eigen::Vector2d(e1.dot(p), e2.dot(p)); };
  std::vector<Eigen::Vector2d> places;
  for (const std::vector<std::size_t>& bearing : {mounts, propped_by(system, down)})
    for (const std::size_t e : bearing) {
      const model::Element& element = system.elements()[e];
      places.push_back(flat(in_ground(system.bodies()[*element.k.body], element.k.at)));
    }
  const model::Body& heaviest = *std::ranges::max_element(
      system.bodies(), [](const model::Body& a, const model::Body& b) { return a.mass.mass < b.mass.mass; });
  if (const auto outside = outside_of(places, flat(centre)); outside && *outside > outside_by) {
    found.push_back({"tipping", "bodies." + heaviest.name + ".center_of_mass",
                     fmt::format("the centre of mass is outside the mounts by {:.3g} % of their size", 100 * *outside),
                     "the centre of mass of a machine on mounts is usually between them",
                     "check the centre of mass and the positions of the mounts, their signs and pole"});
    return;
  }
  const auto sharing = sharing_of(system, assembled);
  if (!sharing || sharing->mounts.empty()) return;
  const double mean = sharing->bearing_in_total / static_cast<double>(sharing->mounts.size());
  const response::MountLoad* worst = nullptr;
  for (const response::MountLoad& mount : sharing->mounts) {
    const bool counts =
        std::ranges::any_of(mounts, [&](std::size_t e) { return system.elements()[e].name == mount.element; });
    if (counts && mount.bearing < -lifted * mean && (!worst || mount.bearing < worst->bearing)) worst = &mount;
  }
  if (worst)
    found.push_back(
        {"lift-off", "elements." + worst->element,
         fmt::format("under the static load it pulls down with {}", foundation::prefixed(-worst->bearing, "N")),
         fmt::format("mounts below a machine are compressed, here by {} on average", foundation::prefixed(mean, "N")),
         "check the centre of mass, constant forces and moments, and the stiffnesses"});
}

}  // namespace

void judge_gravity(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  const auto& given = system.description().gravity;
  if (!given || given->isZero(0)) return;
  const double length = given->norm();
  const std::string finding = fmt::format("({:.6g}, {:.6g}, {:.6g}) m/s²", given->x(), given->y(), given->z());
  for (const GravityUnit& unit : gravity_units)
    if (std::abs(length / unit.length - 1) < unit.within) {
      found.push_back({"gravity", "gravity", finding, "gravity is 9.81 m/s²",
                       fmt::format("it would be {:.4g} m/s² if {}", unit.factor * length, unit.words)});
      return;
    }
  if (length < least_gravity || length > most_gravity) {
    found.push_back(
        {"gravity", "gravity", finding,
         fmt::format("gravity is 9.81 m/s² on earth, {:.3g} … {:.3g} m/s² elsewhere", least_gravity, most_gravity),
         "check its unit"});
    return;
  }
  const Eigen::Vector3d down = *given / length;
  if (!(down.y() > along_axis || down.z() > along_axis)) return;
  // Upwards in the usual frames. If z points down in the frame, gravity points from a standing machine to its mounts.
  double deepest = -1;
  for (const BodyPicture& picture : pictures)
    deepest = std::max(deepest, depth_of_mounts(system, picture, down).value_or(-1));
  constexpr double clearly = 0.1;
  if (deepest > clearly) return;
  found.push_back({"gravity", "gravity", finding, "gravity points down, and z (or y) usually up",
                   "it would point down with the other sign"});
}

void judge_balance(const model::System& system, const assembly::AssembledOnce& assembled, Suspicions& found) {
  const auto& gravity = system.description().gravity;
  const bool guided = std::ranges::any_of(system.bodies(), [](const model::Body& body) {
    return body.is_node ||                                       // the mounts may be under a frame
        std::ranges::find(body.free, false) != body.free.end();  // constraints hold it too
  });
  if (gravity && !gravity->isZero(0) && !guided && system.bodies().size() <= most_bodies)
    find_tipping(system, assembled, found);
}

}  // namespace trivet::plausibility
