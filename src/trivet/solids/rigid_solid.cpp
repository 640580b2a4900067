// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/rigid_solid.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <set>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/part_size.h"
#include "trivet/solids/closed_surface.h"
#include "trivet/solids/step_file.h"
#include "trivet/solids/stl_file.h"

namespace trivet::solids {

namespace {

using foundation::Problems;
using std::numbers::pi;

enum class Zero { refused, allowed };

void check_length(Problems& problems, const char* name, double length, Zero zero = Zero::refused) {
  if (foundation::is_part_size(length) || (zero == Zero::allowed && length == 0)) return;
  if (length > 0 && std::isfinite(length)) {
    problems.error(name, fmt::format("{:.6g} m", length), foundation::part_size_rule,
                   "check the unit and the power of ten");
    return;
  }
  problems.error(name, std::isnan(length) ? "not given" : fmt::format("{:.6g} m", length),
                 zero == Zero::allowed ? "a diameter of a cone must be ≥ 0" : "a length of a solid must be > 0",
                 "give it as a length with its unit");
}

void check(const Box& box, Problems& problems) {
  check_length(problems, "length_x", box.length_x);
  check_length(problems, "length_y", box.length_y);
  check_length(problems, "length_z", box.length_z);
}

void check(const Cylinder& cylinder, Problems& problems) {
  check_length(problems, "diameter", cylinder.diameter);
  check_length(problems, "length", cylinder.length);
}

void check(const Tube& tube, Problems& problems) {
  check_length(problems, "outer_diameter", tube.outer_diameter);
  check_length(problems, "inner_diameter", tube.inner_diameter);
  check_length(problems, "length", tube.length);
  if (tube.inner_diameter >= tube.outer_diameter)
    problems.error("inner_diameter",
                   fmt::format("{:.6g} m, outer_diameter = {:.6g} m: wall {:.6g} m", tube.inner_diameter,
                               tube.outer_diameter, (tube.outer_diameter - tube.inner_diameter) / 2),
                   "a tube's inner diameter must be below its outer diameter",
                   "exchange the two, or use a cylinder if it has no bore");
}

void check(const Sphere& sphere, Problems& problems) { check_length(problems, "diameter", sphere.diameter); }

void check(const Cone& cone, Problems& problems) {
  check_length(problems, "start_diameter", cone.start_diameter, Zero::allowed);
  check_length(problems, "end_diameter", cone.end_diameter, Zero::allowed);
  check_length(problems, "length", cone.length);
  if (cone.start_diameter == 0 && cone.end_diameter == 0)
    problems.error("end_diameter", "both diameters are 0 m", "one end of a cone must have a diameter > 0",
                   "give the diameter of the wide end");
}

VolumeIntegrals symmetric(double volume, double xx, double yy, double zz) {
  return {volume, Eigen::Vector3d::Zero(), Eigen::Vector3d(xx, yy, zz).asDiagonal()};
}

VolumeIntegrals integrals_of(const Box& b) {
  const double v = b.length_x * b.length_y * b.length_z;
  return symmetric(v, v * b.length_x * b.length_x / 12, v * b.length_y * b.length_y / 12,
                   v * b.length_z * b.length_z / 12);
}

VolumeIntegrals integrals_of(const Tube& t) {
  const double outer = t.outer_diameter / 2, inner = t.inner_diameter / 2;
  const double v = pi * (outer - inner) * (outer + inner) * t.length;
  const double across = v * (outer * outer + inner * inner) / 4;
  return symmetric(v, across, across, v * t.length * t.length / 12);
}

VolumeIntegrals integrals_of(const Cylinder& c) { return integrals_of(Tube{c.diameter, 0, c.length}); }

VolumeIntegrals integrals_of(const Sphere& s) {
  const double r = s.diameter / 2, v = 4 * pi / 3 * r * r * r;
  return symmetric(v, v * r * r / 5, v * r * r / 5, v * r * r / 5);
}

/// With r(z) = m + d·z/L over −L/2 … L/2, m the mean and d the difference of the end radii: V = π L (m² + d²/12),
/// ∫z dV = π L² m d/6, ∫z² dV = π L³ (m²/12 + d²/80), ∫x² dV = π L (m⁴ + m²d²/2 + d⁴/80)/4.
VolumeIntegrals integrals_of(const Cone& c) {
  const double m = (c.start_diameter + c.end_diameter) / 4, d = (c.end_diameter - c.start_diameter) / 2, l = c.length;
  VolumeIntegrals cone;
  cone.volume = pi * l * (m * m + d * d / 12);
  cone.centre.z() = pi * l * l * m * d / 6 / cone.volume;
  const double across = pi * l / 4 * (m * m * m * m + m * m * d * d / 2 + d * d * d * d / 80);
  const double along = pi * l * l * l * (m * m / 12 + d * d / 80) - cone.volume * cone.centre.z() * cone.centre.z();
  cone.second_moment = Eigen::Vector3d(across, across, along).asDiagonal();
  return cone;
}

}  // namespace

Problems problems(const Primitive& primitive) {
  Problems found;
  std::visit([&](const auto& shape) { check(shape, found); }, primitive);
  return found;
}

VolumeIntegrals integrals(const Primitive& primitive) {
  foundation::refuse_errors(problems(primitive));
  return std::visit([](const auto& shape) { return integrals_of(shape); }, primitive);
}

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

void check_positive(Problems& problems, const char* key, double value, const char* unit, const char* remedy) {
  if (value > 0 && std::isfinite(value)) return;
  problems.error(key, std::isnan(value) ? "not given" : fmt::format("{:.6g} {}", value, unit),
                 fmt::format("a {} must be > 0", key), remedy);
}

void check_part(const Part& part, const KnownMass& known, Problems& problems) {
  const bool has_mass = !std::isnan(part.mass), has_density = !std::isnan(part.density);
  if (has_mass && has_density)
    problems.error("mass", fmt::format("{:.6g} kg together with density", part.mass),
                   "the volume gives one of the two from the other", "remove one of them");
  if (has_mass) check_positive(problems, "mass", part.mass, "kg", "give it as in mass = \"120 kg\"");
  else if (has_density || std::isnan(known.whole))
    check_positive(problems, "density", part.density, "kg/m³",
                   "give it as in density = \"7850 kg/m^3\", or the mass of the solid");
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

/// What a part without its own mass weighs before it is scaled to the mass of the whole.
double weight(const Part& part, double volume) { return (std::isnan(part.density) ? 1 : part.density) * volume; }

/// Factor on the densities of parts without a mass of their own, so that the whole has its mass.
double density_factor(const std::vector<Part>& parts, const std::vector<VolumeIntegrals>& volumes,
                      const KnownMass& known, Problems& problems) {
  if (std::isnan(known.whole)) return 1;
  check_positive(problems, "mass", known.whole, "kg", "give the mass of solids and parts together");
  double fixed = 0, shared = 0;
  std::size_t with_density = 0, sharing = 0;
  for (const spatial::MassProperties& lump : known.lumps) fixed += lump.mass;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (std::isnan(parts[i].mass)) {
      shared += weight(parts[i], volumes[i].volume);
      ++sharing;
      with_density += std::isnan(parts[i].density) ? 0 : 1;
    } else fixed += parts[i].mass;
  }
  const std::string whole = fmt::format("{:.6g} kg", known.whole);
  if (sharing == 0)
    problems.error("mass", whole + ", and every solid has its own mass",
                   "solids without a mass of their own share the mass of the whole", "remove one of the masses");
  else if (with_density != 0 && with_density != sharing)
    problems.error("mass",
                   fmt::format("{} shared by {} solids, of which {} have a density", whole, sharing, with_density),
                   "the mass is shared by density times volume, or by volume alone",
                   "give each of these solids a density or a mass, or none of them");
  else if (!(known.whole > fixed))
    problems.error("mass", fmt::format("{}, and solids and parts with their own mass have {:.6g} kg", whole, fixed),
                   "the whole is heavier than some of its parts", "check the masses and their units");
  return (known.whole - fixed) / shared;
}

/// Mass, its centre and its central second moment M = ½ tr(J) I − J, as of a volume of density 1.
VolumeIntegrals as_volume(const spatial::MassProperties& lump) {
  const Eigen::Matrix3d& inertia = lump.inertia_about_centre;
  return {lump.mass, lump.centre, inertia.trace() / 2 * Eigen::Matrix3d::Identity() - inertia};
}

}  // namespace

Expected<RigidSolid> rigid_solid(const std::vector<Part>& parts, const KnownMass& known, const Progress& progress) {
  RigidSolid solid;
  Problems problems;
  if (parts.empty()) problems.error("solids", "no part", "a body of solids has at least one part", "add a part");
  std::vector<VolumeIntegrals> volumes;
  for (const Part& part : parts) {
    Problems found, remarks;
    check_part(part, known, found);
    const Expected<VolumeIntegrals> own = std::visit(Measure{progress, remarks}, part.shape);
    if (own) volumes.push_back(placed(*own, part.pose));
    else found.add(own.error());
    add_prefixed(solid.remarks, part.name, std::move(remarks));
    add_prefixed(problems, part.name, std::move(found));
  }
  if (problems.has_errors()) return tl::unexpected(problems);
  const double factor = density_factor(parts, volumes, known, problems);
  if (problems.has_errors()) return tl::unexpected(problems);
  VolumeIntegrals total;  // of mass: density times volume
  for (const spatial::MassProperties& lump : known.lumps) total = sum(total, as_volume(lump));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const VolumeIntegrals& here = volumes[i];
    const double mass = std::isnan(parts[i].mass) ? factor * weight(parts[i], here.volume) : parts[i].mass;
    const double density = mass / here.volume;
    const spatial::MassProperties properties = mass_properties(here, density);
    if (!representable(properties))
      problems.error(parts[i].name + (std::isnan(parts[i].mass) ? ".density" : ".mass"),
                     fmt::format("mass {:.3g} kg of volume {:.3g} m³", mass, here.volume),
                     "mass and inertia must be numbers > 0", "check the units of the lengths");
    total = sum(total, {mass, here.centre, density * here.second_moment});
    solid.parts.push_back({parts[i].name, here.volume, properties});
  }
  if (problems.has_errors()) return tl::unexpected(problems);
  solid.properties = mass_properties(total, 1);
  return solid;
}

}  // namespace trivet::solids
