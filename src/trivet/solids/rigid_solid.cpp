// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/rigid_solid.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "trivet/foundation/index.h"
#include "trivet/solids/closed_surface.h"
#include "trivet/solids/step_file.h"
#include "trivet/solids/stl_file.h"

namespace trivet::solids {
namespace {

using foundation::Expected;
using foundation::Problems;
using foundation::Progress;

constexpr double orthonormal = 1e-9;

/// Integrals of a shape; warnings go to `remarks`.
struct Measure {
  const Progress& progress;
  Problems& remarks;

  template <typename Shape>
  Expected<VolumeIntegrals> operator()(const Shape& shape) const {
    const Problems found = problems(Primitive(shape));
    if (found.has_errors()) return tl::unexpected(found);
    return integrals(Primitive(shape));
  }

  Expected<VolumeIntegrals> operator()(const StlSolid& stl) const {
    if (!(stl.length_unit > 0) || !std::isfinite(stl.length_unit)) {
      Problems found;
      found.error("unit", std::isnan(stl.length_unit) ? "not given" : fmt::format("{:.6g} m", stl.length_unit),
                  "an STL file does not state its length unit, which must be > 0",
                  "give the unit of the file, \"mm\" for most");
      return tl::unexpected(found);
    }
    const auto surface = read_stl(stl.file, progress);
    if (!surface) return tl::unexpected(surface.error());
    const auto enclosed = enclosed_volume(*surface);
    if (!enclosed) return tl::unexpected(enclosed.error());
    remarks.add(enclosed->remarks);
    const VolumeIntegrals& v = enclosed->integrals;
    return VolumeIntegrals{v.volume * std::pow(stl.length_unit, 3), v.centre * stl.length_unit,
                           v.second_moment * std::pow(stl.length_unit, 5)};
  }

  Expected<VolumeIntegrals> operator()(const StepSolid& step) const {
    const auto volumes = step_volumes(step.file, progress);
    if (!volumes) return tl::unexpected(volumes.error());
    Problems found;
    VolumeIntegrals total;
    std::set<int> taken;
    for (const int number : step.solids) {
      if (number < 1 || to_size(number) > volumes->size())
        found.error("solids", fmt::format("{}; {} holds {} solids", number, step.file.string(), volumes->size()),
                    fmt::format("solids are numbered from 1 to {}", volumes->size()), "name existing solids");
      else if (!taken.insert(number).second)
        found.error("solids", fmt::format("{} is named twice", number), "each solid counts once", "name it once");
      else total = sum(total, (*volumes)[number - 1]);
    }
    if (found.has_errors()) return tl::unexpected(found);
    if (step.solids.empty())
      for (const VolumeIntegrals& volume : *volumes) total = sum(total, volume);
    return total;
  }
};

void check_part(const Part& part, Problems& problems) {
  if (!(part.density > 0) || !std::isfinite(part.density))
    problems.error("density", std::isnan(part.density) ? "not given" : fmt::format("{:.6g} kg/m³", part.density),
                   "a density must be > 0", "give it as in density = \"7850 kg/m^3\"");
  const Eigen::Matrix3d& r = part.pose.rotation;
  if (!((r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= orthonormal) ||
      !(r.col(0).cross(r.col(1)).dot(r.col(2)) > 0))
    problems.error("orientation", "is not a rotation", "its three axes must be orthonormal and right-handed",
                   "give it by axis and angle");
  if (!part.pose.position.allFinite())
    problems.error("position", "is not finite", "a position is three finite lengths",
                   "give it as lengths with their unit");
}

void add_prefixed(Problems& problems, const std::string& name, Problems found) {
  for (foundation::Problem& problem : found.list()) problem.subject = name + "." + problem.subject;
  problems.add(found);
}

/// Very small or very large lengths can pass the checks above and still overflow or underflow.
bool representable(const spatial::MassProperties& p) {
  return std::isnormal(p.mass) && p.centre.allFinite() && p.inertia_about_centre.allFinite() &&
      std::isnormal(p.inertia_about_centre.trace());
}

}  // namespace

Expected<RigidSolid> rigid_solid(const std::vector<Part>& parts, const Progress& progress) {
  RigidSolid solid;
  Problems problems;
  if (parts.empty()) problems.error("solids", "no part", "a body of solids has at least one part", "add a part");
  VolumeIntegrals total;  // of mass: density times volume
  for (const Part& part : parts) {
    Problems found, remarks;
    check_part(part, found);
    const Expected<VolumeIntegrals> own = std::visit(Measure{progress, remarks}, part.shape);
    if (!own) found.add(own.error());
    if (!found.has_errors()) {
      const VolumeIntegrals here = placed(*own, part.pose);
      const spatial::MassProperties properties = mass_properties(here, part.density);
      if (!representable(properties))
        found.error("density", fmt::format("mass {:.3g} kg of volume {:.3g} m³", properties.mass, own->volume),
                    "mass and inertia must be numbers > 0", "check the units of the lengths");
      total = sum(total, {properties.mass, here.centre, part.density * here.second_moment});
      solid.parts.push_back({part.name, own->volume, properties});
    }
    add_prefixed(solid.remarks, part.name, std::move(remarks));
    add_prefixed(problems, part.name, std::move(found));
  }
  if (problems.has_errors()) return tl::unexpected(problems);
  solid.properties = mass_properties(total, 1);
  return solid;
}

}  // namespace trivet::solids
